// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A lamp close to a wall in dense fog, the wall also lit by scattered light: the picture, and how
// far it lies above the same scene without. Expected numbers from AirlightTestIrradiance.h.

#include "AirlightTestIrradiance.h"
#include "AirlightTestScene.h"

using namespace airlight_test;

namespace
{
const double Wall[3] = { 0.8, 0.75, 0.7 };

// The wall z = 0, a floor, a post between the lamp and a part of the wall.
void Build(Scene& scene)
{
  for (vtkActor* actor : { scene.Add(MakeSheet({ -8, -1.5, 0 }, { 16, 0, 0 }, { 0, 7.5, 0 })),
         scene.Add(MakeSheet({ -8, -1.5, 6 }, { 16, 0, 0 }, { 0, 0, -6 })) })
  {
    actor->GetProperty()->SetColor(Wall[0], Wall[1], Wall[2]);
  }
  scene.AddBox({ 0.6, -1.5, 0.25 }, { 0.75, 0.5, 0.4 }, { 0.5, 0.3, 0.2 });
  scene.AddPointLight({ 0, 0, 0.8 }, { 5.0, 4.2, 3.1 });
  scene.Medium->SetScattering(0.5, 0.5, 0.5);
  scene.Medium->SetAbsorption(0.02, 0.02, 0.02);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.3);
  scene.Look({ -0.9, 0.9, 2.7 }, { 0.35, -0.15, 0.0 });
}

// On the wall: below the lamp, to the left, and in the shadow of the post.
void CheckPoint(
  Scene& scene, const glm::dvec3& point, bool isLit, const Buffers& on, const Buffers& off)
{
  // The pixel that shows the point nearest to it.
  double best = Infinity;
  int px = 0;
  int py = 0;
  glm::dvec3 shown(0.0);
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const Ray ray = scene.GetRay(i % scene.Width + 0.5, i / scene.Width + 0.5);
    const glm::dvec3 there = ray.Origin - ray.Origin.z / ray.Direction.z * ray.Direction;
    if (ray.Direction.z < 0.0 && glm::distance(there, point) < best)
    {
      best = glm::distance(there, point);
      px = i % scene.Width;
      py = i / scene.Width;
      shown = there;
    }
  }
  const glm::dvec3 irradiance =
    Hemisphere(scene.Medium, scene.Lights[0], shown, { 0.0, 0.0, 1.0 }).Irradiance(2);
  const glm::dvec3 with = GetColour(on.at("Surface"), px, py);
  const glm::dvec3 without = GetColour(off.at("Surface"), px, py);
  const glm::dvec3 passes = GetColour(on.at("Transmittance"), px, py);
  std::cout << "wall at " << shown.x << " " << shown.y << ", pixel " << px << " " << py
            << ": surface " << without.x << " without, " << with.x << " with scattered light\n";
  Check((without.x > 0.0) == isLit, isLit ? "the point is lit" : "the point is in shadow");
  for (int c = 0; c < 3; ++c)
  {
    const double expected = Wall[c] * irradiance[c] / Pi * passes[c];
    Check(std::abs((with[c] - without[c]) / expected - 1.0) < 0.003,
      "channel " + std::to_string(c) + ": " + std::to_string(with[c] - without[c]) +
        " is added, expected " + std::to_string(expected));
  }
}

// Above everywhere on surfaces, the same elsewhere.
void CheckAbove(const Buffers& on, const Buffers& off, const Scene& scene)
{
  double sumOn = 0.0;
  double sumOff = 0.0;
  long wrong = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const bool surface = GetValue(on.at("Depth"), x, y) >= 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double a = GetValue(on.at("Radiance"), x, y, c);
      const double b = GetValue(off.at("Radiance"), x, y, c);
      wrong += (surface ? a > b : a == b) ? 0 : 1;
    }
    sumOn += GetValue(on.at("Surface"), x, y);
    sumOff += GetValue(off.at("Surface"), x, y);
  }
  std::cout << "surfaces send " << sumOn / sumOff << " times what they send without\n";
  Check(wrong == 0, std::to_string(wrong) + " values are not above those without scattered light");
}
}

//------------------------------------------------------------------------------
int TestScatteredSurfaceLightPicture(int argc, char* argv[])
{
  Scene scene(640, 480);
  Build(scene);
  const Buffers off = scene.Render();
  scene.Pass->ScatteredSurfaceLightOn();
  const Buffers on = scene.Render();
  CheckAbove(on, off, scene);
  CheckPoint(scene, { 0.0, 0.0, 0.0 }, true, on, off);
  CheckPoint(scene, { -0.9, 0.3, 0.0 }, true, on, off);
  CheckPoint(scene, { 1.2, 0.1, 0.0 }, false, on, off);
  return scene.Finish(argc, argv);
}
