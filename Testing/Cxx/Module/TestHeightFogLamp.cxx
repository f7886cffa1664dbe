// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A lamp in fog that falls with height by AirlightHeightFogLamp.glsl, as the shaders' text compiled
// in double and in single precision, against adaptive quadrature of the integrand as physics states
// it. Whole rays, and sums over parts that end anywhere, as at shadows; eyes and lamps in the fog,
// and up to 500 scale heights above it, where single precision still knows heights.

#include "AirlightTestPhase.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

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
struct Setting
{
  glm::dvec3 SigmaT;
  glm::dvec3 Up;
  double ScaleHeight;
  double OriginHeight; // of the ray's origin above the height of density 1
  glm::dvec3 Lamp;
  glm::dvec3 Direction;
  double Length;
  double Cut; // a share of the length

  std::string Describe() const
  {
    return Text("sigmaT ", this->SigmaT.x, " ", this->SigmaT.y, " ", this->SigmaT.z,
      ", scale height ", this->ScaleHeight, ", eye ", this->OriginHeight, ", lamp (", this->Lamp.x,
      ", ", this->Lamp.y, ", ", this->Lamp.z, "), direction (", this->Direction.x, ", ",
      this->Direction.y, ", ", this->Direction.z, "), up (", this->Up.x, ", ", this->Up.y, ", ",
      this->Up.z, "), length ", this->Length, ", cut ", this->Cut);
  }
};

glm::dvec3 RandomDirection(Random& random)
{
  const double z = random.Uniform(-1.0, 1.0);
  const double angle = random.Uniform(0.0, 2.0 * Pi);
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(angle), r * std::sin(angle), z };
}

Setting RandomSetting(Random& random)
{
  Setting s;
  const double sigmaT = random.LogUniform(3e-3, 3.0);
  const bool grey = random.Index(2) == 0;
  for (int k = 0; k < 3; ++k)
  {
    s.SigmaT[k] = Rounded(grey || k == 0 ? sigmaT : sigmaT * random.LogUniform(0.03, 30.0));
  }
  s.Up = Rounded(RandomDirection(random));
  s.ScaleHeight = Rounded(random.LogUniform(0.3, 30.0));
  s.OriginHeight = Rounded(s.ScaleHeight * random.Uniform(-2.0, 8.0));
  s.Direction = Rounded(random.Index(5) == 0
      ? glm::normalize(glm::cross(s.Up, RandomDirection(random))) // level
      : RandomDirection(random));
  s.Lamp = Rounded(random.Uniform(-5.0, 30.0) * s.Direction +
    random.LogUniform(0.03, 10.0) * RandomDirection(random));
  s.Length = Rounded(random.Index(4) == 0 ? 1e18 : random.LogUniform(0.1, 1e3));
  s.Cut = random.Uniform(0.0, 1.0);
  return s;
}

// The eye far above the fog looks down at the ground at height 0, and the lamp is beside the ray.
Setting RandomHighSetting(Random& random)
{
  Setting s = RandomSetting(random);
  const double slope = random.Uniform(-1.0, -0.3);
  const glm::dvec3 level = glm::normalize(glm::cross(s.Up, RandomDirection(random)));
  s.OriginHeight = Rounded(s.ScaleHeight * random.LogUniform(10.0, 500.0));
  s.Direction = Rounded(slope * s.Up + std::sqrt(1.0 - slope * slope) * level);
  s.Length = Rounded(s.OriginHeight / -slope);
  const double lampHeight =
    random.Index(3) == 0 ? s.OriginHeight * random.Uniform(0.0, 1.5) : 2.0 * s.ScaleHeight;
  s.Lamp = Rounded((s.OriginHeight - lampHeight) / -slope * s.Direction +
    random.LogUniform(0.3, 10.0) * s.ScaleHeight * RandomDirection(random));
  return s;
}

// One precision's whole, and its part before the cut, per unit intensity and scattering
// coefficient.
struct Sums
{
  glm::dvec3 Whole{ 0.0 };
  glm::dvec3 Before{ 0.0 };
  double CutAt = 0.0;
  int Parts = 0;
};

