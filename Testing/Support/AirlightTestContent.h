// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contents of a scene, each in a renderer of its own in one window, and the small pieces that they are
 * made of.
 */

#ifndef AirlightTestContent_h
#define AirlightTestContent_h

#include "AirlightTestScene.h"

#include "vtkElevationFilter.h"
#include "vtkPlaneSource.h"
#include "vtkTexture.h"

namespace airlight_test
{
// Begins a content: of the scene only the window is left. A camera looks along -z at a square of about
// 4 by 4 units around the origin. The renderer does not have the pass yet.
void Open(Scene& scene);

// Weak enough that nothing is overexposed, since VTK cuts at 1 what it blends into 8 bits and the
// pass does not. One kind of light: the shaders of translucent surfaces hold the closed forms of all there are.
vtkLight* AddLamp(Scene& scene, const glm::dvec3& position = { 2.0, 2.0, 3.0 });

// Smoothly shaded, not for brute force.
vtkActor* AddActor(Scene& scene, vtkMapper* mapper);

vtkActor* AddActor(Scene& scene, vtkPolyData* data, const glm::dvec3& position = glm::dvec3(0.0));

// A square of this half width across the z axis, facing +z.
vtkSmartPointer<vtkPolyData> MakeSquare(double half, double z = 0.0);

// With scalars from 0 to 1 at the points.
vtkSmartPointer<vtkPolyData> MakeScalarSphere(double radius);

// A grid of n by n points in the square of half width 1.5.
vtkSmartPointer<vtkPolyData> MakePoints(int n);

// Some pattern; its last component, where there are four, goes from clear to opaque.
vtkSmartPointer<vtkTexture> MakeTexture(int components, int shift = 0);

// Six faces of smooth colours, a cube map.
vtkSmartPointer<vtkTexture> MakeCubeMap();
}

#endif
