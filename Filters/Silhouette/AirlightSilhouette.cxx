// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightSilhouette.h"

#include "Silhouette/AirlightParallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace airlight
{
namespace
{
// Relative to the largest coordinate: how close to a triangle counts as on it.
constexpr double OnMeshTolerance = 1e-14;

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

// What a triangle adds to the weight of an edge that it uses.
int Contribution(const std::vector<signed char>& facings, CasterMesh::EdgeUse use)
{
  // NOLINTNEXTLINE(bugprone-signed-char-misuse): a number that may be -1, no character
  const int facing = facings[use >> 1];
  return (use & 1) != 0 ? facing : -facing;
}

void AddEdge(const CasterMesh::EdgeEnds& ends, int weight, std::vector<SilhouetteEdge>& silhouette)
{
  if (weight != 0)
  {
    const bool up = weight > 0;
    silhouette.push_back({ ends[up ? 0 : 1], ends[up ? 1 : 0], std::abs(weight) });
  }
}

bool HoldsPoint(const CasterMesh& mesh, size_t triangle, const glm::dvec3& point, double tolerance)
{
  const glm::dvec3 normal = Xyz(mesh.Planes[triangle]);
  const double area = glm::length(normal);
  const std::array<int, 3>& t = mesh.Triangles[triangle];
  if (!(std::abs(glm::dot(normal, point - mesh.Points[t[0]])) <= tolerance * area))
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec3& a = mesh.Points[t[k]];
    const glm::dvec3 along = mesh.Points[t[(k + 1) % 3]] - a;
    const double inside = glm::dot(glm::cross(along, point - a), normal);
    if (inside < -tolerance * area * glm::length(along))
    {
      return false;
    }
  }
  return area > 0.0;
}
}

//------------------------------------------------------------------------------
std::vector<signed char> FindFacings(const CasterMesh& mesh, const HomogeneousPoint& light)
{
  std::vector<signed char> facings(mesh.Planes.size());
  ForEachChunk(facings.size(), [&](size_t, size_t begin, size_t end) {
    for (size_t f = begin; f < end; ++f)
    {
      facings[f] = static_cast<signed char>(Side(mesh.Planes[f], light));
    }
  });
  return facings;
}

//------------------------------------------------------------------------------
std::vector<SilhouetteEdge> FindSilhouette(const CasterMesh& mesh, const HomogeneousPoint& light)
{
  const std::vector<signed char> facings = FindFacings(mesh, light);
  const size_t pairChunks = CountChunks(mesh.PairUses.size());
  std::vector<std::vector<SilhouetteEdge>> parts(pairChunks + CountChunks(mesh.OtherEnds.size()));
  ForEachChunk(mesh.PairUses.size(), [&](size_t chunk, size_t begin, size_t end) {
    std::vector<SilhouetteEdge> part;
    for (size_t e = begin; e < end; ++e)
    {
      const std::array<CasterMesh::EdgeUse, 2>& uses = mesh.PairUses[e];
      const int weight = Contribution(facings, uses[0]) + Contribution(facings, uses[1]);
      if (weight != 0)
      {
        AddEdge(mesh.PairEnds[e], weight, part);
      }
    }
    parts[chunk] = std::move(part);
  });
  ForEachChunk(mesh.OtherEnds.size(), [&](size_t chunk, size_t begin, size_t end) {
    std::vector<SilhouetteEdge> part;
    for (size_t e = begin; e < end; ++e)
    {
      int weight = 0;
      for (int u = mesh.FirstUse[e]; u < mesh.FirstUse[e + 1]; ++u)
      {
        weight += Contribution(facings, mesh.OtherUses[u]);
      }
      AddEdge(mesh.OtherEnds[e], weight, part);
    }
    parts[pairChunks + chunk] = std::move(part);
  });
  return Concatenate(std::move(parts));
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
  std::atomic<int> count{ 0 };
  ForEachChunk(mesh.Triangles.size(), [&](size_t, size_t begin, size_t end) {
    int found = 0;
    for (size_t f = begin; f < end; ++f)
    {
      // A triangle that the light sees edge-on casts nothing, as in FindSilhouette.
      if (Side(mesh.Planes[f], light) * Side(mesh.Planes[f], point) < 0 &&
        LineHits(mesh, line, mesh.Triangles[f]))
      {
        ++found;
      }
    }
    count += found;
  });
  return count;
}

//------------------------------------------------------------------------------
int FindTriangleAt(const CasterMesh& mesh, const glm::dvec3& point)
{
  const glm::dvec3 size = glm::max(glm::abs(mesh.BoundsMin), glm::abs(mesh.BoundsMax));
  const double tolerance = OnMeshTolerance * std::max({ size.x, size.y, size.z });
  if (glm::any(glm::lessThan(point, mesh.BoundsMin - tolerance)) ||
    glm::any(glm::greaterThan(point, mesh.BoundsMax + tolerance)))
  {
    return -1;
  }
  const auto count = static_cast<int>(mesh.Triangles.size());
  std::atomic<int> lowest{ count }; // whichever thread finds its own first
  ForEachChunk(mesh.Triangles.size(), [&](size_t, size_t begin, size_t end) {
    for (size_t f = begin; f < end && static_cast<int>(f) < lowest; ++f)
    {
      if (HoldsPoint(mesh, f, point, tolerance))
      {
        int found = lowest;
        while (
          static_cast<int>(f) < found && !lowest.compare_exchange_weak(found, static_cast<int>(f)))
        {
        }
      }
    }
  });
  return lowest < count ? lowest.load() : -1;
}
}
