// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightIntegrate.h"

#include "Integration/AirlightAdaptiveQuadrature.h"
#include "Integration/AirlightRayCuts.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
bool HasGrid(const f64::AirlightMedia& media)
{
  return std::any_of(media.item, media.item + media.count,
    [](const auto& medium) { return medium.density == AIRLIGHT_DENSITY_GRID; });
}

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
  if (media.count < 2 || !HasGrid(media))
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
