// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lit parts of a ray, and how much of a light reaches each: opaque casters cut the ray, and
 * each triangle of a caster that lets light through dims its own shadow. Shadows in which the
 * opacity varies are looked up in many short parts.
 */

#ifndef AirlightReferenceLitParts_h
#define AirlightReferenceLitParts_h

#include "Silhouette/AirlightSilhouette.h" // for HomogeneousPoint

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
class ReferenceScene;

struct ReferenceLitPart
{
  double From, To;
  glm::dvec3 Passes{ 1.0 }; // the share of the light
};

// On [0, end] of a ray; `origin` in the world. In order; dark parts are left out.
std::vector<ReferenceLitPart> FindReferenceLitParts(const ReferenceScene& scene,
  const HomogeneousPoint& light, const glm::dvec3& origin, const glm::dvec3& unitDirection,
  double end);
}

#endif
