// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What one triangle is to a ray. Its shadow is declared in AirlightOccluders.h.
 */

#ifndef AirlightOccluderTriangle_h
#define AirlightOccluderTriangle_h

#include "Occlusion/AirlightOccluders.h"

namespace airlight
{
// Large enough not to be rounding, and of coordinates whose products are finite.
bool IsGood(const OccluderTriangle& triangle);

// Where the ray's line meets the triangle; NaN where it does not. Lines through a shared edge meet
// at least one of its triangles, as the signs for both come from the same number.
double HitTriangle(
  const OccluderTriangle& triangle, const glm::dvec3& origin, const glm::dvec3& direction);
}

#endif
