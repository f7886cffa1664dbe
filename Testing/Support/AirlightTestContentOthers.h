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

namespace airlighttest
{
//------------------------------------------------------------------------------
// A ball of density in a cube of half width 1.5.
inline vtkSmartPointer<vtkImageData> MakeDensities()
{
  const int n = 24;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetSpacing(3.0 / (n - 1), 3.0 / (n - 1), 3.0 / (n - 1));
  image->SetOrigin(-1.5, -1.5, -1.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < n * n * n; ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    voxel[i] = static_cast<unsigned char>(255.0 * std::max(0.0, 1.0 - r / 1.5));
  }
  return image;
}

inline void AddVolume(Theatre& theatre, vtkVolumeMapper* mapper, bool shade)
{
  mapper->SetInputDataObject(MakeDensities());
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0.0, 0.0, 0.2, 0.9);
  colours->AddRGBPoint(255.0, 1.0, 0.5, 0.1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(255.0, 0.5);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
  property->SetInterpolationTypeToLinear();
  property->SetShade(shade);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  theatre.Renderer->AddVolume(volume);
  // Before and inside it.
  theatre.Add(MakeSphere(0.4), 1.0, 0.5, 0.2);
  theatre.Add(MakeSphere(0.3), -0.8, 0.0, 1.6);
}

template <typename Mapper>
void AddVolume(Theatre& theatre, bool shade)
{
  vtkNew<Mapper> mapper;
  AddVolume(theatre, mapper, shade);
}

//------------------------------------------------------------------------------
inline void AddAssemblies(Theatre& theatre)
{
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkPropAssembly> props;
  for (int i = 0; i < 4; ++i)
  {
    const auto actor = Scene::MakeActor(MakeSphere(0.5));
    actor->SetPosition(i - 1.5, i % 2, 0.5 * i);
    actor->GetProperty()->SetOpacity(i == 3 ? 0.5 : 1.0);
    i < 2 ? assembly->AddPart(actor) : props->AddPart(actor);
  }
  assembly->SetScale(1.2);
  assembly->RotateZ(30.0);
  theatre.Renderer->AddActor(assembly);
  theatre.Renderer->AddActor(props);
}

inline void AddFollower(Theatre& theatre)
{
  vtkNew<vtkFollower> follower;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeSquare(0.8));
  follower->SetMapper(mapper);
  follower->SetCamera(theatre.Renderer->GetActiveCamera());
  follower->SetPosition(-0.8, 0.5, 0.0);
  theatre.Renderer->AddActor(follower);
  theatre.Add(MakeSphere(0.5), 1.0, -0.8, 1.0);
}

inline void AddBillboard(Theatre& theatre)
{
  theatre.Add(MakeSphere(0.5));
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("Billboard");
  text->SetPosition(-0.8, 0.0, 1.0);
  theatre.Renderer->AddActor(text);
}

// All that is drawn over the picture.
inline void AddAnnotations(Theatre& theatre)
{
  theatre.Add(MakeSphere(0.8), -0.5, 0.0, 0.0);
  vtkNew<vtkTextActor> text;
  text->SetInput("Text");
  text->SetPosition(5, 5);
  theatre.Renderer->AddActor(text);
  vtkNew<vtkLookupTable> colours;
  colours->Build();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle("m");
  bar->SetNumberOfLabels(3);
  theatre.Renderer->AddActor(bar);
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(10.0, 60.0, 0.0);
  square->SetPoint1(30.0, 60.0, 0.0);
  square->SetPoint2(10.0, 80.0, 0.0);
  mapper->SetInputData(Make(square));
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.2, 0.6);
  actor->GetProperty()->SetOpacity(0.5);
  theatre.Renderer->AddActor(actor);
}

inline void AddAxes(Theatre& theatre)
{
  theatre.Add(MakeSphere(0.8));
  vtkNew<vtkAxesActor> axes;
  theatre.Renderer->AddActor(axes);
  vtkNew<vtkCubeAxesActor> cube;
  cube->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  cube->SetCamera(theatre.Renderer->GetActiveCamera());
  theatre.Renderer->AddActor(cube);
}

//------------------------------------------------------------------------------
inline void AddSkybox(Theatre& theatre)
{
  vtkNew<vtkSkybox> box;
  box->SetTexture(MakeCubeMap());
  theatre.Renderer->AddActor(box);
  theatre.Add(MakeSphere(1.0));
  theatre.Renderer->GetActiveCamera()->SetPosition(5.0, 2.0, 6.0);
}

inline void AddGradient(Theatre& theatre)
{
  theatre.Add(MakeSphere(1.0));
  theatre.Renderer->GradientBackgroundOn();
  theatre.Renderer->SetBackground2(0.9, 0.6, 0.2);
}

inline void AddTexturedBackground(Theatre& theatre)
{
  theatre.Add(MakeSphere(1.0));
  theatre.Renderer->TexturedBackgroundOn();
  theatre.Renderer->SetBackgroundTexture(MakeTexture(3));
}
}

#endif
