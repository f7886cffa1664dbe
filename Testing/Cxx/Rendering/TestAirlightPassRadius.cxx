// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The radius of point lights, vtkAirlightPass::SetLightRadius(): rays that pass a light more closely are
// shaded as if they passed at this distance, h = radius, with the same foot. Against quadrature of
//
//   Airlight = I sigmaS/(4 pi) integral of exp(-sigmaT (t + r))/r^2 dt, r^2 = h^2 + (t - foot)^2.

#include "AirlightTestPixels.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkLight.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const double Scattering[3] = { 0.1, 0.2, 0.05 };
const double Absorption[3] = { 0.0, 0.1, 0.05 };
const double Intensity[3] = { 10.0, 20.0, 30.0 };

// The camera in the origin of a telescope that looks at the light, beside its middle.
void Aim(PixelScene& scene, const glm::dvec3& light)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(light.x + 0.03, light.y - 0.02, light.z);
  camera->SetViewAngle(15.0);
  camera->SetClippingRange(0.1, 100.0);
}

//------------------------------------------------------------------------------
enum class Method
{
  ClosedForm,
  Quadrature // where the medium attenuates light on its own way
};

// Of a unit light per unit of scattering, isotropic. r is what the radius leaves of the distance.
double GetAirlight(
  const glm::dvec3& light, const PixelRay& ray, double sigmaT, double radius, Method method)
{
  const double foot = glm::dot(light - ray.Origin, ray.Direction);
  const double h = glm::length(light - ray.Origin - foot * ray.Direction);
  const double kept = std::max(h, radius);
  const auto integrand = [&](double x) {
    const double r = std::hypot(kept, x);
    const double way = method == Method::ClosedForm ? r : std::hypot(h, x);
    return 0.25 / Pi / (r * r) * std::exp(-sigmaT * (foot + x + way));
  };
  // What is beyond 100 the media leave nothing of.
  return Integrate(integrand, PeakPanels(-foot, 100.0, std::min(h, 0.1)), 1e-9);
}

// Every third pixel in either direction.
bool CompareRadius(PixelScene& scene, const glm::dvec3& light, double radius, Method method)
{
  scene.Pass->SetLightRadius(radius);
  scene.Window->Render();
  Comparison within(Text("radius ", radius, ", rays within it, relative"));
  Comparison beyond(Text("radius ", radius, ", other rays, relative"));
  for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height / 9; ++pixel)
  {
    const int i = 3 * (pixel % (PixelScene::Width / 3)) + 1;
    const int j = 3 * (pixel / (PixelScene::Width / 3) % (PixelScene::Height / 3)) + 1;
    const PixelRay ray = scene.GetRay(i, j);
    const double h = glm::length(glm::cross(light - ray.Origin, ray.Direction));
    for (int k = 0; k < 3; ++k)
    {
      const double expected = Scattering[k] * Intensity[k] *
        GetAirlight(light, ray, Scattering[k] + Absorption[k], radius, method);
      const double value = scene.GetPixel("Airlight", i, j)[k];
      const double limit = method == Method::ClosedForm ? 1e-5 : 1e-4;
      (h < radius ? within : beyond).Add(std::abs(value / expected - 1.0), limit, [&] {
        return Text(
          "pixel ", i, " ", j, ", channel ", k, ", h ", h, ": ", value, ", expected ", expected);
      });
    }
  }
  return AllOk({ &within, &beyond });
}
}

//------------------------------------------------------------------------------
int TestAirlightPassRadius(int, char*[])
{
  const glm::dvec3 place(0.5, 0.3, -5.0);
  PixelScene scene;
  scene.Medium->SetScattering(Scattering[0], Scattering[1], Scattering[2]);
  scene.Medium->SetAbsorption(Absorption[0], Absorption[1], Absorption[2]);
  vtkNew<vtkLight> light;
  vtkAirlight::SetRadiantIntensity(light, Intensity);
  light->SetPosition(&place.x);
  scene.Renderer->AddLight(light);
  Aim(scene, place);
  const bool large = CompareRadius(scene, place, 0.4, Method::ClosedForm);
  const bool small = CompareRadius(scene, place, 0.15, Method::ClosedForm);
  // Two media, each half as dense: the same by Gauss's rule.
  vtkNew<vtkParticipatingMedium> half;
  for (vtkParticipatingMedium* medium : { scene.Medium.Get(), half.Get() })
  {
    medium->SetScattering(0.5 * Scattering[0], 0.5 * Scattering[1], 0.5 * Scattering[2]);
    medium->SetAbsorption(0.5 * Absorption[0], 0.5 * Absorption[1], 0.5 * Absorption[2]);
  }
  scene.Pass->AddMedium(half);
  const bool two = CompareRadius(scene, place, 0.4, Method::Quadrature);
  return large && small && two ? EXIT_SUCCESS : EXIT_FAILURE;
}
