// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps that do not shine evenly from inside the medium, as two that do: where their light first
 * changes its direction, near the lamp and far from it. Not installed; exported for the module's
 * own tests.
 */

#ifndef AirlightFirstCollisions_h
#define AirlightFirstCollisions_h

#include "Integration/AirlightMath.h"
#include "vtkAirlightModule.h" // for export macro

#include <array>

namespace airlight
{
// Forward scattering keeps a beam together where lamps beside it do not: up to this mean cosine
// they were measured to be good.
constexpr double MaximumBeamCosine = 0.65;

struct CollisionGroup
{
  glm::dvec3 Position{ 0.0 };
  double Radius = 0.0;     // closer to it its light does not get brighter
  glm::dvec3 Power{ 0.0 }; // that is scattered there, into all directions
};

// Of a light at a place with photometric data, if any; and a uniform medium of a convex region,
// whose phase function has this mean cosine. Groups without power have no light.
VTKAIRLIGHT_EXPORT std::array<CollisionGroup, 2> FindFirstCollisions(
  const f64::AirlightMedium& medium, const f64::AirlightLight& light, double meanCosine);
}

#endif
