// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightMergedEdges.h"

#include <algorithm>
#include <array>
#include <map>

namespace airlight
{
namespace
{
constexpr float MostWeight = 2.0f; // of a boundary

// Both ends, the lower one first, and the layer: the same for an edge and its reverse.
using Place = std::array<float, 7>;

bool IsReversed(const ShadowEdge& edge)
{
  return std::array<float, 3>{ edge.B.x, edge.B.y, edge.B.z } <
    std::array<float, 3>{ edge.A.x, edge.A.y, edge.A.z };
}

Place FindPlace(const ShadowEdge& edge)
{
  const glm::vec4& low = IsReversed(edge) ? edge.B : edge.A;
  const glm::vec4& high = IsReversed(edge) ? edge.A : edge.B;
  return { low.x, low.y, low.z, high.x, high.y, high.z, edge.Normal.w };
}

float FindWeight(const ShadowEdge& edge) { return IsReversed(edge) ? -edge.A.w : edge.A.w; }
}

//------------------------------------------------------------------------------
std::vector<ShadowEdge> MergeEdges(const std::vector<ShadowEdge>& edges)
{
  std::map<Place, float> weights;
  for (const ShadowEdge& edge : edges)
  {
    weights[FindPlace(edge)] += FindWeight(edge);
  }
  std::vector<ShadowEdge> merged;
  merged.reserve(edges.size());
  for (const ShadowEdge& edge : edges)
  {
    float& left = weights[FindPlace(edge)];
    while (left != 0.0f)
    {
      const float weight = std::clamp(left, -MostWeight, MostWeight);
      left -= weight;
      merged.push_back(edge);
      merged.back().A.w = IsReversed(edge) ? -weight : weight;
    }
  }
  return merged;
}
}
