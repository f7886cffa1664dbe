// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A shadow map's bias by slope: before a lit plate, however slanted to the light, all air is lit up
// to the plate, though a texel of the map covers parts of it that are nearer to the light than
// others. Of a map so coarse that each texel covers many pixels. The plate as polygons, and as a
// glyph of which the mapper alone knows the place, since its points are blocks.

#include "AirlightTestBodies.h"
#include "AirlightTestTools.h"

#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
vtkSmartPointer<vtkActor> MakeGlyph(vtkPolyData* source)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, data);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetSourceData(source);
  mapper->ScalingOff();
  mapper->OrientOff();
  mapper->ScalarVisibilityOff();
  return Scene::MakeActor(mapper);
}

// The whole picture shows the plate, whose edges are outside.
bool ComparePlate(const std::string& name, Scene& scene, bool glyph)
{
  const auto plate = MakeSheet({ -14, -3, -12 }, { 28, 0, 0 }, { 0, 5, 30 });
  scene.Renderer->AddActor(glyph ? MakeGlyph(plate) : Scene::MakeActor(plate));
  scene.Look({ 0, 7, 4 }, { 0, 0, 1.5 });
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.Pass->SetShadowMapResolution(64);
  scene.Window->Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == vtkAirlightPass::SHADOW_MAP,
    name + ": a shadow map");
  Comparison comparison(name + ": lit part of rays that end on a plate");
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const double depth = GetValue(scene.GetBuffer("Depth"), x, y);
    const double lit = GetValue(scene.GetBuffer("LitLength"), x, y);
    Check(depth > 0.0, name + ": each ray ends on the plate");
    comparison.Add(std::abs(lit / depth - 1.0), 1e-5,
      [&] { return Text("pixel ", x, " ", y, ": lit for ", lit, " of ", depth); });
  }
  return AllOk({ &comparison });
}
}

//------------------------------------------------------------------------------
int TestShadowMapSlopes(int, char*[])
{
  bool ok = true;
  for (const bool glyph : { false, true })
  {
    const std::string body = glyph ? "glyph" : "polygons";
    Scene point(100, 75);
    point.AddPointLight({ 9, 5, 2 });
    ok = ComparePlate(body + ", point light", point, glyph) && ok;
    Scene sun(100, 75);
    sun.AddDirectionalLight({ 2, 1, 0.4 });
    ok = ComparePlate(body + ", sun", sun, glyph) && ok;
  }
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
