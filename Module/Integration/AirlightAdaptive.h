// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The quadrature of glsl/AirlightQuadrature.glsl with as many panels as the integrand needs: for
 * the classes that compute in double precision.
 */

#ifndef AirlightAdaptive_h
#define AirlightAdaptive_h

#include "Integration/AirlightMath.h"

namespace airlight
{
// The integral of f64::airlightQuadrature over [t0, t1], to 1e-12 of itself where that is smooth
// between finitely many kinks.
glm::dvec3 AdaptiveQuadrature(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double t0, double t1);
}

#endif
