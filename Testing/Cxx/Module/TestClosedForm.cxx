// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The closed form of a point light's airlight, as the shaders' text compiled in double and in
// single precision and through vtkAirlight, against adaptive quadrature of the integrand itself
// (AirlightTestQuadrature.h). The limits are those of the error contract in the documentation.

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "AirlightTestErrors.h"
#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"
#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cstdlib>

using namespace airlight;
using namespace airlight_test;

namespace
{
constexpr double Far = 1e18;         // what stands for an infinite ray in the shaders
constexpr double Underflow = 1e-290; // below, digits are lost with the smallest doubles

// One light, one ray: the light's foot is at tL, its distance from the ray is h.
struct Setting
{
  double SigmaT;
  double TL;
  double H;
  double T0;
  double T1;

  std::string Describe() const
  {
    return Text("sigmaT ", this->SigmaT, ", tL ", this->TL, ", h ", this->H, ", t0 ", this->T0,
      ", t1 ", this->T1);
  }
};

Setting RandomSetting(Random& random)
{
  Setting s;
  s.SigmaT = random.LogUniform(1e-3, 10.0);
  s.TL = random.Uniform(-20.0, 20.0);
  s.H = random.LogUniform(1e-4, 20.0);
  const int kind = random.Index(5);
  s.T0 = kind == 0 || kind == 4 ? 0.0 : random.Uniform(0.0, 40.0);
  const double length = kind == 1 ? random.LogUniform(1e-6, 1.0) : random.LogUniform(1e-2, 300.0);
  s.T1 = kind == 3 ? Far : s.T0 + length;
  if (kind == 4) // a surface near the light
  {
    s.T1 = std::max(s.TL + s.H * random.Uniform(-3.0, 3.0), 1e-2);
  }
  return s;
}

Setting RoundToFloat(const Setting& s)
{
  return { Rounded(s.SigmaT), Rounded(s.TL), Rounded(s.H), Rounded(s.T0), Rounded(s.T1) };
}

template <typename Phase>
double Expected(const Phase& phase, const Setting& s)
{
  return PointLightAirlight(phase, s.SigmaT, s.TL, s.H, s.T0, s.T1);
}

f64::AirlightPhase Isotropic()
{
  f64::AirlightPhase phase{};
  phase.poleCount = 1;
  phase.order = 1;
  phase.pole[0] = glm::dvec4(1.0, 0.25 / Pi, 0.0, 0.0);
  return phase;
}

std::string Describe(vtkParticipatingMedium* medium, const Setting& s)
{
  return Text(DescribePhase(medium), ", ", s.Describe());
}

//------------------------------------------------------------------------------
// Double precision against quadrature, relative to the interval's integral: 1e-9. Once isotropic
// (p = 1/4pi is g = 0), once with the medium's fit.
void CompareDouble(
  const Setting& s, vtkParticipatingMedium* medium, Comparison& isotropic, Comparison& fitted)
{
  const f64::AirlightFoot foot = { s.TL, s.H };
  const double expected = Expected(HenyeyGreensteinPhase{ 0.0 }, s);
  const double value = f64::airlightSegment(Isotropic(), s.SigmaT, foot, s.T0, s.T1);
  if (expected > Underflow)
  {
    isotropic.Add(std::abs(value - expected) / expected, 1e-9, [&] { return s.Describe(); });
  }
  const auto fit = GetPhase<f64::AirlightPhase>(medium);
  const double expectedFit =
    Expected([&](double minus, double plus) { return FittedPhase(fit, minus, plus); }, s);
  const double valueFit = f64::airlightSegment(fit, s.SigmaT, foot, s.T0, s.T1);
  if (expectedFit > Underflow)
  {
    fitted.Add(
      std::abs(valueFit - expectedFit) / expectedFit, 1e-9, [&] { return Describe(medium, s); });
  }
}

//------------------------------------------------------------------------------
// Single precision: 1e-4 of the ray's unshadowed airlight on [0, t1]. Below 1e-37 a float has lost
// its digits.
void CompareFloat(const Setting& exact, vtkParticipatingMedium* medium, Comparison& comparison)
{
  const Setting s = RoundToFloat(exact);
  const auto fit = GetPhase<f32::AirlightPhase>(medium);
  const auto phase = [&](double minus, double plus) { return FittedPhase(fit, minus, plus); };
  const Setting whole = { s.SigmaT, s.TL, s.H, 0.0, s.T1 };
  const double unshadowed = Expected(phase, whole);
  const double expected = s.T0 > 0.0 ? Expected(phase, s) : unshadowed;
  const f32::AirlightFoot foot = { static_cast<float>(s.TL), static_cast<float>(s.H) };
  const float value = f32::airlightSegment(
    fit, static_cast<float>(s.SigmaT), foot, static_cast<float>(s.T0), static_cast<float>(s.T1));
  comparison.Add(std::abs(value - expected), 1e-4 * unshadowed + 1e-37,
    [&] { return Text(Describe(medium, s), "; expected ", expected, ", got ", value); });
}

//------------------------------------------------------------------------------
// vtkAirlight with the exact phase function: `limit` plus the bound of the fit. A ray in any
// direction, and another extinction in each channel.
void CompareApi(const Setting& s, vtkParticipatingMedium* medium, const ReferencePhase& phase,
  double limit, Random& random, Comparison& comparison)
{
  const double origin[3] = { random.Uniform(-5, 5), random.Uniform(-5, 5), random.Uniform(-5, 5) };
  const glm::dvec3 d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(0.1, 1));
  const glm::dvec3 across = glm::cross(d, glm::dvec3(0.3, 0.8, -0.2));
  double light[3];
  for (int i = 0; i < 3; ++i)
  {
    light[i] = origin[i] + s.TL * d[i] / glm::length(d) + s.H * across[i] / glm::length(across);
  }
  const double sigmaS[3] = { 0.7 * s.SigmaT, s.SigmaT, random.LogUniform(1e-3, 5.0) };
  medium->SetScattering(sigmaS);
  medium->SetAbsorption(0.3 * s.SigmaT, 0.0, random.LogUniform(1e-3, 5.0));
  const double intensity[3] = { 3.0, 4.0 * Pi, 0.5 };
  double rgb[3];
  vtkAirlight::Inscatter(medium, light, intensity, origin, &d.x, s.T0, s.T1, rgb);

