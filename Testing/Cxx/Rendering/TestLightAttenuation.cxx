// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights that fade with distance by VTK's 1/(a + b r + c r^2), on a white plane and in the medium
// before it, against quadrature. A light of VTK's colour k lights
//
//   the plane:  Surface = k cos(theta) f(r) exp(-sigmaT (r + t)), f(r) = 1/(a + b r + c r^2), and
//   the medium: Airlight = sigmaS/(4 pi) pi k integral over [0, t] of f(r(s)) exp(-sigmaT (r(s) + s)) ds,
//
// since its radiant intensity is pi k r^2 f(r). And the radius of point lights, against the same.

#include "AirlightTestPixelScene.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkLight.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const double Colour[3] = { 0.8, 0.5, 0.3 };
const double Scattering[3] = { 0.05, 0.1, 0.02 };
const double Absorption[3] = { 0.05, 0.0, 0.1 };

struct FadingLight
{
  glm::dvec3 Place;
  glm::dvec3 Attenuation; // a, b, c

  double Fade(double r) const
  {
    return 1.0 / (this->Attenuation.x + r * (this->Attenuation.y + r * this->Attenuation.z));
  }
  bool IsInverseSquare() const { return this->Attenuation.x + this->Attenuation.y == 0.0; }
};

double GetSurface(const FadingLight& light, int k, const PixelRay& ray, double t)
{
  const double r = glm::length(light.Place - ray.Origin - t * ray.Direction);
  return Colour[k] * light.Place.z / r * light.Fade(r) *
    std::exp(-(Scattering[k] + Absorption[k]) * (r + t));
}

double GetAirlight(const FadingLight& light, int k, const PixelRay& ray, double t)
{
  const double foot = glm::dot(light.Place - ray.Origin, ray.Direction);
  const double h = glm::length(light.Place - ray.Origin - foot * ray.Direction);
  return Pi * Scattering[k] * Colour[k] *
    IsotropicAirlight([&](double r, double) { return light.Fade(r); },
      Scattering[k] + Absorption[k], foot, h, 0.0, t, 1e-10);
}

void AddLight(PixelScene& scene, const FadingLight& item)
{
  vtkNew<vtkLight> light;
  light->PositionalOn();
  light->SetConeAngle(90.0);
  light->SetPosition(&item.Place.x);
  light->SetAttenuationValues(&item.Attenuation.x);
  light->SetDiffuseColor(Colour);
  scene.Renderer->AddLight(light);
}

//------------------------------------------------------------------------------
struct Comparisons
{
  Comparison Surface{ "surface, relative" };
  Comparison Square{ "airlight of lights that fade by c r^2, relative" };
  Comparison Other{ "airlight of lights that fade otherwise, relative" };
};

void ComparePixels(PixelScene& scene, const std::vector<FadingLight>& lights, Comparisons& to)
{
  const bool square = std::all_of(
    lights.begin(), lights.end(), [](const FadingLight& light) { return light.IsInverseSquare(); });
  for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; pixel += 7)
  {
    const int i = pixel % PixelScene::Width;
    const int j = pixel / PixelScene::Width;
    const PixelRay ray = scene.GetRay(i, j);
    const double t = -ray.Origin.z / ray.Direction.z;
    for (int k = 0; k < 3; ++k)
    {
      double surface = 0.0;
      double airlight = 0.0;
      for (const FadingLight& light : lights)
      {
        surface += GetSurface(light, k, ray, t);
        airlight += GetAirlight(light, k, ray, t);
      }
      const auto add = [&](Comparison& comparison, const char* name, double value, double limit) {
        const double shown = scene.GetPixel(name, i, j)[k];
        comparison.Add(std::abs(shown / value - 1.0), limit, [&] {
          return Text(lights.size(), " lights, the first with ", Text3(&lights[0].Attenuation.x),
            ", pixel ", i, " ", j, ", channel ", k, ": ", shown, ", expected ", value);
        });
      };
      add(to.Surface, "Surface", surface, 1e-5);
      // By the closed form or by Gauss's rule.
      add(square ? to.Square : to.Other, "Airlight", airlight, square ? 1e-5 : 1e-4);
    }
  }
}

