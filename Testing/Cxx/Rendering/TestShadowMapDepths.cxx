// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadow maps of casters at very different distances from their light: nearly as near as the map's
// cameras see, and 5000 times as far; for a sun, one caster far above another. Each ball's shadow
// in the air is that of shadow planes, to what texels lose.

#include "AirlightTestBodies.h"
#include "AirlightTestTools.h"

#include "vtkSphereSource.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
void AddBall(Scene& scene, const glm::dvec3& centre, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  scene.Add(sphere);
}

std::vector<double> Draw(Scene& scene, int technique)
{
  scene.Pass->SetShadowTechnique(technique);
  scene.Window->Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == technique, "the technique asked for");
  std::vector<double> values;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    values.push_back(GetValue(scene.GetBuffer("Airlight"), i % scene.Width, i / scene.Width));
  }
  return values;
}

// The root of the mean squared difference over the mean.
double Compare(const std::vector<double>& values, const std::vector<double>& exact)
{
  double squares = 0.0;
  double sum = 0.0;
  for (size_t i = 0; i < exact.size(); ++i)
  {
    squares += (values[i] - exact[i]) * (values[i] - exact[i]);
    sum += exact[i];
  }
  return std::sqrt(squares * exact.size()) / sum;
}

void CompareMap(const std::string& name, Scene& scene)
{
  const std::vector<double> exact = Draw(scene, vtkAirlightPass::SHADOW_PLANES);
  const double map = Compare(Draw(scene, vtkAirlightPass::SHADOW_MAP), exact);
  const double none = Compare(Draw(scene, vtkAirlightPass::NONE), exact);
  std::cout << name << ": map " << map << ", no shadows " << none << "\n";
  Check(none > 1e-3, name + ": shadows are seen");
  Check(map < 0.02 * none, Text(name, ": the map's shadows, off by ", map, " of ", none));
}
}

//------------------------------------------------------------------------------
int TestShadowMapDepths(int, char*[])
{
  for (const double ratio : { 0.5, 1e-2, 2e-4 })
  {
    Scene lamp(100, 75);
    const double near = 100.0 * ratio;
    lamp.AddPointLight({ 0, 0, 0 });
    AddBall(lamp, { near, 0, 0 }, 0.4 * near);
    AddBall(lamp, { -90, 0, 0 }, 10.0);
    lamp.Look({ 1.5 * near, 0.5 * near, 4.0 * near }, { near, 0, 0 });
    CompareMap(Text("lamp, ", ratio), lamp);
  }
  for (const double height : { 10.0, 1000.0 })
  {
    Scene sun(100, 75);
    sun.AddDirectionalLight({ 0, 1, 1e-3 });
    AddBall(sun, { 0.5, 0, 0 }, 1.0);
    AddBall(sun, { -1.5, height, 0 }, 1.0);
    sun.Look({ 0, 1, 8 }, { 0, -1, 0 });
    CompareMap(Text("sun, ", height), sun);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
