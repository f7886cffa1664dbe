// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// How exact pictures of isotropic media are: the median of the radiance's relative error, and its
// mean, which tells whether all is too bright by a little. A point light in fog, with nothing
// behind it and with a white plane, against quadrature:
//
//   Radiance = I sigmaS/(4 pi) integral over [0, t] of exp(-sigmaT (r(s) + s))/r(s)^2 ds
//     + I/(pi r(t)^2) cos(theta) exp(-sigmaT (r(t) + t))

#include "AirlightTestPixelScene.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkLight.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const double Scattering[3] = { 0.1, 0.14, 0.2 };
const double Absorption[3] = { 0.02, 0.01, 0.05 };
const double Intensity[3] = { 10.0, 8.0, 6.0 };

// Five times the median that is claimed, 2e-7. Roundings are to either side, so that it holds of
// the mean, too.
constexpr double MostMedian = 1e-6;
constexpr double MostBias = 1e-6;

double GetRadiance(const glm::dvec3& light, const PixelRay& ray, bool plane, int k)
{
  const double sigmaT = Scattering[k] + Absorption[k];
  const double end = plane ? -ray.Origin.z / ray.Direction.z : 1e6;
  const double foot = glm::dot(light - ray.Origin, ray.Direction);
  const double h = glm::length(light - ray.Origin - foot * ray.Direction);
  const auto isotropic = [](double, double) { return 0.25 / Pi; };
  double radiance = Scattering[k] * PointLightAirlight(isotropic, sigmaT, foot, h, 0.0, end);
  if (plane)
  {
    const double r = glm::length(light - ray.Origin - end * ray.Direction);
    radiance += light.z / (Pi * r * r * r) * std::exp(-sigmaT * (r + end));
  }
  return Intensity[k] * radiance;
}

bool Compare(PixelScene& scene, const glm::dvec3& light, bool visible)
{
  scene.Actor->SetVisibility(visible);
  scene.RenderFitted();
  std::vector<double> errors;
  double sum = 0.0;
  for (int i = 0; i < PixelScene::Width * PixelScene::Height; ++i)
  {
    const int x = i % PixelScene::Width;
    const int y = i / PixelScene::Width;
    const PixelRay ray = scene.GetRay(x, y);
    for (int k = 0; k < 3; ++k)
    {
      const double error =
        scene.GetPixel("Radiance", x, y)[k] / GetRadiance(light, ray, visible, k) - 1.0;
      sum += error;
      errors.push_back(std::abs(error));
    }
  }
  const size_t middle = errors.size() / 2;
  std::nth_element(errors.begin(), errors.begin() + middle, errors.end());
  const std::string name = visible ? "before a white plane" : "nothing but fog";
  Comparison median(name + ": median of the radiance's relative error");
  Comparison bias(name + ": its mean");
  const auto all = [&] { return Text(errors.size(), " values"); };
  median.Add(errors[middle], MostMedian, all);
  bias.Add(std::abs(sum) / static_cast<double>(errors.size()), MostBias, all);
  return AllOk({ &median, &bias });
}
}

//------------------------------------------------------------------------------
int TestAirlightPassAccuracy(int, char*[])
{
  PixelScene scene;
  scene.AddBroadPlane();
  scene.Medium->SetScattering(Scattering[0], Scattering[1], Scattering[2]);
  scene.Medium->SetAbsorption(Absorption[0], Absorption[1], Absorption[2]);
  bool ok = true;
  for (const glm::dvec3& place : { glm::dvec3(0.713, 0.457, 1.2), glm::dvec3(-1.5, 1.0, 2.7) })
  {
    vtkNew<vtkLight> light;
    vtkAirlight::SetRadiantIntensity(light, Intensity);
    light->SetPosition(&place.x);
    scene.Renderer->RemoveAllLights();
    scene.Renderer->AddLight(light);
    for (const bool visible : { false, true })
    {
      ok = Compare(scene, place, visible) && ok;
    }
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
