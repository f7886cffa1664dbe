// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where integrals along a ray are cut, so that their integrands are smooth in between. Not
 * installed.
 */

#ifndef AirlightRayCuts_h
#define AirlightRayCuts_h

#include "Integration/AirlightMath.h"

#include <vector>

namespace airlight
{
// The parts of [t0, t1] in which no medium begins or ends, and no cell of an image, in order.
std::vector<f64::AirlightPiece> FindPieces(const f64::AirlightMedia& media,
  const glm::dvec3& origin, const glm::dvec3& direction, double t0, double t1);

// Where the airlight of one light has kinks or changes fast in a piece, with the piece's ends, in
// ascending order.
std::vector<double> FindCuts(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, const f64::AirlightPiece& piece);
}

#endif
