// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultipleScattering/AirlightFirstCollisions.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
constexpr int DirectionCount = 256;
// Of the light that changes direction, the nearer group's share: the weight of the first of two
// Gauss-Laguerre nodes, which are exact for what falls exponentially.
constexpr double NearShare = 0.85355339059327379;

struct Cone
{
  glm::dvec3 Axis{ 0.0, 0.0, 1.0 };
  double Versine = 2.0; // 1 less the cosine of half its angle
};

// What holds all of a region, seen from outside.
Cone GetRegionCone(const f64::AirlightRegion& region, const glm::dvec3& from)
{
  if (region.kind == AIRLIGHT_REGION_UNBOUNDED)
  {
    return {};
  }
  glm::dvec3 centre = region.centre;
  double radius = region.radius;
  if (region.kind == AIRLIGHT_REGION_CYLINDER)
  {
    radius = std::hypot(region.radius, region.halfHeight);
  }
  else if (region.kind != AIRLIGHT_REGION_SPHERE)
  {
    centre = 0.5 * (region.boxMin + region.boxMax);
    radius = 0.5 * glm::distance(region.boxMin, region.boxMax);
  }
  const double distance = glm::distance(centre, from);
  const double sine = radius / distance;
  return sine < 1.0
    ? Cone{ (centre - from) / distance, sine * sine / (1.0 + std::sqrt(1.0 - sine * sine)) }
    : Cone{};
}

// Spread evenly over the solid angle of a cone, on a spiral.
glm::dvec3 GetDirection(const Cone& cone, int i)
{
  const double golden = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  const double versine = (i + 0.5) / DirectionCount * cone.Versine;
  const double cosine = 1.0 - versine;
  const double sine = std::sqrt(versine * (1.0 + cosine));
  const glm::dvec3& axis = cone.Axis;
  const glm::dvec3 aside =
    std::abs(axis.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, aside));
  return glm::normalize(
    cosine * axis + sine * (std::cos(golden * i) * u + std::sin(golden * i) * glm::cross(axis, u)));
}

// Of a light at the origin, the radiant intensity by that on its axis.
double GetShare(const f64::AirlightLight& light, const glm::dvec3& direction)
{
  const bool outside = light.cosCone > 0.0 && glm::dot(direction, light.axis) < light.cosCone;
  return outside
    ? 0.0
    : f64::airlightFalloff(light, direction, 1.0) * f64::airlightPhotometricShare(light, direction);
}

// Where light on [0, depth] of its way changes direction, which is as likely everywhere: of the
// part from `from` to `to`, the share of all light and its mean place.
struct Part
{
  double Share;
  double Mean;
};

Part GetPart(double from, double to)
{
  const double share = std::exp(-from) - std::exp(-to);
  const double end = std::isinf(to) ? 0.0 : (to + 1.0) * std::exp(-to);
  return { share, share > 0.0 ? ((from + 1.0) * std::exp(-from) - end) / share : from };
}

// Sums of points with weights.
struct Cloud
{
  double Weight = 0.0;
  glm::dvec3 Sum{ 0.0 };
  double Squares = 0.0;

  void Add(const glm::dvec3& away, double weight)
  {
    this->Weight += weight;
    this->Sum += weight * away;
    this->Squares += weight * glm::dot(away, away);
  }
  glm::dvec3 GetMean() const { return this->Sum / this->Weight; }
  double GetSpread() const
  {
    const glm::dvec3 mean = this->GetMean();
    return std::sqrt(std::max(this->Squares / this->Weight - glm::dot(mean, mean), 0.0));
  }
};

// Per length, as the mean of the channels that fade.
double GetTransportExtinction(const f64::AirlightMedium& medium, double meanCosine)
{
  double sum = 0.0;
  int count = 0;
  for (int channel = 0; channel < 3; ++channel)
  {
    if (medium.sigmaT[channel] > 0.0)
    {
      sum += medium.sigmaT[channel] - meanCosine * medium.sigmaS[channel];
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}
}

//------------------------------------------------------------------------------
std::array<CollisionGroup, 2> FindFirstCollisions(
  const f64::AirlightMedium& medium, const f64::AirlightLight& light, double meanCosine)
{
  std::array<CollisionGroup, 2> result;
  const double sigma = GetTransportExtinction(medium, meanCosine);
  const Cone region = GetRegionCone(medium.region, light.position);
  const Cone lamp = light.cosCone > 0.0 ? Cone{ light.axis, 1.0 - light.cosCone } : Cone{};
  const Cone& cone = region.Versine < lamp.Versine ? region : lamp;
  f64::AirlightLight atOrigin = light;
  atOrigin.position = glm::dvec3(0.0);
  atOrigin.radius = 0.0;
  atOrigin.attenuation = glm::dvec3(0.0, 0.0, 1.0);
  Cloud clouds[2];
  for (int i = 0; i < DirectionCount && sigma > 0.0; ++i)
  {
    const glm::dvec3 direction = GetDirection(cone, i);
    const double share = GetShare(atOrigin, direction);
    const glm::dvec2 range =
      f64::airlightRegionRange(medium.region, light.position, direction, AIRLIGHT_FAR);
    if (share > 0.0 && range.y > range.x)
    {
      const double depth = sigma * (range.y - range.x);
      const double split = -std::log1p(NearShare * std::expm1(-depth));
      for (const bool far : { false, true })
      {
        const Part part = far ? GetPart(split, depth) : GetPart(0.0, split);
        clouds[far].Add((range.x + part.Mean / sigma) * direction, share * part.Share);
      }
    }
  }
  const double solidAngle = 2.0 * vtkMath::Pi() * cone.Versine / DirectionCount;
  for (int k = 0; k < 2; ++k)
  {
    if (clouds[k].Weight > 0.0)
    {
      result[k].Position = light.position + clouds[k].GetMean();
      result[k].Radius = 0.5 * std::hypot(clouds[k].GetSpread(), 0.5 / sigma);
      const glm::dvec3 albedo =
        medium.sigmaS / glm::max(medium.sigmaT, glm::dvec3(std::numeric_limits<double>::min()));
      result[k].Power = albedo * light.intensity * (clouds[k].Weight * solidAngle);
    }
  }
  return result;
}
}
