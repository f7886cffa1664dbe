// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightIntegrate.h"

#include "Integration/AirlightAdaptiveQuadrature.h"
#include "Integration/AirlightRayCuts.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
bool HasGrid(const f64::AirlightMedia& media)
{
  return media.volumes > 0 ||
    std::any_of(media.item, media.item + media.count,
      [](const auto& medium) { return medium.density == AIRLIGHT_DENSITY_GRID; });
}

//------------------------------------------------------------------------------
bool HasSurface(const f64::AirlightMedia& media)
{
  return std::any_of(media.item, media.item + media.count,
    [](const auto& medium) { return medium.region.kind == AIRLIGHT_REGION_SURFACE; });
}

//------------------------------------------------------------------------------
bool HasLongWays(const f64::AirlightMedia& media) { return HasGrid(media) || HasSurface(media); }

//------------------------------------------------------------------------------
glm::dvec3 IntegrateAirlight(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double from, double to)
{
  if (light.kind != AIRLIGHT_POINT_QUADRATURE && light.kind != AIRLIGHT_DIRECTIONAL_QUADRATURE)
  {
    return f64::airlightInterval3(media, light, ray, from,
      f64::airlightTail3(media, light, ray, from), to, f64::airlightTail3(media, light, ray, to));
  }
  return light.intensity * AdaptiveQuadrature(media, light, ray).Integrate(from, to);
}

//------------------------------------------------------------------------------
glm::dvec3 IntegrateDimmed(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double from, double to, const LightShare& share)
{
  return light.intensity * AdaptiveQuadrature(media, light, ray, share).Integrate(from, to);
}

//------------------------------------------------------------------------------
double LeastDistance(const glm::dvec3& light, double length)
{
  const double distance = glm::length(light);
  return std::max(distance > 0.0 ? 1e-12 * distance : 1e-12 * std::min(length, 1.0), 1e-100);
}

//------------------------------------------------------------------------------
glm::dvec3 KeepBright(const f64::AirlightMedia& media, const glm::dvec3& radiance)
{
  glm::dvec3 kept(0.0);
  for (int c = 0; c < 3; ++c)
  {
    const bool bright = std::any_of(media.item, media.item + media.count,
      [c](const auto& medium) { return medium.sigmaS[c] > 0.0 || medium.emission[c] > 0.0; });
    kept[c] = bright && std::isfinite(radiance[c]) ? radiance[c] : 0.0;
  }
  return kept;
}

//------------------------------------------------------------------------------
glm::dvec3 IntegrateLight(const f64::AirlightMedia& media, f64::AirlightLight light,
  const glm::dvec3& direction, double from, double to)
{
  to = std::min(to, AIRLIGHT_FAR);
  light.radius = LeastDistance(light.position, to);
  const f64::AirlightRay ray = f64::airlightRay(media, light, glm::dvec3(0.0), direction, to);
  from = std::max(from, ray.lit.x);
  to = std::min(to, ray.lit.y);
  return to > from ? KeepBright(media, IntegrateAirlight(media, light, ray, from, to))
                   : glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
glm::dvec3 IntegrateMultiple(const f64::AirlightMedia& media, int lamp, const glm::dvec3& origin,
  const glm::dvec3& direction, double to, const glm::dvec3& once)
{
  return f64::airlightMultipleShaded(media.multiple,
    f64::airlightMultipleAlong(media.multiple, media, lamp, origin, direction, to), once, true);
}

//------------------------------------------------------------------------------
glm::dvec3 IntegrateCollisions(
  const f64::AirlightMedia& media, const glm::dvec3& origin, const glm::dvec3& direction, double to)
{
  return f64::airlightMultipleOfCollisions(media.multiple, media, origin, direction, to);
}

//------------------------------------------------------------------------------
glm::dvec3 IntegrateAmbient(
  const f64::AirlightMedia& media, const glm::dvec3& origin, const glm::dvec3& direction, double to)
{
  const bool coloured = media.item[0].albedo || media.item[0].glow;
  if ((media.count < 2 && !coloured) || !HasGrid(media))
  {
    return f64::airlightAmbient(media, origin, direction, to);
  }
  glm::dvec3 sum(0.0);
  for (const f64::AirlightPiece& piece : FindPieces(media, origin, direction, 0.0, to))
  {
    sum += f64::airlightAmbientInPiece(media, piece, origin, direction);
  }
  return sum;
}
}