  // The foot, from what was really handed over.
  using real3 = glm::tvec3<long double>;
  const real3 direction = glm::normalize(real3(d));
  const real3 toLight =
    real3(light[0], light[1], light[2]) - real3(origin[0], origin[1], origin[2]);
  const long double tL = glm::dot(toLight, direction);
  const long double h = glm::length(glm::cross(toLight, direction));
  const double* sigmaT = medium->GetExtinction();
  for (int i = 0; i < 3; ++i)
  {
    const double expected = sigmaS[i] * intensity[i] *
      PointLightAirlight(phase, sigmaT[i], tL, h, s.T0, s.T1, phase.GetKinks());
    if (expected > Underflow)
    {
      comparison.Add(std::abs(rgb[i] - expected) / expected, medium->GetPhaseErrorBound() + limit,
        [&] { return Text("channel ", i, " of sigmaT ", sigmaT[i], "; ", Describe(medium, s)); });
    }
  }
}

//------------------------------------------------------------------------------
// I[a, b] + I[b, c] = I[a, c], each within the contract of 1e-9.
void CompareSum(const Setting& s, Random& random, Comparison& comparison)
{
  const f64::AirlightFoot foot = { s.TL, s.H };
  const double end = std::min(s.T1, s.T0 + 300.0);
  const double middle = random.Uniform(s.T0, end);
  const double sum = f64::airlightSegment(Isotropic(), s.SigmaT, foot, s.T0, middle) +
    f64::airlightSegment(Isotropic(), s.SigmaT, foot, middle, s.T1);
  const double whole = f64::airlightSegment(Isotropic(), s.SigmaT, foot, s.T0, s.T1);
  if (whole > Underflow)
  {
    comparison.Add(
      std::abs(sum - whole) / whole, 2e-9, [&] { return Text(s.Describe(), ", middle ", middle); });
  }
}

//------------------------------------------------------------------------------
bool TestRandomSettings()
{
  Comparison isotropic("double precision, isotropic, relative");
  Comparison fitted("double precision, fitted phase, relative");
  Comparison api("vtkAirlight, exact phase function, relative");
  Comparison single("single precision, of the ray's airlight");
  Comparison sum("additivity, relative");
  Random random(20240611);
  constexpr int Media = 250;
  constexpr int SettingsPerMedium = 40; // 10 000 in all
  const int types[] = { vtkParticipatingMedium::HENYEY_GREENSTEIN, vtkParticipatingMedium::RAYLEIGH,
    vtkParticipatingMedium::SCHLICK, vtkParticipatingMedium::CORNETTE_SHANKS };
  for (int m = 0; m < Media; ++m)
  {
    vtkNew<vtkParticipatingMedium> medium;
    medium->SetPhaseFunction(types[m % 4]);
    if (types[m % 4] != vtkParticipatingMedium::RAYLEIGH)
    {
      medium->SetAnisotropy(m % 5 == 0 ? 0.0 : random.Uniform(-0.9, 0.9));
    }
    medium->SetPhaseTolerance(m / 4 % 2 == 0 ? 1e-3 : 1e-5);
    const ReferencePhase phase(medium);
    for (int i = 0; i < SettingsPerMedium; ++i)
    {
      const Setting s = RandomSetting(random);
      CompareDouble(s, medium, isotropic, fitted);
      CompareFloat(s, medium, single);
      CompareApi(s, medium, phase, 1e-9, random, api);
      CompareSum(s, random, sum);
    }
  }
  return AllOk({ &isotropic, &fitted, &api, &single, &sum });
}

//------------------------------------------------------------------------------
// Mie's functions, which vtkAirlight integrates by adaptive quadrature, and tables.
bool TestOtherFunctions()
{
  Comparison mie("vtkAirlight, Mie's functions, relative");
  Comparison tables("vtkAirlight, tables, relative");
  Random random(20240612);
  constexpr int SettingsPerMedium = 60;
  for (int m = 0; m < 2 + TEST_TABLES; ++m)
  {
    vtkNew<vtkParticipatingMedium> medium;
    ErrorListener warnings(medium, vtkCommand::WarningEvent);
    medium->SetPhaseFunction(m == 0 ? vtkParticipatingMedium::MIE_HAZY
        : m == 1                    ? vtkParticipatingMedium::MIE_MURKY
                                    : vtkParticipatingMedium::TABULATED);
    if (m > 1)
    {
      medium->SetPhaseTable(MakeTable(m - 2));
    }
    const ReferencePhase phase(medium);
    for (int i = 0; i < SettingsPerMedium; ++i)
    {
      CompareApi(RandomSetting(random), medium, phase, 1e-8, random, m < 2 ? mie : tables);
    }
  }
  return AllOk({ &mie, &tables });
}
}

//------------------------------------------------------------------------------
int TestClosedForm(int, char*[])
{
  const bool random = TestRandomSettings();
  return TestOtherFunctions() && random ? EXIT_SUCCESS : EXIT_FAILURE;
}
