// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlight with a vtkLight: point lights of any attenuation against quadrature, a headlight and
// directional lights against their exponentials, and the conversion of strengths.

#include "AirlightTestSpace.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
// Colour * intensity * pi is the strength, 1/(a + b r + c r^2) the fall-off; the light's transform
// counts.
bool TestAttenuation()
{
  Comparison comparison("vtkLight of any attenuation, relative");
  Random random(13);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetBounds(-6, 6, -6, 6, -6, 6);
  const glm::dvec3 attenuations[] = { { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }, { 0.3, 0.2, 0.1 },
    { 0, 0, 2.5 } };
  vtkNew<vtkMatrix4x4> shift;
  shift->SetElement(1, 3, 0.75);
  for (int i = 0; i < 500; ++i)
  {
    SetRandomMedium(medium, random, i);
    medium->SetRegion(i % 3 == 0 ? vtkParticipatingMedium::BOX : vtkParticipatingMedium::UNBOUNDED);
    PointCase c;
    c.Light = RandomPoint(random, 5.0);
    c.Attenuation = attenuations[i % 5];
    c.Origin = RandomPoint(random, 5.0);
    c.Direction = glm::normalize(RandomPoint(random, 1.0));
    c.T0 = i % 4 == 0 ? random.Uniform(0.0, 2.0) : 0.0;
    c.T1 = i % 7 == 0 ? inf : c.T0 + random.LogUniform(1e-3, 30.0);
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(120.0);
    light->SetTransformMatrix(shift);
    light->SetPosition(c.Light.x, c.Light.y - 0.75, c.Light.z);
    light->SetColor(0.5, 1.0, 0.2);
    light->SetIntensity(3.0);
    light->SetAttenuationValues(&c.Attenuation.x);
    const double intensity[3] = { 1.5 * Pi, 3.0 * Pi, 0.6 * Pi };
    const glm::dvec2 range = InsideRange(medium, c);
    double rgb[3];
    vtkAirlight::Inscatter(medium, light, &c.Origin.x, &c.Direction.x, c.T0, c.T1, rgb);
    if (range.y - range.x > 1e-3)
    {
      ComparePoint(medium, c, rgb, intensity, 1e-9, comparison);
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// VTK's headlight: at the ray's origin, attenuation (1, 0, 0). cosTheta = -1 all along, so it
// scatters sigmaS p(-1) pi c (exp(-2 sigmaT t0) - exp(-2 sigmaT t1))/(2 sigmaT).
bool TestHeadlight()
{
  Comparison comparison("headlight at the ray's origin, relative");
  for (double g : { 0.0, 0.5, -0.8 })
  {
    for (double t0 : { 0.0, 1.0 })
    {
      for (double t1 : { 1.5, 40.0, inf })
      {
        vtkNew<vtkParticipatingMedium> medium;
        medium->SetScattering(0.2, 0.4, 1.0);
        medium->SetAbsorption(0.1, 0.0, 1.0);
        medium->SetPhaseFunctionToHenyeyGreenstein();
        medium->SetAnisotropy(g);
        const double origin[3] = { 1.0, 2.0, 3.0 };
        const double direction[3] = { 0.3, -0.4, 1.2 };
        vtkNew<vtkLight> light;
        light->PositionalOn();
        light->SetConeAngle(90.0);
        light->SetPosition(origin);
        double rgb[3];
        vtkAirlight::Inscatter(medium, light, origin, direction, t0, t1, rgb);
        const HenyeyGreensteinPhase phase{ g };
        for (int i = 0; i < 3; ++i)
        {
          const double sigmaT = medium->GetExtinction()[i];
          const double expected = medium->GetScattering()[i] * phase(2.0, 0.0) * Pi *
            (std::exp(-2.0 * sigmaT * t0) - std::exp(-2.0 * sigmaT * t1)) / (2.0 * sigmaT);
          comparison.Add(std::abs(rgb[i] / expected - 1.0), medium->GetPhaseErrorBound() + 1e-9,
            [&] { return Text("g ", g, ", [", t0, ", ", t1, "], sigmaT ", sigmaT); });
        }
      }
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// A spot 5 above a ray that stays in its cone: I cos^n(angle to the axis) in place of I. VTK's
// exponent is 1 unless set.
bool TestSpotExponent()
{
  Comparison comparison("spots with an exponent, relative");
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.3, 0.3, 0.3);
  const double origin[3] = { -1.0, 0.5, 0.0 };
  const double direction[3] = { 1.0, 0.0, 0.0 };
  const double strength[3] = { 7.0, 7.0, 7.0 };
  for (double exponent : { 0.0, 1.0, 2.0, 5.0 })
  {
    vtkNew<vtkLight> light;
    light->SetPosition(0.0, 0.0, 5.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    vtkAirlight::SetRadiantIntensity(light, strength);
    light->SetConeAngle(60.0);
    light->SetExponent(exponent);
    double rgb[3];
    vtkAirlight::Inscatter(medium, light, origin, direction, 0.0, 2.0, rgb);
    const double height = std::hypot(0.5, 5.0);
    const double expected = 0.3 * 7.0 *
      IsotropicAirlight(
        [exponent](double r, double) { return std::pow(5.0 / r, exponent) / (r * r); }, 0.3, 1.0,
        height, 0.0, 2.0);
    comparison.Add(
      std::abs(rgb[0] / expected - 1.0), 1e-9, [&] { return Text("exponent ", exponent); });
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// sigmaS p E (exp(-sigmaT t0) - exp(-sigmaT t1))/sigmaT; looking at the light is cosTheta = 1.
bool TestDirectional()
{
  Comparison comparison("directional light, relative");
  Random random(14);
  vtkNew<vtkParticipatingMedium> medium;
  for (int i = 0; i < 200; ++i)
  {
    SetRandomMedium(medium, random, i);
    const double irradiance[3] = { 3.0, 0.5, 7.0 };
    const glm::dvec3 position = RandomPoint(random, 10.0);
    const glm::dvec3 focalPoint = RandomPoint(random, 10.0);
    vtkNew<vtkLight> light;
    light->SetPosition(&position.x);
    light->SetFocalPoint(&focalPoint.x);
    vtkAirlight::SetIrradiance(light, irradiance);
    const glm::dvec3 origin = RandomPoint(random, 10.0);
    const glm::dvec3 direction = RandomPoint(random, 1.0);
    const double t0 = i % 2 == 0 ? 0.0 : random.Uniform(0.0, 2.0);
    const double t1 = i % 3 == 0 ? inf : t0 + random.LogUniform(1e-3, 10.0);
    double rgb[3];
    vtkAirlight::Inscatter(medium, light, &origin.x, &direction.x, t0, t1, rgb);
    const double mu = glm::dot(glm::normalize(position - focalPoint), glm::normalize(direction));
    const double p = HenyeyGreensteinPhase{ medium->GetAnisotropy() }(1.0 - mu, 1.0 + mu);
    for (int k = 0; k < 3; ++k)
    {
      const double sigmaT = medium->GetExtinction()[k];
      const double expected = medium->GetScattering()[k] * p * irradiance[k] *
        std::exp(-sigmaT * t0) * -std::expm1(-sigmaT * (t1 - t0)) / sigmaT;
      comparison.Add(std::abs(rgb[k] / expected - 1.0), medium->GetPhaseErrorBound() + 1e-9, [&] {
        return Text("g ", medium->GetAnisotropy(), ", mu ", mu, ", sigmaT ", sigmaT, ", [", t0,
          ", ", t1, "]");
      });
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// c = E/pi = I/(pi r^2): see the header of vtkAirlight.
bool TestConversion()
{
  Comparison comparison("conversion of lights, absolute");
  const auto compare = [&](const char* what, double value, double expected) {
    comparison.Add(std::abs(value - expected), 1e-14, [&] { return Text(what, " is ", value); });
  };
  vtkNew<vtkLight> light;
  light->SwitchOff();
  const double strength[3] = { 4.0, 0.0, Pi };
  vtkAirlight::SetRadiantIntensity(light, strength);
  double rgb[3];
  vtkAirlight::GetRadiantIntensity(light, rgb);
  for (int i = 0; i < 3; ++i)
  {
    compare("radiant intensity", rgb[i], strength[i]);
    compare("colour", light->GetDiffuseColor()[i] * light->GetIntensity(), strength[i] / Pi);
    compare("attenuation", light->GetAttenuationValues()[i], i == 2 ? 1.0 : 0.0);
  }
  compare("switch", light->GetSwitch(), 1.0);
  compare("positional", light->GetPositional(), 1.0);
  compare("point light", light->GetConeAngle() >= 90.0, 1.0);

  light->SetIntensity(0.5);
  light->SetDiffuseColor(0.2, 1.0, 6.0);
  vtkAirlight::GetRadiantIntensity(light, rgb);
  compare("red intensity", rgb[0], 0.1 * Pi);
  compare("green intensity", rgb[1], 0.5 * Pi);
  compare("blue intensity", rgb[2], 3.0 * Pi);

  vtkAirlight::SetIrradiance(light, strength);
  compare("directional", light->GetPositional(), 0.0);
  compare("colour of E = pi", light->GetDiffuseColor()[2] * light->GetIntensity(), 1.0);

  // A light that is switched off, or black, is no error and gives zeros.
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(1.0, 1.0, 1.0);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double direction[3] = { 1.0, 0.0, 0.0 };
  for (bool black : { false, true })
  {
    light->SetSwitch(black);
    light->SetDiffuseColor(black ? 0.0 : 1.0, 0.0, 0.0);
    std::fill_n(rgb, 3, 7.0);
    compare("success for a dark light",
      vtkAirlight::Inscatter(medium, light, origin, direction, 0.0, 1.0, rgb), 1.0);
    compare("airlight of a dark light", rgb[0] + rgb[1] + rgb[2], 0.0);
  }
  return AllOk({ &comparison });
}
}

//------------------------------------------------------------------------------
int TestAirlightLights(int, char*[])
{
  bool ok = TestAttenuation();
  ok = TestHeadlight() && ok;
  ok = TestSpotExponent() && ok;
  ok = TestDirectional() && ok;
  ok = TestConversion() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