template <typename Media, typename Light, typename Phase>
void Prepare(const Setting& s, const Phase& phase, Media& media, Light& light)
{
  using Vector = decltype(media.item[0].sigmaT);
  media.count = 1;
  auto& medium = media.item[0];
  medium.phase = phase;
  medium.sigmaT = Vector(s.SigmaT);
  medium.sigmaS = medium.sigmaT;
  medium.region.kind = AIRLIGHT_REGION_UNBOUNDED;
  medium.density = AIRLIGHT_DENSITY_HEIGHT;
  medium.up = Vector(s.Up);
  medium.inverseScaleHeight = 1.0 / s.ScaleHeight;
  medium.originHeight = s.OriginHeight;
  light.kind = AIRLIGHT_POINT_QUADRATURE;
  light.position = Vector(s.Lamp);
  light.radius = 1e-6;
  light.cosCone = -1.0;
}

Sums SumDouble(const Setting& s, const f64::AirlightPhase& phase)
{
  f64::AirlightMedia media{};
  f64::AirlightLight light{};
  Prepare(s, phase, media, light);
  const f64::AirlightMedium& medium = media.item[0];
  const f64::AirlightRay ray =
    f64::airlightRay(media, light, glm::dvec3(0.0), s.Direction, s.Length);
  Sums sums;
  sums.Whole = f64::airlightHeightFogRay(medium, light, ray, 0.0, s.Length) / ray.foot.h;
  f64::AirlightHeightFogLamp lamp = f64::airlightHeightFogLamp(medium, light, ray, 0.0, s.Length);
  const double cut = lamp.begin + s.Cut * (lamp.end - lamp.begin);
  sums.CutAt = ray.foot.tL + ray.foot.h * std::sinh(cut);
  for (double v = lamp.begin; v < lamp.end && sums.Parts < 10000; ++sums.Parts)
  {
    const double end = f64::airlightHeightFogPartEnd(medium, lamp, v);
    sums.Before += v < cut
      ? f64::airlightHeightFogPart(medium, lamp, v, std::min(end, cut)) / ray.foot.h
      : glm::dvec3(0.0);
    v = end;
  }
  return sums;
}

glm::dvec3 SumSingle(const Setting& s, const f32::AirlightPhase& phase)
{
  f32::AirlightMedia media{};
  f32::AirlightLight light{};
  Prepare(s, phase, media, light);
  const float length = static_cast<float>(s.Length);
  const f32::AirlightRay ray =
    f32::airlightRay(media, light, glm::vec3(0.0f), glm::vec3(s.Direction), length);
  return glm::dvec3(f32::airlightHeightFogRay(media.item[0], light, ray, 0.0f, length)) /
    static_cast<double>(ray.foot.h);
}

// The integral of the density over a straight way of this length between two heights.
double GetColumn(double height0, double height1, double length, double scaleHeight)
{
  const double rise = std::abs(height1 - height0) / scaleHeight;
  const double densest = std::exp(-std::min(height0, height1) / scaleHeight) * length;
  return rise < 1e-12 ? densest : densest * -std::expm1(-rise) / rise;
}

