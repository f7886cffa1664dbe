// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightMergedEdges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace airlight
{
namespace
{
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
  std::vector<std::pair<Place, size_t>> places;
  places.reserve(edges.size());
  for (const ShadowEdge& edge : edges)
  {
    places.emplace_back(FindPlace(edge), places.size());
  }
  std::sort(places.begin(), places.end());
  // The first edge of a place gets the weight of all.
  std::vector<float> weights(edges.size(), 0.0f);
  for (size_t i = 0, first = 0; i < places.size(); ++i)
  {
    first = places[i].first == places[first].first ? first : i;
    weights[places[first].second] += FindWeight(edges[places[i].second]);
  }
  std::vector<ShadowEdge> merged;
  merged.reserve(edges.size());
  for (size_t i = 0; i < edges.size(); ++i)
  {
    AddEdge(merged, edges[i], IsReversed(edges[i]) ? -weights[i] : weights[i]);
  }
  return merged;
}
}
