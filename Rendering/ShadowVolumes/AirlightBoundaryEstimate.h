// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How many shadow boundaries a pixel will have, before any is drawn: the area that shadow planes
 * cover in the picture, over the picture's. Opaque surfaces hide some of it, so that it is rather
 * too large.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightBoundaryEstimate_h
#define AirlightBoundaryEstimate_h

#include "Casters/AirlightCasters.h"
#include "ShadowVolumes/AirlightShadowRecords.h"
#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
class CameraUniforms;

class VTKAIRLIGHT_EXPORT BoundaryEstimate
{
public:
  // Of planes relative to `anchor` in a light at a homogeneous position in the world.
  BoundaryEstimate(const CameraUniforms& view, const glm::dvec3& anchor, const glm::dvec4& light);

  // Boundaries a pixel of an edge's plane, which ends at a plane from the eye, or nowhere if that
  // is 0 (FindTruncationPlanes()).
  double Get(const ShadowEdge& edge, const glm::vec4& truncation) const;

  // Of a triangle that rays go through.
  double Get(const ShadowCap& cap) const;

private:
  glm::dvec4 GetFarCorner(const glm::dvec3& point, const glm::vec4& truncation) const;

  glm::dmat4 ToClip;
  glm::dvec3 Anchor;    // from the eye
  glm::dvec4 FromLight; // directional: the light's direction and w 0; point: w 1
};

// Which casters have too many boundaries: all of a prop, the ones with the most first, until what
// is left has at most so many a pixel. `boundaries`: by caster. Translucent casters stay.
VTKAIRLIGHT_EXPORT std::vector<bool> FindCostlyCasters(
  const std::vector<Caster>& casters, const std::vector<double>& boundaries, double most);
}

#endif
