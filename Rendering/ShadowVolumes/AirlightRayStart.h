// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where rays start, in perspective at the eye and in parallel projection at infinity, to a light's
 * shadow planes: on some, and within shadows.
 */

#ifndef AirlightRayStart_h
#define AirlightRayStart_h

#include "ShadowVolumes/AirlightShadowRecords.h"

namespace airlight
{
class CameraUniforms;

// Against a directional light, all rays of a parallel view start on all of the light's planes.
// Turns such a light aside by too little to see, and returns whether it was one.
bool TurnLightAside(glm::dvec4& light, const CameraUniforms& view);

class RayStart
{
public:
  // `light` is the homogeneous world position, `anchor` what edges are relative to.
  RayStart(const CameraUniforms& view, const glm::dvec4& light, const glm::dvec3& anchor);

  // Whether rays start on the edge's plane beyond the edge, within tolerance.
  bool IsOnPlane(const ShadowEdge& edge) const;

  // With all that single precision could not find out of a start so near: on which side of the
  // plane it is, and in it of the edge's ends, where the light, a vertex and the start lie on a
  // line.
  NearEdge MakeNear(const ShadowEdge& edge) const;

  // The homogeneous world position from which to count shadows: beside planes that rays start on.
  glm::dvec4 GetPosition() const { return this->World + this->Aside; }

private:
  glm::dvec4 Light;
  glm::dvec4 World;
  glm::dvec4 FromAnchor;
  glm::dvec4 Aside;
};
}

#endif
