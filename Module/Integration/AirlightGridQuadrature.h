// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Adaptive quadrature of airlight in media whose densities come from images, cell by cell. Not
 * installed.
 */

#ifndef AirlightGridQuadrature_h
#define AirlightGridQuadrature_h

#include "Integration/AirlightMath.h"

namespace airlight
{
// The same as AdaptiveQuadrature() with images among the densities: panels end where the ray passes
// from one cell to the next, and those whose error is the largest are halved until all errors
// together are below 1e-6 of the integral, or there are 20 000 panels more.
glm::dvec3 GridQuadrature(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double t0, double t1);
}

#endif
