// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A box of fog so opaque, and so far away, that single precision hardly tells places apart where
// light fades in it, lit by a lamp outside, which takes quadrature. Where the lamp sees the face
// that a ray enters, with a, b the cosines of ray and lamp's direction to its normal, the lamp's
// way in the fog at t is t a/b and
//
//   L = sigmaS p I/r^2 integral exp(-sigmaT t (1 + a/b)) dt = sigmaS/sigmaT p I/r^2/(1 + a/b)
//
// Where positions are rounded by d, depths are off by sigmaT d.
//
// And shadows in fog around everything, so opaque that light is gone long before most of their
// edges: where they are does not depend on the medium.

#include "AirlightTestSceneRays.h"

#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

using namespace airlight_test;

namespace
{
constexpr double Distance = 220.0;
constexpr double Half = 2.0; // of the box, whose front face is at z = 0
const glm::dvec3 Lamp(30.0, 20.0, 150.0);
constexpr double Intensity = 1e6;
constexpr double Rounding = 4.0 * 0x1p-24 * Distance;

double GetExpected(const glm::dvec3& point, const glm::dvec3& direction, double albedo)
{
  const glm::dvec3 toLamp = Lamp - point;
  const double r = glm::length(toLamp);
  const double a = -direction.z;
  const double b = toLamp.z / r;
  return albedo * Intensity / (4.0 * Pi * r * r) / (1.0 + a / b);
}

void Compare(double extinction, bool parallel)
{
  Scene scene(160, 120);
  scene.SmoothEdges();
  scene.Medium->SetScattering(0.8 * extinction, 0.5 * extinction, 0.1 * extinction);
  scene.Medium->SetAbsorption(0.2 * extinction, 0.5 * extinction, 0.9 * extinction);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-Half, Half, -Half, Half, -2.0 * Half, 0.0);
  scene.AddPointLight(Lamp, glm::dvec3(Intensity));
  scene.Look(glm::dvec3(0.0, 0.0, Distance), glm::dvec3(0.0));
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetViewAngle(2.0);
  camera->SetParallelScale(1.2 * Half);
  camera->SetParallelProjection(parallel);
  camera->SetClippingRange(1.0, 2.0 * Distance);
  scene.Window->Render();
  vtkSmartPointer<vtkImageData> drawn = scene.GetBuffer("Airlight");
  const int* size = drawn->GetDimensions();
  double worst = 0.0;
  int count = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const Ray ray = scene.GetPixelRay({ x, y });
      const glm::dvec3 point = ray.Origin - ray.Origin.z / ray.Direction.z * ray.Direction;
      if (std::max(std::abs(point.x), std::abs(point.y)) < 0.95 * Half)
      {
        const glm::dvec3 seen = GetColour(drawn, x, y);
        for (int k = 0; k < 3; ++k)
        {
          const double albedo = k == 0 ? 0.8 : k == 1 ? 0.5 : 0.1;
          const double error = std::abs(seen[k] / GetExpected(point, ray.Direction, albedo) - 1.0);
          worst = std::isnan(error) ? error : std::max(worst, error);
        }
        ++count;
      }
    }
  }
  CheckClose(1.0 + worst, 1.0, 1e-3 + std::expm1(extinction * Rounding),
    Text("extinction ", extinction, parallel ? ", parallel" : ", perspective"));
  Check(count > 1000, "pixels on the fog");
}

Buffers RenderShadows(double extinction, bool coloured)
{
  WindowScene scene(120, 90);
  scene.Medium->SetRegionToUnbounded();
  scene.Medium->SetScattering(extinction, extinction, coloured ? 0.01 * extinction : extinction);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  return scene.Render();
}

void CompareShadows(bool coloured)
{
  const Buffers thin = RenderShadows(1e-3, coloured);
  for (const double extinction : { 10.0, 1e3, 1e5 })
  {
    const std::string name = Text("shadows in fog of ", extinction);
    const Buffers opaque = RenderShadows(extinction, coloured);
    Check(AreSame(thin.at("LitLength"), opaque.at("LitLength")), name + ": the same lit lengths");
    CheckFinite(opaque, name);
  }
}
}

//------------------------------------------------------------------------------
int TestOpaqueFog(int, char*[])
{
  for (const double extinction : { 100.0, 1e3, 1e4 })
  {
    Compare(extinction, false);
    Compare(extinction, true);
  }
  CompareShadows(false);
  CompareShadows(true);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
