// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A slab of constant density in a scene.
 */

#ifndef AirlightTestVolume_h
#define AirlightTestVolume_h

#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "vtkImageData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace airlight_test
{
// From Low to High; its values grow along z, so that VTK shades it as if it faced along z, but its
// colour and its opacity are the same everywhere: what goes through one unit is exp(-Kappa).
struct Slab
{
  glm::dvec3 Low{ -3.0, -2.0, -1.0 };
  glm::dvec3 High{ 3.0, 2.5, 1.0 };
  glm::dvec3 Colour{ 0.9, 0.5, 0.2 };
  double Kappa = 0.6;
  double Step = 0.01; // of VTK's samples
  bool Lit = false;
};

// Values of cells: with values of points VTK shades as if samples were up to half a voxel
// elsewhere.
vtkSmartPointer<vtkImageData> MakeSlabImage(const Slab& slab, int components = 1);

vtkSmartPointer<vtkVolumeProperty> MakeSlabProperty(const Slab& slab);

vtkSmartPointer<vtkVolume> AddSlab(Scene& scene, const Slab& slab);
}

#endif
