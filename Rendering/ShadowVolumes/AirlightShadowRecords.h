// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a light's shadow planes are drawn from, as glsl/AirlightPlanesVS.glsl reads it. Positions
 * are relative to the light's anchor, see AirlightShadowVolumes.h.
 */

#ifndef AirlightShadowRecords_h
#define AirlightShadowRecords_h

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
// A silhouette's edge.
struct ShadowEdge
{
  glm::vec4 A;      // w: weight
  glm::vec4 B;      // w: number of the caster in Update(), after the last one for those of others
  glm::vec4 Normal; // w: index of the layer
};

// Adds an edge with a weight, a whole number. A boundary has one of at most 2; more is rare, and
// takes several edges.
inline void AddEdge(std::vector<ShadowEdge>& edges, ShadowEdge edge, float weight)
{
  while (weight != 0.0f)
  {
    edge.A.w = glm::clamp(weight, -2.0f, 2.0f);
    edges.push_back(edge);
    weight -= edge.A.w;
  }
}

// An edge on whose plane rays start: at the eye, or in parallel projection at infinity.
struct NearEdge
{
  ShadowEdge Edge; // B.w: the plane's offset from the start
  glm::vec4 Sides; // the start's place: from the sides that begin at A and B, and beyond the edge
};

// A caster's triangle, for rays that go through it: where its front faces are culled, where it is
// cut away, and before the near clipping plane.
struct ShadowCap
{
  glm::vec4 A; // w: 1 where the light is on the side of the normal, -1 behind, 0 edge-on
  glm::vec4 B;
  glm::vec4 C; // w: index of the layer
};
}

#endif
