// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Occlusion/AirlightOccluderTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
bool Precedes(const glm::dvec3& a, const glm::dvec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

// An edge from its lower to its higher end, the same for all triangles that share it.
struct Edge
{
  Edge(const glm::dvec3& a, const glm::dvec3& b)
    : Flipped(Precedes(b, a))
    , P(Flipped ? b : a)
    , Q(Flipped ? a : b)
  {
  }

  bool Flipped;
  glm::dvec3 P;
  glm::dvec3 Q;
};

// Volume between the ray's line and an edge, above 0 where the line passes on the edge's left.
double EdgeSide(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& origin, const glm::dvec3& direction)
{
  const Edge edge(a, b);
  const double volume = glm::dot(direction, glm::cross(edge.P - origin, edge.Q - origin));
  return edge.Flipped ? -volume : volume;
}

// Keeps the part of [from, to] where the ray is on the positive side of the plane through `point`.
void Clip(const glm::dvec3& normal, const glm::dvec3& point, double sign, const glm::dvec3& origin,
  const glm::dvec3& direction, double& from, double& to)
{
  const double slope = glm::dot(normal, direction);
  const double offset = glm::dot(normal, origin - point);
  if (slope == 0.0)
  {
    to = sign * offset >= 0.0 ? to : from;
    return;
  }
  const double t = -offset / slope;
  if (sign * slope > 0.0)
  {
    from = std::max(from, t);
  }
  else
  {
    to = std::min(to, t);
  }
}
}

//------------------------------------------------------------------------------
bool IsGood(const OccluderTriangle& t)
{
  for (const glm::dvec3* p : { &t.A, &t.B, &t.C })
  {
    if (!glm::all(glm::lessThanEqual(glm::abs(*p), glm::dvec3(1e50))))
    {
      return false;
    }
  }
  const double longest =
    std::max({ glm::distance(t.A, t.B), glm::distance(t.B, t.C), glm::distance(t.C, t.A) });
  return glm::length(glm::cross(t.B - t.A, t.C - t.A)) > 1e-13 * longest * longest;
}

//------------------------------------------------------------------------------
double HitTriangle(const OccluderTriangle& t, const glm::dvec3& origin, const glm::dvec3& direction)
{
  const double sides[3] = { EdgeSide(t.A, t.B, origin, direction),
    EdgeSide(t.B, t.C, origin, direction), EdgeSide(t.C, t.A, origin, direction) };
  const auto [least, greatest] = std::minmax_element(sides, sides + 3);
  if (*least < 0.0 && *greatest > 0.0)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const glm::dvec3 normal = glm::cross(t.B - t.A, t.C - t.A);
  return glm::dot(normal, t.A - origin) / glm::dot(normal, direction);
}

//------------------------------------------------------------------------------
bool FindShadow(const OccluderTriangle& triangle, const HomogeneousPoint& light,
  const glm::dvec3& origin, const glm::dvec3& unitDirection, double t0, double t1, double& from,
  double& to)
{
  const glm::dvec3 corners[3] = { triangle.A, triangle.B, triangle.C };
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const glm::dvec3 toLight = glm::dvec3(light) - light.w * corners[0];
  const double facing = glm::dot(normal, toLight);
  if (!(std::abs(facing) > 1e-12 * glm::length(normal) * glm::length(toLight)))
  {
    return false;
  }
  from = t0;
  to = t1;
  Clip(normal, corners[0], facing > 0.0 ? -1.0 : 1.0, origin, unitDirection, from, to);
  for (int i = 0; i < 3 && from < to; ++i)
  {
    const Edge edge(corners[i], corners[(i + 1) % 3]);
    const glm::dvec3 side = glm::cross(edge.Q - edge.P, glm::dvec3(light) - light.w * edge.P);
    const double sign = glm::dot(side, corners[(i + 2) % 3] - edge.P) < 0.0 ? -1.0 : 1.0;
    Clip(side, edge.P, sign, origin, unitDirection, from, to);
  }
  return from < to;
}
}
