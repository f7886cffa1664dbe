// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightSilhouette.h"

#include <algorithm>
#include <utility>

namespace airlight
{
namespace
{
// +1 in front of the triangle's plane, -1 behind, 0 on it.
int Side(const glm::dvec4& plane, const HomogeneousPoint& p)
{
  const double d = glm::dot(plane, p);
  return (d > 0.0) - (d < 0.0);
}

glm::dvec3 Xyz(const glm::dvec4& v) { return { v.x, v.y, v.z }; }

// The straight way between two points, at least one of which is finite.
struct Line
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
};

Line Connect(const HomogeneousPoint& a, const HomogeneousPoint& b)
{
  const HomogeneousPoint& base = a.w != 0.0 ? a : b;
  const HomogeneousPoint& other = a.w != 0.0 ? b : a;
  return { Xyz(base), Xyz(other) - other.w * Xyz(base) };
}

// On which side of a line an edge passes. Evaluated from the lower vertex index to the higher one,
// so that both triangles at the edge get the very same answer.
bool PassesLeft(const CasterMesh& mesh, const Line& line, int a, int b)
{
  const bool swapped = a > b;
  if (swapped)
  {
    std::swap(a, b);
  }
  const glm::dvec3 u = mesh.Points[a] - line.Origin;
  const glm::dvec3 v = mesh.Points[b] - line.Origin;
  const bool left = glm::dot(glm::cross(u, v), line.Direction) >= 0.0;
  return left != swapped;
}

bool LineHits(const CasterMesh& mesh, const Line& line, const std::array<int, 3>& t)
{
  const bool left = PassesLeft(mesh, line, t[0], t[1]);
  return PassesLeft(mesh, line, t[1], t[2]) == left && PassesLeft(mesh, line, t[2], t[0]) == left;
}

// Whether the way between two points can touch the box. A slab test with a margin for rounding.
bool TouchesBounds(const CasterMesh& mesh, const HomogeneousPoint& a, const HomogeneousPoint& b)
{
  const Line line = Connect(a, b);
  const glm::dvec3 margin = 1e-9 * (mesh.BoundsMax - mesh.BoundsMin) +
    1e-12 * (glm::abs(mesh.BoundsMin) + glm::abs(mesh.BoundsMax) + glm::abs(line.Origin));
  double from = 0.0;
  double to = a.w != 0.0 && b.w != 0.0 ? 1.0 : 1e300;
  for (int i = 0; i < 3; ++i)
  {
    const double lo = mesh.BoundsMin[i] - margin[i] - line.Origin[i];
    const double hi = mesh.BoundsMax[i] + margin[i] - line.Origin[i];
    const double d = line.Direction[i];
    if (d == 0.0)
    {
      if (lo > 0.0 || hi < 0.0)
      {
        return false;
      }
      continue;
    }
    from = std::max(from, std::min(lo / d, hi / d));
    to = std::min(to, std::max(lo / d, hi / d));
  }
  return from <= to * (1.0 + 1e-9);
}
}

//------------------------------------------------------------------------------
std::vector<SilhouetteEdge> FindSilhouette(const CasterMesh& mesh, const HomogeneousPoint& light)
{
  std::vector<signed char> facing(mesh.Planes.size());
  for (size_t f = 0; f < facing.size(); ++f)
  {
    facing[f] = static_cast<signed char>(Side(mesh.Planes[f], light));
  }
  std::vector<SilhouetteEdge> silhouette;
  for (size_t e = 0; e < mesh.Edges.size(); ++e)
  {
    int weight = 0;
    const int end = mesh.EndOfUses(e);
    for (int u = mesh.Edges[e].FirstUse; u < end; ++u)
    {
      const int direction = mesh.Uses[u] % 2 == 1 ? 1 : -1;
      weight += direction * facing[mesh.Uses[u] / 2];
    }
    if (weight > 0)
    {
      silhouette.push_back({ mesh.Edges[e].Low, mesh.Edges[e].High, weight });
    }
    else if (weight < 0)
    {
      silhouette.push_back({ mesh.Edges[e].High, mesh.Edges[e].Low, -weight });
    }
  }
  return silhouette;
}

//------------------------------------------------------------------------------
int CountShadowsAt(
  const CasterMesh& mesh, const HomogeneousPoint& light, const HomogeneousPoint& point)
{
  // Between two points at infinity lies nothing finite.
  if ((light.w == 0.0 && point.w == 0.0) || mesh.Triangles.empty() ||
    !TouchesBounds(mesh, light, point))
  {
    return 0;
  }
  const Line line = Connect(light, point);
  int count = 0;
  for (size_t f = 0; f < mesh.Triangles.size(); ++f)
  {
    // A triangle that the light sees edge-on casts nothing, as in FindSilhouette.
    if (Side(mesh.Planes[f], light) * Side(mesh.Planes[f], point) < 0 &&
      LineHits(mesh, line, mesh.Triangles[f]))
    {
      ++count;
    }
  }
  return count;
}
}
