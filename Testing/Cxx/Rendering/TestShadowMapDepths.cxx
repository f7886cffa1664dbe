// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadow maps of casters at very different distances from their light: the one up to 50 000 times
// as far as the other; for a sun, one far above the other; and slices of few columns. The shadow of
// each ball in the air is that of shadow planes, to what texels and columns lose.

#include "AirlightTestBodies.h"
#include "AirlightTestImageErrors.h"
#include "AirlightTestTools.h"

#include "vtkCamera.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
Buffers Draw(Scene& scene, int technique)
{
  scene.Pass->SetShadowTechnique(technique);
  Buffers buffers = scene.Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == technique, "the technique asked for");
  return buffers;
}

// `most`: of what shadows take, may be wrong.
void CompareMap(const std::string& name, Scene& scene, double most = 0.02)
{
  const Buffers exact = Draw(scene, vtkAirlightPass::SHADOW_PLANES);
  const double map = GetError(Draw(scene, vtkAirlightPass::SHADOW_MAP), exact, "Airlight");
  const double none = GetError(Draw(scene, vtkAirlightPass::NONE), exact, "Airlight");
  std::cout << name << ": map " << map << ", no shadows " << none << "\n";
  Check(none > 1e-3, name + ": shadows are seen");
  Check(map < most * none, Text(name, ": the map's shadows, off by ", map, " of ", none));
}
}

//------------------------------------------------------------------------------
int TestShadowMapDepths(int, char*[])
{
  for (const double ratio : { 0.5, 1e-2, 2e-4, 2e-5 })
  {
    Scene lamp(100, 75);
    const double near = 100.0 * ratio;
    lamp.AddPointLight({ 0, 0, 0 });
    lamp.AddBall({ near, 0, 0 }, 0.4 * near, glm::dvec3(1.0));
    lamp.AddBall({ -80, 0, 0 }, 20.0, glm::dvec3(1.0));
    vtkCamera* camera = lamp.Renderer->GetActiveCamera();
    lamp.Look({ 1.5 * near, 0.5 * near, 4.0 * near }, { near, 0, 0 });
    camera->SetClippingRange(0.1 * near, 400.0);
    CompareMap(Text("lamp, near ball, ", ratio), lamp);
    lamp.Look({ -110, 20, 80 }, { -110, 0, 0 });
    camera->SetClippingRange(1.0, 400.0);
    CompareMap(Text("lamp, far ball, ", ratio), lamp);
  }
  // Slices of one word of columns, and of three.
  for (const int steps : { 1, 5 })
  {
    Scene coarse(100, 75);
    coarse.AddPointLight({ 0, 0, 0 });
    coarse.AddBall({ 50, 0, 0 }, 20.0, glm::dvec3(1.0));
    coarse.AddBall({ -80, 0, 0 }, 20.0, glm::dvec3(1.0));
    coarse.Look({ 10, 10, 200 }, { 10, 0, 0 });
    coarse.Renderer->GetActiveCamera()->SetClippingRange(1.0, 1000.0);
    coarse.Pass->SetNumberOfSteps(steps);
    CompareMap(Text(steps, " steps"), coarse, steps == 1 ? 0.5 : 0.2);
  }
  for (const double height : { 10.0, 1000.0 })
  {
    Scene sun(100, 75);
    sun.AddDirectionalLight({ 0, 1, 1e-3 });
    sun.AddBall({ 0.5, 0, 0 }, 1.0, glm::dvec3(1.0));
    sun.AddBall({ -1.5, height, 0 }, 1.0, glm::dvec3(1.0));
    sun.Look({ 0, 1, 8 }, { 0, -1, 0 });
    CompareMap(Text("sun, ", height), sun);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
