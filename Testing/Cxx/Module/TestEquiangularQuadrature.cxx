// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A point light's airlight before every point of a ray by AirlightEquiangular.glsl, as the shaders'
// text compiled in double and in single precision, against the closed form in double precision
// (which TestClosedForm compares with quadrature). The limits are parts of the whole ray's
// airlight, as in the error contract of the documentation.

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace airlight;
using namespace airlight_test;

namespace
{
// The light's foot is at tL, its distance from the ray h; the ray is [0, l], its channels fade by
// SigmaT.
struct Setting
{
  glm::dvec3 SigmaT;
  double TL;
  double H;
  double Length;
  std::vector<double> Places;

  std::string Describe() const
  {
    return Text("sigmaT ", this->SigmaT.x, " ", this->SigmaT.y, " ", this->SigmaT.z, ", tL ",
      this->TL, ", h ", this->H, ", length ", this->Length);
  }
};

Setting RandomSetting(Random& random)
{
  Setting s;
  const double sigmaT = random.LogUniform(1e-3, 10.0);
  const bool grey = random.Index(2) == 0;
  for (int k = 0; k < 3; ++k)
  {
    s.SigmaT[k] = Rounded(grey || k == 0 ? sigmaT : sigmaT * random.LogUniform(1e-3, 1e3));
  }
  s.TL = Rounded(random.Uniform(-30.0, 60.0));
  s.H = Rounded(random.LogUniform(1e-3, 100.0));
  s.Length = Rounded(random.Index(4) == 0 ? 1e18 : random.LogUniform(1e-3, 1e3));
  for (int i = 0; i < 6; ++i)
  {
    const double place =
      i % 2 ? random.Uniform(0.0, std::min(s.Length, 100.0)) : s.TL + s.H * random.Uniform(-2, 2);
    s.Places.push_back(Rounded(std::clamp(place, 0.0, s.Length)));
  }
  s.Places.push_back(s.Length);
  std::sort(s.Places.begin(), s.Places.end());
  return s;
}

// The sums of one precision: what is scattered before each place, per unit sigmaS I.
template <typename Ray, typename Medium, typename Phase>
void Prepare(const Setting& s, const Phase& phase, Medium& medium, Ray& ray)
{
  using Vector = decltype(medium.sigmaT);
  medium.phase = phase;
  medium.sigmaT = Vector(s.SigmaT);
  medium.sigmaS = medium.sigmaT;
  medium.region.kind = AIRLIGHT_REGION_UNBOUNDED;
  ray.direction = Vector(0, 0, 1);
  ray.range = decltype(ray.range)(0.0, s.Length);
  ray.lit = ray.range;
  ray.foot.tL = s.TL;
  ray.foot.h = s.H;
  ray.litFromFoot = ray.lit - ray.foot.tL;
  ray.litWay = ray.lit.y - ray.lit.x;
}

struct Sums
{
  std::vector<glm::dvec3> Before;   // each place
  std::vector<glm::dvec3> After;    // in closed form; -1 where too much of the light is left
  glm::dvec3 Whole{ 0.0 };          // by parts that are not kept
  std::vector<glm::dvec3> Tangents; // between each place and the next, for an isotropic medium
};

Sums SumDouble(const Setting& s, const f64::AirlightPhase& phase)
{
  f64::AirlightMedium medium{};
  f64::AirlightRay ray{};
  Prepare(s, phase, medium, ray);
  const f64::AirlightEquiangular arc = f64::airlightEquiangularRange(medium, ray, 0.0, s.Length);
  Sums sums;
  sums.Whole = f64::airlightEquiangularQuadrature(medium, ray, 0.0, s.Length) / s.H;
  sums.Before.resize(s.Places.size(), glm::dvec3(0.0));
  for (double psi = 0.0; psi < arc.end;)
  {
    const double end = f64::airlightEquiangularPanelEnd(medium, arc, psi);
    const f64::AirlightEquiangularPanel part = f64::airlightEquiangularPanel(medium, arc, psi, end);
    for (size_t i = 0; i < s.Places.size(); ++i)
    {
      sums.Before[i] +=
        f64::airlightEquiangularPanelTo(part, f64::airlightAngleAt(arc, ray, s.Places[i])) / s.H;
    }
    psi = end;
  }
  const double least = f64::airlightLeastDepthPerTangent(medium, arc.h);
  const double reach = f64::airlightHalfAngleReach(arc, ray, s.Length);
  for (size_t i = 0; i < s.Places.size(); ++i)
  {
    const double done = f64::airlightHalfAngleReach(arc, ray, s.Places[i]);
    const bool open = least * (reach - done) > 24.0; // AIRLIGHT_NEGLIGIBLE_DEPTH
    sums.After.push_back(
      open ? f64::airlightEquiangularRest(medium, arc, done) / s.H : glm::dvec3(-1.0));
    const double from = i > 0 ? s.Places[i - 1] : 0.0;
    sums.Tangents.push_back(f64::airlightHalfAngleQuadrature(medium, ray, from, s.Places[i]) / s.H);
  }
  return sums;
}

Sums SumSingle(const Setting& s, const f32::AirlightPhase& phase)
{
  f32::AirlightMedium medium{};
  f32::AirlightRay ray{};
  Prepare(s, phase, medium, ray);
  const f32::AirlightEquiangular arc = f32::airlightEquiangularRange(medium, ray, 0.0f, ray.lit.y);
  Sums sums;
  sums.Whole =
    glm::dvec3(f32::airlightEquiangularQuadrature(medium, ray, 0.0f, ray.lit.y) / ray.foot.h);
  sums.Before.resize(s.Places.size(), glm::dvec3(0.0));
  for (float psi = 0.0f; psi < arc.end;)
  {
    const float end = f32::airlightEquiangularPanelEnd(medium, arc, psi);
    const f32::AirlightEquiangularPanel part = f32::airlightEquiangularPanel(medium, arc, psi, end);
    for (size_t i = 0; i < s.Places.size(); ++i)
    {
      const float at = f32::airlightAngleAt(arc, ray, static_cast<float>(s.Places[i]));
      sums.Before[i] += glm::dvec3(f32::airlightEquiangularPanelTo(part, at) / ray.foot.h);
    }
    psi = end;
  }
  const float least = f32::airlightLeastDepthPerTangent(medium, arc.h);
  const float reach = f32::airlightHalfAngleReach(arc, ray, ray.lit.y);
  for (size_t i = 0; i < s.Places.size(); ++i)
  {
    const float done = f32::airlightHalfAngleReach(arc, ray, static_cast<float>(s.Places[i]));
    const bool open = least * (reach - done) > 14.0f; // AIRLIGHT_NEGLIGIBLE_DEPTH
    sums.After.push_back(open
        ? glm::dvec3(f32::airlightEquiangularRest(medium, arc, done) / ray.foot.h)
        : glm::dvec3(-1.0));
    const float from = i > 0 ? static_cast<float>(s.Places[i - 1]) : 0.0f;
    sums.Tangents.push_back(glm::dvec3(f32::airlightHalfAngleQuadrature(
                              medium, ray, from, static_cast<float>(s.Places[i]))) /
      s.H);
  }
  return sums;
}

// The only phase function whose rests the shaders take in closed form, in single precision.
bool IsIsotropic(const f64::AirlightPhase& phase)
{
  return phase.poleCount == 1 && phase.order == 1 && phase.pole[0].x == 1.0 && phase.power.x == 0.0;
}

// What is scattered between two places, per unit sigmaS I. Of Mie's functions ("hazy" and "murky")
// there is no closed form: by quadrature in the angle at the light's foot, where the inverse square
// is a constant, with the textbook's formula.
double GetExact(const Setting& s, const f64::AirlightPhase& phase, double mieExponent,
  double sigmaT, double from, double to)
{
  if (mieExponent == 0.0)
  {
    return f64::airlightSegment(phase, sigmaT, { s.TL, s.H }, from, to);
  }
  const auto integrand = [&](double angle) {
    const double half = 0.5 * (1.0 - std::sin(angle)); // half of 1 + the cosine of scattering
    const double mie =
      (0.5 + 0.5 * (mieExponent + 1.0) * std::pow(half, mieExponent)) / (4.0 * M_PI);
    const double way = s.TL + s.H * (std::tan(angle) + 1.0 / std::cos(angle));
    return mie * std::exp(-sigmaT * way) / s.H;
  };
  const auto angle = [&s](double t) { return std::atan((t - s.TL) / s.H); };
  std::vector<long double> ends;
  for (int i = 0; i <= 16; ++i)
  {
    ends.push_back(angle(from) + (static_cast<long double>(angle(to)) - angle(from)) * i / 16.0L);
  }
  return Integrate(integrand, ends, 1e-10);
}

// `mieExponent`: of Mie's function, 0 for others.
bool ComparePhase(
  const std::string& name, vtkParticipatingMedium* medium, Random& random, double mieExponent = 0.0)
{
  Comparison inDouble(name + ", double precision, of the whole ray");
  Comparison inSingle(name + ", single precision, of the whole ray");
  Comparison afterInDouble(name + ", rests in double precision, of the whole ray");
  Comparison afterInSingle(name + ", rests in single precision, of the whole ray");
  Comparison tangentsInDouble(name + ", without angles in double precision");
  Comparison tangentsInSingle(name + ", without angles in single precision");
  const auto phase = GetPhase<f64::AirlightPhase>(medium);
  const auto narrowPhase = GetPhase<f32::AirlightPhase>(medium);
  const int settings = mieExponent > 0.0 ? 300 : 1500; // quadrature takes longer
  for (int n = 0; n < settings; ++n)
  {
    const Setting s = RandomSetting(random);
    const Sums wide = SumDouble(s, phase);
    const Sums narrow = SumSingle(s, narrowPhase);
    for (int k = 0; k < 3; ++k)
    {
      const auto exact = [&](double from, double to) {
        return GetExact(s, phase, mieExponent, s.SigmaT[k], from, to);
      };
      const double whole = exact(0.0, s.Length);
      if (whole <= 1e-28) // lost in single precision
      {
        continue;
      }
      const auto describeRay = [&] { return s.Describe(); };
      inDouble.Add(std::abs(wide.Whole[k] - whole) / whole, 5e-5, describeRay);
      inSingle.Add(std::abs(narrow.Whole[k] - whole) / whole, 1e-4, describeRay);
      for (size_t i = 0; i < s.Places.size(); ++i)
      {
        const double expected = s.Places[i] > 0.0 ? exact(0.0, s.Places[i]) : 0.0;
        const auto describe = [&] { return Text(s.Describe(), ", at ", s.Places[i]); };
        inDouble.Add(std::abs(wide.Before[i][k] - expected) / whole, 5e-5, describe);
        inSingle.Add(std::abs(narrow.Before[i][k] - expected) / whole, 1e-4, describe);
        if (IsIsotropic(phase))
        {
          const double from = i > 0 ? s.Places[i - 1] : 0.0;
          const double between = s.Places[i] > from ? exact(from, s.Places[i]) : 0.0;
          tangentsInDouble.Add(std::abs(wide.Tangents[i][k] - between) / whole, 2e-6, describe);
          tangentsInSingle.Add(std::abs(narrow.Tangents[i][k] - between) / whole, 1e-4, describe);
        }
        if (mieExponent > 0.0)
        {
          continue; // the shaders take no rests of it
        }
        const double rest = s.Places[i] < s.Length ? exact(s.Places[i], s.Length) : 0.0;
        if (wide.After[i][k] >= 0.0)
        {
          afterInDouble.Add(std::abs(wide.After[i][k] - rest) / whole, 1e-9, describe);
        }
        if (narrow.After[i][k] >= 0.0 && IsIsotropic(phase))
        {
          afterInSingle.Add(std::abs(narrow.After[i][k] - rest) / whole, 1e-4, describe);
        }
      }
    }
  }
  const bool ok =
    AllOk({ &inDouble, &inSingle }) && (mieExponent > 0.0 || AllOk({ &afterInDouble }));
  return (!IsIsotropic(phase) || AllOk({ &afterInSingle, &tangentsInDouble, &tangentsInSingle })) &&
    ok;
}
}

//------------------------------------------------------------------------------
int TestEquiangularQuadrature(int, char*[])
{
  Random random(11);
  vtkNew<vtkParticipatingMedium> medium;
  bool ok = ComparePhase("isotropic", medium, random);
  medium->SetPhaseFunctionToRayleigh();
  ok = ComparePhase("Rayleigh", medium, random) && ok;
  medium->SetPhaseFunctionToSchlick();
  medium->SetAnisotropy(0.7);
  ok = ComparePhase("Schlick 0.7", medium, random) && ok;
  medium->SetPhaseFunctionToHenyeyGreenstein();
  for (double g : { -0.6, 0.5, 0.85, 0.95 })
  {
    medium->SetAnisotropy(g);
    ok = ComparePhase(Text("Henyey-Greenstein ", g), medium, random) && ok;
  }
  medium->SetPhaseFunctionToMieHazy();
  ok = ComparePhase("Mie hazy", medium, random, 8.0) && ok;
  medium->SetPhaseFunctionToMieMurky();
  ok = ComparePhase("Mie murky", medium, random, 32.0) && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
