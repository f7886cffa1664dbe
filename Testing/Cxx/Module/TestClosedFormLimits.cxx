// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The closed form where it is hard: its special function g(x, y) over nine decades against its
// Stieltjes integral; a light near the ray and on it, at the camera, at an interval's end; empty,
// reversed and infinite intervals; clear channels; scenes a million times larger and smaller. A low sun
// over dense height fog.

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"
#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstdlib>
#include <limits>

using namespace airlight;
using namespace airlight_test;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
// g(x, y) = integral of e^-p/((p + x)^2 + y^2) over p >= 0, its Stieltjes form.
double StieltjesG(double x, double y)
{
  const auto integrand = [&](double p) { return std::exp(-p) / ((p + x) * (p + x) + y * y); };
  // e^-100 is all that is left beyond.
  return Integrate(integrand, PeakPanels(0.0L, 100.0L, std::hypot(x, y)), 1e-14);
}

bool TestG()
{
  Comparison inDouble("g(x, y) in double precision, relative");
  Comparison inFloat("g(x, y) in single precision, relative");
  constexpr int Steps = 72; // eight a decade
  for (int i = 0; i <= Steps; ++i)
  {
    for (int j = 0; j <= Steps; ++j)
    {
      const double x = 1e-6 * std::pow(10.0, i / 8.0);
      const double y = 1e-6 * std::pow(10.0, j / 8.0);
      const auto describe = [&] { return Text("x ", x, ", y ", y); };
      const double g = StieltjesG(x, y);
      inDouble.Add(std::abs(f64::airlightG(x, y) - g) / g, 1e-11, describe);
      const float fx = static_cast<float>(x);
      const float fy = static_cast<float>(y);
      const double rounded = StieltjesG(fx, fy);
      inFloat.Add(std::abs(f32::airlightG(fx, fy) - rounded) / rounded, 1e-6, describe);
    }
  }
  return AllOk({ &inDouble, &inFloat });
}