//------------------------------------------------------------------------------
// What kind a light is stands in the mappers' shaders: one scene goes through all kinds.
bool TestAttenuation()
{
  const glm::dvec3 first(0.5, 0.3, 2.0);
  const glm::dvec3 second(-1.5, 1.0, 0.7);
  const std::vector<FadingLight> settings[] = { { { first, { 0.0, 0.0, 2.5 } } },
    { { first, { 0.0, 0.0, 1.0 } } }, { { first, { 0.0, 0.0, 0.4 } } },
    { { first, { 1.0, 0.0, 0.0 } } }, { { first, { 0.5, 0.3, 0.0 } } },
    { { first, { 0.2, 0.1, 0.7 } } },
    { { first, { 0.0, 0.0, 3.0 } }, { second, { 0.0, 0.0, 1.0 } } },
    { { first, { 0.0, 0.0, 0.2 } }, { second, { 0.0, 2.0, 0.5 } } } };
  PixelScene scene;
  scene.AddBroadPlane();
  scene.Medium->SetScattering(Scattering[0], Scattering[1], Scattering[2]);
  scene.Medium->SetAbsorption(Absorption[0], Absorption[1], Absorption[2]);
  Comparisons comparisons;
  for (const std::vector<FadingLight>& lights : settings)
  {
    scene.Renderer->RemoveAllLights();
    for (const FadingLight& light : lights)
    {
      AddLight(scene, light);
    }
    scene.RenderFitted();
    ComparePixels(scene, lights, comparisons);
  }
  return AllOk({ &comparisons.Surface, &comparisons.Square, &comparisons.Other });
}

//------------------------------------------------------------------------------
// The radius of point lights, vtkAirlightPass::SetLightRadius(): rays that pass a light more
// closely are shaded as if they passed at this distance, h = radius, with the same foot.
const double RadiusScattering[3] = { 0.1, 0.2, 0.05 };
const double RadiusAbsorption[3] = { 0.0, 0.1, 0.05 };
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

// Of a unit light per unit of scattering, isotropic. Beyond 100 the media let nothing through.
double GetAirlight(
  const glm::dvec3& light, const PixelRay& ray, double sigmaT, double radius, Method method)
{
  const double foot = glm::dot(light - ray.Origin, ray.Direction);
  const double h = glm::length(light - ray.Origin - foot * ray.Direction);
  const double kept = std::max(h, radius); // what the radius leaves of the distance
  return IsotropicAirlight([&](double, double x) { return 1.0 / (kept * kept + x * x); }, sigmaT,
    foot, method == Method::ClosedForm ? kept : h, 0.0, 100.0, 1e-9);
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
      const double expected = RadiusScattering[k] * Intensity[k] *
        GetAirlight(light, ray, RadiusScattering[k] + RadiusAbsorption[k], radius, method);
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

bool TestRadius()
{
  const glm::dvec3 place(0.5, 0.3, -5.0);
  PixelScene scene;
  scene.Medium->SetScattering(RadiusScattering[0], RadiusScattering[1], RadiusScattering[2]);
  scene.Medium->SetAbsorption(RadiusAbsorption[0], RadiusAbsorption[1], RadiusAbsorption[2]);
  vtkAirlight::SetRadiantIntensity(scene.Light, Intensity);
  scene.Light->SetPosition(&place.x);
  scene.Renderer->AddLight(scene.Light);
  Aim(scene, place);
  const bool large = CompareRadius(scene, place, 0.4, Method::ClosedForm);
  const bool small = CompareRadius(scene, place, 0.15, Method::ClosedForm);
  // Two media, each half as dense: the same by Gauss's rule.
  vtkNew<vtkParticipatingMedium> half;
  for (vtkParticipatingMedium* medium : { scene.Medium.Get(), half.Get() })
  {
    medium->SetScattering(
      0.5 * RadiusScattering[0], 0.5 * RadiusScattering[1], 0.5 * RadiusScattering[2]);
    medium->SetAbsorption(
      0.5 * RadiusAbsorption[0], 0.5 * RadiusAbsorption[1], 0.5 * RadiusAbsorption[2]);
  }
  scene.Pass->AddMedium(half);
  const bool two = CompareRadius(scene, place, 0.4, Method::Quadrature);
  return large && small && two;
}
}

//------------------------------------------------------------------------------
int TestLightAttenuation(int, char*[])
{
  const bool ok = TestAttenuation();
  return TestRadius() && ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
