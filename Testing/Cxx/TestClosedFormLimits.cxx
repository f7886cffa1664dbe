// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The closed form where it is hard: its special function g(x, y) over nine decades against its
// Stieltjes integral; a light near the ray and on it, at the camera, at an interval's end; empty,
// reversed and infinite intervals; clear channels; scenes a million times larger and smaller.

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "AirlightMath.h"
#include "AirlightTestPhase.h"
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
}

//------------------------------------------------------------------------------
int TestClosedFormLimits(int, char*[])
{
  bool ok = TestG();
  ok = TestLightOnRay() && ok;
  ok = TestSpecialCases() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
