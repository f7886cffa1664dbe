// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A slab of constant density in a scene, and what a pixel ought to show through it.
 */

#ifndef AirlightTestVolume_h
#define AirlightTestVolume_h

#include "AirlightTestCompareScene.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnsignedCharArray.h"
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

// Values of cells: with values of points VTK shades as if samples were up to half a voxel elsewhere.
vtkSmartPointer<vtkImageData> MakeSlabImage(const Slab& slab, int components = 1);

vtkSmartPointer<vtkVolumeProperty> MakeSlabProperty(const Slab& slab);

vtkSmartPointer<vtkVolume> AddSlab(Scene& scene, const Slab& slab);

// Where the ray is in the slab.
Interval GetSpan(const Slab& slab, const Ray& ray);

// What the air before distance t scatters into the ray, brute force.
Answer GetAirBefore(Scene& scene, const Ray& ray, double t);

bool IsInShadow(Scene& scene, vtkLight* lamp, const Ray& ray, double t);

// What a ray may show wrongly since whether a light arrives is known at 16 nodes alone: between a lit
// node and one in shadow the share goes from 1 to 0 in a straight line, which over the interval
// differs from a step by at most half of it.
double GetEdgeError(Scene& scene, const Slab& slab, const Ray& ray, double from, double length);

// A sample of the slab, by T C + L.
glm::dvec3 GetSample(Scene& scene, const Slab& slab, const Ray& ray, double t);

// The sum of VTK's samples over what is behind. `opacity` is that of all of them, as the frame in
// clear air shows it. VTK's samples lie at whole steps from 1 on and stand for the step before them,
// so that the sum is, to second order in the step, the integral with samples half a step farther.
glm::dvec3 GetThroughSlab(Scene& scene, const Slab& slab, const Ray& ray, double opacity,
  const glm::dvec3& behind, int panels);
}

#endif
