// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Integrals along a ray in double precision, each by the best way that there is: closed forms,
 * adaptive quadrature, or for densities from images quadrature cell by cell. Not installed.
 */

#ifndef AirlightIntegrate_h
#define AirlightIntegrate_h

#include "Integration/AirlightMath.h"

#include <functional>

namespace airlight
{
// Whether the density of one of the media comes from an image, or volumes dim lights.
bool HasGrid(const f64::AirlightMedia& media);

// Whether one of them is in a closed surface.
bool HasSurface(const f64::AirlightMedia& media);

// Whether ways through them are walks, from cell to cell or from hit to hit of a closed surface.
bool HasLongWays(const f64::AirlightMedia& media);

// What the light scatters into the part [from, to] of a ray that lies inside ray.lit.
glm::dvec3 IntegrateAirlight(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double from, double to);

// The share of a light that reaches a point of a ray, of what the media leave of it.
using LightShare = std::function<double(const glm::dvec3&)>;

// The same of a light of which only a share arrives, by quadrature with an error of about 1e-5.
glm::dvec3 IntegrateDimmed(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double from, double to, const LightShare& share);

// IntegrateAirlight() on [from, to] of a ray from the origin of coordinates, of any light and
// without a radius; `to` may be infinite. Channels that no medium scatters are exactly dark.
glm::dvec3 IntegrateLight(const f64::AirlightMedia& media, f64::AirlightLight light,
  const glm::dvec3& direction, double from, double to);

// The distance from a light within which it counts as being on the ray: it keeps logarithms and
// quotients finite, and is far below what a double resolves of the distances involved.
double LeastDistance(const glm::dvec3& light, double length);

// Zeros in channels that no medium scatters or emits, and in place of what is not finite.
glm::dvec3 KeepBright(const f64::AirlightMedia& media, const glm::dvec3& radiance);

// Light that was scattered more than once, of one of the media's lamps, into [0, to] of a ray of
// unit direction, on which casters leave `once` of its light that was scattered once.
glm::dvec3 IntegrateMultiple(const f64::AirlightMedia& media, int lamp, const glm::dvec3& origin,
  const glm::dvec3& direction, double to, const glm::dvec3& once);

// The same of lights that are none of the lamps, whose light collides first elsewhere.
glm::dvec3 IntegrateCollisions(const f64::AirlightMedia& media, const glm::dvec3& origin,
  const glm::dvec3& direction, double to);

// What the media scatter of their ambient radiance into [0, to] of a ray of unit direction.
glm::dvec3 IntegrateAmbient(const f64::AirlightMedia& media, const glm::dvec3& origin,
  const glm::dvec3& direction, double to);
}

#endif
