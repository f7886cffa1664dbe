// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightIntegrate.h"

#include "Integration/AirlightAdaptive.h"
#include "Integration/AirlightGridQuadrature.h"

#include <algorithm>
#include <vector>

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
  return light.intensity *
    (HasGrid(media) ? GridQuadrature(media, light, ray, from, to)
                    : AdaptiveQuadrature(media, light, ray, from, to));
}

//------------------------------------------------------------------------------
glm::dvec3 IntegrateAmbient(
  const f64::AirlightMedia& media, const glm::dvec3& origin, const glm::dvec3& direction, double to)
{
  if (media.count < 2 || !HasGrid(media))
  {
    return f64::airlightAmbient(media, origin, direction, to);
  }
  std::vector<double> cuts = { 0.0, to };
  for (int i = 0; i < media.count; ++i)
  {
    const f64::AirlightMedium& medium = media.item[i];
    if (medium.density == AIRLIGHT_DENSITY_GRID)
    {
      medium.grid->AddCuts(medium.gridOrigin + origin, direction, 0.0, to, cuts);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  glm::dvec3 sum(0.0);
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    for (double t = cuts[i - 1]; t < cuts[i];)
    {
      const f64::AirlightPiece piece = f64::airlightPieceAt(media, origin, direction, t, cuts[i]);
      sum += f64::airlightAmbientInPiece(media, piece, origin, direction);
      t = piece.to;
    }
  }
  return sum;
}
}