double GetExact(const Setting& s, const f64::AirlightPhase& phase, double sigmaT, double to)
{
  const double tL = glm::dot(s.Lamp, s.Direction);
  const double h = glm::length(glm::cross(s.Lamp, s.Direction));
  const double lampHeight = s.OriginHeight + glm::dot(s.Up, s.Lamp);
  const double slope = glm::dot(s.Up, s.Direction);
  const auto integrand = [&](double x) {
    const double t = std::max(x + tL, 0.0);
    const double r = std::sqrt(h * h + x * x);
    const double height = s.OriginHeight + slope * t;
    const double columns = GetColumn(s.OriginHeight, height, t, s.ScaleHeight) +
      GetColumn(height, lampHeight, r, s.ScaleHeight);
    return FittedPhase(phase, 1.0 + x / r, 1.0 - x / r) / (r * r) *
      std::exp(-height / s.ScaleHeight - sigmaT * columns);
  };
  // Beyond an optical depth of 100 and 60 scale heights above all nothing is left.
  double end = to;
  for (double way = 1.0; way < to; way *= 2.0)
  {
    const double height = s.OriginHeight + slope * way;
    const bool gone = sigmaT * GetColumn(s.OriginHeight, height, way, s.ScaleHeight) > 100.0 ||
      height > std::max(s.OriginHeight, lampHeight) + 60.0 * s.ScaleHeight;
    if (gone && way > tL)
    {
      end = way;
      break;
    }
  }
  // Nor is there before the last 60 scale heights of a descent.
  const double depth = std::max(s.OriginHeight + slope * end, -100.0 * s.ScaleHeight);
  const double begin =
    slope < 0.0 ? std::max((depth + 60.0 * s.ScaleHeight - s.OriginHeight) / slope, 0.0) : 0.0;
  return begin < end ? Integrate(integrand, PeakPanels(begin - tL, end - tL, h), 1e-9) : 0.0;
}

bool ComparePhase(const std::string& name, vtkParticipatingMedium* medium, Random& random)
{
  Comparison inDouble(name + ", double precision");
  Comparison inSingle(name + ", single precision");
  Comparison before(name + ", before a cut, of the whole ray");
  const auto phase = GetPhase<f64::AirlightPhase>(medium);
  const auto narrowPhase = GetPhase<f32::AirlightPhase>(medium);
  std::vector<double> errors;
  int parts = 0;
  for (int n = 0; n < 400; ++n)
  {
    const Setting s = n % 5 == 0 ? RandomHighSetting(random) : RandomSetting(random);
    const Sums wide = SumDouble(s, phase);
    const glm::dvec3 narrow = SumSingle(s, narrowPhase);
    parts = std::max(parts, wide.Parts);
    for (int k = 0; k < 3; ++k)
    {
      const double exact = GetExact(s, phase, s.SigmaT[k], s.Length);
      if (exact <= 1e-12) // darker than all that a picture shows
      {
        continue;
      }
      const auto describe = [&] { return Text(s.Describe(), ", channel ", k); };
      const double error = std::abs(wide.Whole[k] - exact) / exact;
      errors.push_back(error);
      inDouble.Add(error, 1e-3, describe);
      inSingle.Add(std::abs(narrow[k] - exact) / exact, 1e-3, describe);
      if (k == 0)
      {
        const double part = GetExact(s, phase, s.SigmaT[k], std::clamp(wide.CutAt, 0.0, s.Length));
        before.Add(std::abs(wide.Before[k] - part) / exact, 1e-3, describe);
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  const double median = errors[errors.size() / 2];
  const double most = errors[errors.size() * 99 / 100];
  std::cout << name << ": median " << median << ", 99 % " << most << ", at most " << parts
            << " parts\n";
  bool ok = inDouble.Report();
  ok &= inSingle.Report();
  ok &= before.Report();
  if (median > 4e-6 || most > 3e-4 || parts > AIRLIGHT_MAXIMUM_FOG_PARTS)
  {
    std::cerr << "FAILED: " << name << ": median " << median << ", 99 % " << most << ", " << parts
              << " parts\n";
    ok = false;
  }
  return ok;
}
}

//------------------------------------------------------------------------------
int TestHeightFogLamp(int, char*[])
{
  Random random(61543);
  vtkNew<vtkParticipatingMedium> medium;
  bool ok = ComparePhase("isotropic", medium, random);
  medium->SetPhaseFunctionToHenyeyGreenstein();
  for (double g : { -0.5, 0.6, 0.9 })
  {
    medium->SetAnisotropy(g);
    ok &= ComparePhase(Text("g = ", g), medium, random);
  }
  medium->SetPhaseFunctionToMieMurky();
  ok &= ComparePhase("Mie, murky", medium, random);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