//------------------------------------------------------------------------------
// A light on the ray and outside the interval: r = |x|, and cosTheta is 1 in front of the light
// (x < 0) and -1 behind it, so the integrand is p(cosTheta) exp(-sigmaT (tL + x + |x|))/x^2.
bool TestLightOnRay()
{
  Comparison comparison("light on the ray, relative");
  Random random(7);
  for (int i = 0; i < 300; ++i)
  {
    vtkNew<vtkParticipatingMedium> medium;
    medium->SetPhaseFunctionToHenyeyGreenstein();
    medium->SetAnisotropy(i % 3 == 0 ? 0.0 : random.Uniform(-0.9, 0.9));
    const double sigmaT = random.LogUniform(1e-3, 10.0);
    medium->SetScattering(sigmaT, sigmaT, sigmaT);
    const bool behind = i % 2 == 0;
    const double tL = behind ? -random.LogUniform(1e-3, 20.0) : random.LogUniform(1e-3, 20.0);
    const double t0 = behind ? random.Uniform(0.0, 5.0) : random.Uniform(0.0, 0.5) * tL;
    const double t1 = behind ? t0 + random.LogUniform(1e-3, 50.0) : random.Uniform(0.6, 0.999) * tL;
    const double light[3] = { tL, 0.0, 0.0 };
    const double origin[3] = { 0.0, 0.0, 0.0 };
    const double direction[3] = { 2.5, 0.0, 0.0 };
    const double intensity[3] = { 1.0, 1.0, 1.0 };
    double rgb[3];
    vtkAirlight::Inscatter(medium, light, intensity, origin, direction, t0, t1, rgb);
    const HenyeyGreensteinPhase phase{ medium->GetAnisotropy() };
    const auto integrand = [&](double x) {
      return sigmaT * phase(x < 0.0 ? 0.0 : 2.0, 0.0) * std::exp(-sigmaT * (tL + x + std::abs(x))) /
        (x * x);
    };
    const double expected =
      Integrate(integrand, PeakPanels(t0 - tL, t1 - tL, 1e-3 * std::abs(tL)), 1e-13);
    comparison.Add(
      std::abs(rgb[1] - expected) / expected, medium->GetPhaseErrorBound() + 1e-9, [&] {
        return Text("sigmaT ", sigmaT, ", g ", medium->GetAnisotropy(), ", tL ", tL, ", t0 ", t0,
          ", t1 ", t1, "; expected ", expected, ", got ", rgb[1]);
      });
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// A scene of unit size, its light, ray and interval scaled by `Scale` and moved to `Origin`.
struct Scene
{
  double Scale;
  double Origin; // in units of Scale
  double Light[3];
  double T0;
  double T1;
};

std::string Describe(const Scene& s, vtkParticipatingMedium* m)
{
  return Text("scale ", s.Scale, ", origin ", s.Origin, ", light ", Text3(s.Light), ", [", s.T0,
    ", ", s.T1, "], g ", m->GetAnisotropy(), ", sigmaS ", Text3(m->GetScattering()), ", sigmaT ",
    Text3(m->GetExtinction()));
}

// 0 where the answer is finite, not negative, and zero where it must be: in an empty interval and
// in a channel that does not scatter.
bool IsSound(const double rgb[3], const Scene& scene, vtkParticipatingMedium* medium)
{
  bool ok = true;
  for (int i = 0; i < 3; ++i)
  {
    const bool dark = !(scene.T1 > std::max(scene.T0, 0.0)) || medium->GetScattering()[i] == 0.0;
    ok = ok && std::isfinite(rgb[i]) && rgb[i] >= 0.0 && (!dark || rgb[i] == 0.0);
  }
  return ok;
}

void CheckDouble(const Scene& s, vtkParticipatingMedium* medium, Comparison& comparison)
{
  double light[3];
  for (int i = 0; i < 3; ++i)
  {
    light[i] = s.Scale * (s.Origin + s.Light[i]);
  }
  const double origin[3] = { s.Scale * s.Origin, s.Scale * s.Origin, s.Scale * s.Origin };
  const double direction[3] = { 1.0, 0.0, 0.0 };
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  double rgb[3];
  const bool done = vtkAirlight::Inscatter(
    medium, light, intensity, origin, direction, s.Scale * s.T0, s.Scale * s.T1, rgb);
  comparison.Add(done && IsSound(rgb, s, medium) ? 0.0 : 1.0, 0.5,
    [&] { return Text(Describe(s, medium), "; got ", Text3(rgb)); });
}

// The shaders' way: rays no closer to a light than 1e-5 of its distance, as vtkAirlightPass
// documents, and the interval inside [0, 1e18].
void CheckFloat(const Scene& s, vtkParticipatingMedium* m, Comparison& comparison)
{
  f32::AirlightMedia media{};
  media.count = 1;
  f32::AirlightMedium& medium = media.item[0];
  medium.sigmaS = glm::vec3(glm::make_vec3(m->GetScattering()));
  medium.sigmaT = glm::vec3(glm::make_vec3(m->GetExtinction()));
  medium.phase = GetPhase<f32::AirlightPhase>(m);
  f32::AirlightLight light{};
  light.kind = AIRLIGHT_POINT_CLOSED;
  light.cosCone = -1.0f;
  light.position = glm::vec3(s.Scale * glm::make_vec3(s.Light));
  light.intensity = glm::vec3(1.0f);
  light.attenuation = glm::vec3(0.0f, 0.0f, 1.0f);
  light.radius = 1e-5f * std::max(glm::length(light.position), static_cast<float>(0.01 * s.Scale));
  const float t0 = static_cast<float>(std::clamp(s.Scale * s.T0, 0.0, 1e18));
  const float t1 = static_cast<float>(std::clamp(s.Scale * s.T1, 0.0, 1e18));
  const f32::AirlightRay ray =
    f32::airlightRay(media, light, glm::vec3(0.0f), glm::vec3(1.0f, 0.0f, 0.0f), t1);
  const glm::vec3 value = f32::airlightInterval3(media, light, ray, t0,
    f32::airlightTail3(media, light, ray, t0), t1, f32::airlightTail3(media, light, ray, t1));
  const double rgb[3] = { value.x, value.y, value.z };
  // Reversed intervals are the caller's to leave out.
  comparison.Add(t1 < t0 || IsSound(rgb, s, m) ? 0.0 : 1.0, 0.5,
    [&] { return Text(Describe(s, m), "; got ", Text3(rgb)); });
}

//------------------------------------------------------------------------------
bool TestSpecialCases()
{
  Comparison inDouble("special cases, vtkAirlight (0 sound, 1 not)");
  Comparison inFloat("special cases, single precision (0 sound, 1 not)");
  const double extinctions[][2][3] = { { { 0, 0, 0 }, { 0, 0, 0 } }, { { 0.5, 0, 2 }, { 0, 0, 1 } },
    { { 0, 0, 0 }, { 1, 2, 0 } }, { { 1, 1, 1 }, { 0, 0, 0 } },
    { { 1e-9, 1e-300, 1e3 }, { 0, 0, 1e3 } } };
  const double lights[][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1e-9, 0 },
    { 1, 1e-300, 0 }, { 0, 1e-12, 0 }, { 1.5, 1, 0 }, { -3, 0.5, 2 }, { 1e5, 1e5, 0 },
    { 0.5, 1e4, 0 } };
  const double intervals[][2] = { { 0, 0 }, { 1, 1 }, { 2, 1 }, { 0, 1 }, { 1, 2 }, { 0, 2 },
    { 1.5, 1.5 + 1e-12 }, { -5, 1.5 }, { -2, -1 }, { 0, inf }, { 1, inf }, { 1e5, inf },
    { 0, 1e200 }, { -inf, inf } };
  for (const double g : { 0.0, 0.99, -0.99, 0.4 })
  {
    vtkNew<vtkParticipatingMedium> medium;
    medium->SetPhaseFunctionToHenyeyGreenstein();
    medium->SetAnisotropy(g);
    for (const auto& sigma : extinctions)
    {
      medium->SetScattering(sigma[0]);
      medium->SetAbsorption(sigma[1]);
      for (const auto& light : lights)
      {
        for (const auto& interval : intervals)
        {
          for (const double scale : { 1.0, 1e6, 1e-6 })
          {
            Scene scene = { scale, 0.0, { light[0], light[1], light[2] }, interval[0],
              interval[1] };
            CheckFloat(scene, medium, inFloat);
            CheckDouble(scene, medium, inDouble);
            scene.Origin = 3.7;
            CheckDouble(scene, medium, inDouble);
          }
        }
      }
    }
  }
  return AllOk({ &inDouble, &inFloat });
}

//------------------------------------------------------------------------------
// The sun over height fog, and a ray of that fog. With D(t) the density's integral over [0, t], H the
// scale height and mu the sun's rise, the optical depth of view and sun together is
// tau(t) = sigma (D(t) + rho(t) H/mu), and d tau = sigma (1 - m/mu) rho dt.
struct LowSun
{
  double ScaleHeight;
  double EyeHeight;
  double Rise; // m
  double SunRise;
  double End;
  glm::dvec3 Sigma;

  long double Density(long double t) const
  {
    return std::exp(-(this->EyeHeight + this->Rise * t) / this->ScaleHeight);
  }

  // sigma times the integral of rho exp(-tau).
  double GetExpected(int k) const
  {
    const long double rate = this->Rise / this->ScaleHeight;
    const long double column = this->Density(0.0L) * -std::expm1(-rate * this->End) / rate;
    const long double above = this->ScaleHeight / this->SunRise;
    const long double first = this->Sigma[k] * this->Density(0.0L) * above;
    const long double last = this->Sigma[k] * (column + this->Density(this->End) * above);
    const long double slope = 1.0L - static_cast<long double>(this->Rise) / this->SunRise;
    return static_cast<double>(
      std::exp(-std::min(first, last)) * -std::expm1(-std::abs(first - last)) / std::abs(slope));
  }

  template <typename Medium, typename Light, typename Ray>
  void Set(Medium& medium, Light& light, Ray& ray) const
  {
    const double level = std::sqrt(1.0 - this->Rise * this->Rise);
    const double sunLevel = std::sqrt(1.0 - this->SunRise * this->SunRise);
    medium.sigmaS = this->Sigma;
    medium.sigmaT = this->Sigma;
    medium.phase.power = glm::dvec2(1.0, 0.0); // the same in all directions
    medium.density = AIRLIGHT_DENSITY_HEIGHT;
    medium.up = glm::dvec3(0.0, 1.0, 0.0);
    medium.inverseScaleHeight = static_cast<float>(1.0 / this->ScaleHeight);
    medium.originHeight = static_cast<float>(this->EyeHeight);
    light.position = glm::dvec3(0.0, this->SunRise, sunLevel);
    ray.direction = glm::dvec3(level, this->Rise, 0.0);
    ray.range = glm::dvec2(0.0, this->End);
  }
};

bool TestLowSun()
{
  Comparison inDouble("low sun over height fog, double precision, relative");
  Comparison inFloat("low sun over height fog, single precision, relative");
  Random random(11);
  for (int i = 0; i < 20000; ++i)
  {
    LowSun sun;
    // Numbers that single precision holds, for one expected value.
    sun.ScaleHeight = 1.0 / Rounded(1.0 / random.LogUniform(1e-3, 1e3));
    sun.EyeHeight = Rounded(sun.ScaleHeight * random.Uniform(-8.0, 8.0));
    sun.Rise = Rounded((i % 2 ? 1.0 : -1.0) * random.LogUniform(1e-3, 0.9));
    sun.SunRise = Rounded(random.LogUniform(1e-4, 0.9));
    sun.End = Rounded(sun.ScaleHeight * random.LogUniform(1e-2, 1e3));
    sun.Sigma = glm::dvec3(Rounded(random.LogUniform(1e-4, 1e4) / sun.ScaleHeight), 0.0, 0.0);
    const auto describe = [&] {
      return Text("scale height ", sun.ScaleHeight, ", eye at ", sun.EyeHeight, ", rises ",
        sun.Rise, " and ", sun.SunRise, ", end ", sun.End, ", sigma ", sun.Sigma.x, "; expected ",
        sun.GetExpected(0));
    };
    const double expected = std::max(sun.GetExpected(0), 1e-12);
    const auto add = [&](const auto& got, double limit, Comparison& comparison) {
      const double error = std::abs(got.x - sun.GetExpected(0)) / expected;
      comparison.Add(got.y == 0 && got.z == 0 ? error : inf, limit, describe);
    };
    f64::AirlightMedium medium64{};
    f64::AirlightLight light64{};
    f64::AirlightRay ray64{};
    sun.Set(medium64, light64, ray64);
    add(f64::airlightDirectionalHeight(medium64, light64, ray64, 0.0, sun.End), 3e-12, inDouble);
    f32::AirlightMedium medium32{};
    f32::AirlightLight light32{};
    f32::AirlightRay ray32{};
    sun.Set(medium32, light32, ray32);
    add(glm::dvec3(f32::airlightDirectionalHeight(
          medium32, light32, ray32, 0.0f, static_cast<float>(sun.End))),
      6e-5, inFloat);
  }
  return AllOk({ &inDouble, &inFloat });
}
}

//------------------------------------------------------------------------------
int TestClosedFormLimits(int, char*[])
{
  bool ok = TestG();
  ok = TestLightOnRay() && ok;
  ok = TestSpecialCases() && ok;
  ok = TestLowSun() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
