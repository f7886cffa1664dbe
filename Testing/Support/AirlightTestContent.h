// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contents of a scene, each in a renderer of its own in one window, and the small pieces that they
 * are made of: surfaces, lines and points; volumes, assemblies, annotations and backgrounds.
 */

#ifndef AirlightTestContent_h
#define AirlightTestContent_h

#include "AirlightTestScene.h"

#include "vtkGlyph3DMapper.h"
#include "vtkTexture.h"
#include "vtkVolumeMapper.h"

namespace airlight_test
{
// Begins a content: of the scene only the window is left. A camera looks along -z at a square of
// about 4 by 4 units around the origin. The renderer does not have the pass yet.
void Open(Scene& scene);

// Weak enough that nothing is overexposed, since VTK cuts at 1 what it blends into 8 bits and the
// pass does not. One kind of light: the shaders of translucent surfaces hold the closed forms of
// all there are.
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

//------------------------------------------------------------------------------
// Shadings and representations of one sphere each.
void AddShadings(Scene& scene);
void AddVertices(Scene& scene);
void AddLines(Scene& scene);
void AddPoints(Scene& scene, bool spheres);
void AddBackfaces(Scene& scene);
void AddUnlit(Scene& scene);
void AddPhysical(Scene& scene, bool environment);
void AddTexture(Scene& scene, int components);

// By point, by cell, and by point through a texture.
void AddScalars(Scene& scene);

// Translucent surfaces that cross each other, before and behind an opaque one.
void AddTranslucent(Scene& scene);

// Blocks of their own colour and opacity, one of them hidden.
void AddComposite(Scene& scene);

// Glyphs turned and scaled by arrays.
vtkSmartPointer<vtkGlyph3DMapper> MakeGlyphs();

void AddGlyphs(Scene& scene, double opacity);
void AddGaussians(Scene& scene, bool emissive, double opacity);

//------------------------------------------------------------------------------
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
