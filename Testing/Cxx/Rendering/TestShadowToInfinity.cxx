// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays to the background that enter a shadow and never leave it. A lamp at the origin stands before a
// square, 1 away and 2 wide, whose shadow is the pyramid |x|, |y| < -z behind it. The eye, beside the
// lamp, looks along the pyramid's axis. So each ray o + t d is lit up to where it has crossed the last
// of the pyramid's four planes, and dark from there to infinity:
//
//   L = sigmaS I/(4 pi) integral from 0 to there of exp(-sigmaT (t + r))/r^2 dt,   r = |o + t d|
//
// by Simpson's rule. The lamp stays 4 away from all of that, so that 2000 panels give 1e-9.

#include "AirlightTestCheck.h"
#include "AirlightTestPixels.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Intensity = 5.0;

void AddSquare(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(-1.0, -1.0, -1.0);
  square->SetPoint1(1.0, -1.0, -1.0);
  square->SetPoint2(-1.0, 1.0, -1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(square->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

// With the attenuation 1/r^2 the radiant intensity is pi times VTK's.
void AddLamp(vtkRenderer* renderer)
{
  vtkNew<vtkLight> lamp;
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(0.0, 0.0, 0.0);
  lamp->SetAttenuationValues(0.0, 0.0, 1.0);
  lamp->SetIntensity(Intensity / Pi);
  renderer->AddLight(lamp);
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
  const auto integrand = [&](double t) {
    const double r = glm::length(ray.Origin + t * ray.Direction);
    return std::exp(-extinction * (t + r)) / (r * r);
  };
  constexpr int Panels = 2000;
  const double width = GetShadowStart(ray) / Panels;
  double sum = 0.0;
  for (int i = 0; i < Panels; ++i)
  {
    sum += width / 6.0 *
      (integrand(i * width) + 4.0 * integrand((i + 0.5) * width) + integrand((i + 1.0) * width));
  }
  return scattering * Intensity / (4.0 * Pi) * sum;
}

void TestFog(bool coloured)
{
  PixelScene scene;
  const double extinction[3] = { 0.05, coloured ? 0.1 : 0.05, coloured ? 0.02 : 0.05 };
  scene.Medium->SetScattering(extinction);
  AddSquare(scene.Renderer);
  AddLamp(scene.Renderer);
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
