// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contents beside surfaces: volumes, assemblies, annotations, backgrounds.
 */

#ifndef AirlightTestContentOthers_h
#define AirlightTestContentOthers_h

#include "AirlightTestContent.h"

#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeAxesActor.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFollower.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLookupTable.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropAssembly.h"
#include "vtkProperty2D.h"
#include "vtkScalarBarActor.h"
#include "vtkSkybox.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace airlight_test
{
// A ball of density in a cube of half width 1.5.
vtkSmartPointer<vtkImageData> MakeDensities();

void AddVolume(Scene& scene, vtkVolumeMapper* mapper, bool shade);

template <typename Mapper>
void AddVolume(Scene& scene, bool shade)
{
  vtkNew<Mapper> mapper;
  AddVolume(scene, mapper, shade);
}

void AddAssemblies(Scene& scene);

void AddFollower(Scene& scene);

void AddBillboard(Scene& scene);

// All that is drawn over the picture.
void AddAnnotations(Scene& scene);

void AddAxes(Scene& scene);

void AddSkybox(Scene& scene);

void AddGradient(Scene& scene);

void AddTexturedBackground(Scene& scene);
}

#endif
