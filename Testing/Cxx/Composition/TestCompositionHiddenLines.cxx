// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the renderer hides lines, they neither end rays nor show in fog.

#include "AirlightTestComposition.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Pixels of lines further than this.
int CountHidden(const Composition& scene, vtkImageData* depth, double distance)
{
  int count = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    count += GetValue(depth, i % scene.Width, i / scene.Width) > distance ? 1 : 0;
  }
  return count;
}

// Nothing but the air where there are no lines.
double CompareAir(const Composition& scene, Buffers& lines, Buffers& air, int& pixels)
{
  double largest = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    if (GetValue(lines["Depth"], x, y) >= 0.0)
    {
      continue;
    }
    ++pixels;
    const glm::dvec3 apart =
      glm::abs(GetColour(lines["Radiance"], x, y) - GetColour(air["Radiance"], x, y));
    const double error = std::max({ apart.x, apart.y, apart.z });
    largest = error <= largest ? largest : error; // NaN stays
  }
  return largest;
}
}

//------------------------------------------------------------------------------
int TestCompositionHiddenLines(int, char*[])
{
  Composition scene;
  scene.SetFoggy();
  scene.Pass->SetShadowTechniqueToNone();
  scene.Floor->VisibilityOff();
  scene.Box->VisibilityOff();
  scene.Ball->SetPosition(0.0, 0.0, 0.0);
  scene.Ball->SetScale(2.0);
  scene.Ball->GetProperty()->SetRepresentationToWireframe();
  scene.Look({ 0.0, 0.0, 30.0 }, { 0.0, 0.0, 0.0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(10.0);

  // VTK's polygon offset lets the lines of faces at the outline show; those reach 2 sin(15 degrees)
  // beyond the centre, which is 30 away.
  const double far = 30.6;
  scene.Show(scene.Pass);
  const int drawn = CountHidden(scene, scene.GetBuffer("Depth"), far);
  Check(drawn > 300, "far lines are drawn: " + std::to_string(drawn));

  scene.Renderer->UseHiddenLineRemovalOn();
  scene.Show(scene.Pass);
  Buffers lines = scene.CopyBuffers();
  const int hidden = CountHidden(scene, lines["Depth"], far);
  const int near = CountHidden(scene, lines["Depth"], 0.0);
  std::cout << drawn << " pixels of far lines, " << hidden << " where they are hidden, and " << near
            << " of near ones\n";
  Check(hidden == 0, "hidden lines have no distances: " + std::to_string(hidden));
  Check(near > 300, "near lines have distances: " + std::to_string(near));

  scene.Ball->VisibilityOff();
  scene.Show(scene.Pass);
  Buffers air = scene.CopyBuffers();
  int pixels = 0;
  const double apart = CompareAir(scene, lines, air, pixels);
  Check(apart == 0.0 && pixels > 1000,
    "the air behind hidden lines: " + std::to_string(apart) + " apart in " +
      std::to_string(pixels));
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
