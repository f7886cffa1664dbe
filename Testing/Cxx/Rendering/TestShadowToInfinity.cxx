// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays to the background that enter a shadow and never leave it. A lamp at the origin stands before
// a square, 1 away and 2 wide, whose shadow is the pyramid |x|, |y| < -z behind it. The eye, beside
// the lamp, looks along the pyramid's axis. So each ray o + t d is lit up to where it has crossed
// the last of the pyramid's four planes, and dark from there to infinity:
//
//   L = sigmaS I/(4 pi) integral from 0 to there of exp(-sigmaT (t + r))/r^2 dt,   r = |o + t d|

#include "AirlightTestCheck.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestQuadrature.h"

#include <algorithm>
#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Intensity = 5.0;

// With the attenuation 1/r^2 the radiant intensity is pi times VTK's.
void AddLamp(PixelScene& scene)
{
  vtkLight* lamp = scene.Light;
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(0.0, 0.0, 0.0);
  lamp->SetAttenuationValues(0.0, 0.0, 1.0);
  lamp->SetIntensity(Intensity / Pi);
  scene.Renderer->AddLight(lamp);
}

// Where the ray has crossed all planes ±x + z = 0 and ±y + z = 0.
double GetShadowStart(const PixelRay& ray)
{
  double start = 0.0;
  for (const glm::dvec3& plane : { glm::dvec3(1.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 1.0),
         glm::dvec3(0.0, 1.0, 1.0), glm::dvec3(0.0, -1.0, 1.0) })
  {
    start = std::max(start, -glm::dot(plane, ray.Origin) / glm::dot(plane, ray.Direction));
  }
  return start;
}

double GetExpected(const PixelRay& ray, double scattering, double extinction)
{
  const double foot = -glm::dot(ray.Origin, ray.Direction); // of the lamp in the origin
  const double h = glm::length(ray.Origin + foot * ray.Direction);
  return scattering * Intensity *
    IsotropicAirlight([](double r, double) { return 1.0 / (r * r); }, extinction, foot, h, 0.0,
      GetShadowStart(ray));
}

void TestFog(bool coloured)
{
  PixelScene scene;
  const double extinction[3] = { 0.05, coloured ? 0.1 : 0.05, coloured ? 0.02 : 0.05 };
  scene.Medium->SetScattering(extinction);
  scene.AddPlane({ -1.0, -1.0, -1.0 }, { 1.0, -1.0, -1.0 }, { -1.0, 1.0, -1.0 });
  AddLamp(scene);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(5.0, 0.0, 5.0);
  camera->SetFocalPoint(5.0, 0.0, 0.0);
  camera->SetClippingRange(0.1, 100.0);
  scene.Window->Render();
  double worst = 0.0;
  for (int j = 0; j < PixelScene::Height; j += 3)
  {
    for (int i = 0; i < PixelScene::Width; i += 3)
    {
      const PixelRay ray = scene.GetRay(i, j);
      const float* seen = scene.GetPixel("Airlight", i, j);
      for (int k = 0; k < 3 && seen; ++k)
      {
        const double expected = GetExpected(ray, extinction[k], extinction[k]);
        worst = std::max(worst, std::abs(seen[k] / expected - 1.0));
      }
      Check(seen && *scene.GetPixel("Depth", i, j) < 0.0f, "the ray goes to the background");
      Check(seen && *scene.GetPixel("BoundaryCount", i, j) == 1.0f, "the ray has one boundary");
    }
  }
  const std::string what = coloured ? "coloured" : "grey";
  std::cout << what << ": largest relative error " << worst << "\n";
  Check(worst < 1e-5, what + ": airlight ends where the shadow begins");
}
}

//------------------------------------------------------------------------------
int TestShadowToInfinity(int, char*[])
{
  TestFog(false);
  TestFog(true);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
