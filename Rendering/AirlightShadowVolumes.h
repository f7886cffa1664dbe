// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shadow volumes of all casters in one light: the edges to draw planes from, and how many
 * volumes hold the start of the view rays. Kept between frames; a caster that neither moved nor
 * changed keeps its silhouette while the light stands still.
 */

#ifndef AirlightShadowVolumes_h
#define AirlightShadowVolumes_h

#include "AirlightCasters.h"

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
// As glsl/AirlightPlanesVS.glsl reads it. Positions are relative to the anchor.
struct ShadowEdge
{
  glm::vec4 A; // w: weight
  glm::vec4 B;
  glm::vec4 Normal;
};

class ShadowVolumes
{
public:
  // `light` is the homogeneous world position; `start` that of the view rays' common start.
  // Returns true where the edges changed.
  bool Update(const std::vector<Caster>& casters, const glm::dvec4& light, const glm::dvec4& start);

  const std::vector<ShadowEdge>& GetEdges() const { return this->Edges; }
  int GetStartCount() const { return this->StartCount; }

  // The light itself; the first caster where the light is at infinity. World coordinates.
  const glm::dvec3& GetAnchor() const { return this->Anchor; }

private:
  struct Part
  {
    Caster Source;
    std::vector<ShadowEdge> Edges;
    int StartCount = 0;
  };

  void SetAnchor(const std::vector<Caster>& casters);
  std::vector<ShadowEdge> MakeEdges(const Caster& caster) const;

  glm::dvec4 Light{ 0.0 };
  glm::dvec4 Start{ 0.0 };
  glm::dvec3 Anchor{ 0.0 };
  std::vector<Part> Parts; // in the order of the casters
  std::vector<ShadowEdge> Edges;
  int StartCount = 0;
};
}

#endif
