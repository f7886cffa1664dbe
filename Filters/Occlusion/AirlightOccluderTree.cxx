// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Occlusion/AirlightOccluderTree.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace airlight
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

double Largest(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

Eigen::Vector3d Convert(const glm::dvec3& v) { return { v.x, v.y, v.z }; }
}

//------------------------------------------------------------------------------
// With L the way from the origin to the light (its direction if that is at infinity) and n = d x L
// the plane is dot(n, x - origin) = 0. A side that goes from the light along e and has the ray's
// later points on its positive side has the normal n x e, as dot(n x e, d) = dot(n, n) for all
// e = a d - L.
OccluderFan::OccluderFan(const HomogeneousPoint& light, const glm::dvec3& origin,
  const glm::dvec3& unitDirection, double t0, double t1, double scale)
  : Origin(origin)
{
  const bool isFinite = light.w != 0.0;
  const glm::dvec3 toLight = isFinite ? glm::dvec3(light) / light.w - origin : glm::dvec3(light);
  const glm::dvec3 n = glm::cross(unitDirection, toLight);
  const glm::dvec3 towards = toLight - glm::dot(toLight, unitDirection) * unitDirection;
  // Rounding, several times over: of the normals relative to L, of positions relative to the
  // largest of them.
  const double reach = Largest(origin) + scale;
  const double length =
    Largest(toLight) + (isFinite ? 2.0 * Largest(origin) : 0.0); // before the difference
  const double error = 1e-14 * length * reach;
  this->Plane = { n, glm::abs(n), error };
  this->AddSide(towards, glm::dvec3(0.0), error);

  const auto addEnd = [&](double sign, double t) {
    const bool isPoint = std::isfinite(t);
    if (!isPoint && !isFinite)
    {
      return; // the strip goes on for ever
    }
    const glm::dvec3 e = isFinite && isPoint ? t * unitDirection - toLight
      : isFinite                             ? unitDirection
                                             : -toLight;
    const glm::dvec3 through = isFinite ? toLight : t * unitDirection;
    const double span = std::max(Largest(e), 1.0) * (length + reach + Largest(through));
    this->AddSide(sign * glm::cross(n, e), through, 1e-14 * length * span);
  };
  addEnd(1.0, t0);
  addEnd(-1.0, t1);
  this->SetBounds(light, unitDirection, t0, t1, scale);
}

//------------------------------------------------------------------------------
void OccluderFan::AddSide(const glm::dvec3& normal, const glm::dvec3& point, double error)
{
  this->Sides[this->Count++] = { normal, glm::abs(normal), error - glm::dot(normal, point) };
}

//------------------------------------------------------------------------------
void OccluderFan::SetBounds(const HomogeneousPoint& light, const glm::dvec3& unitDirection,
  double t0, double t1, double scale)
{
  const auto reach = [](const glm::dvec3& from, const glm::dvec3& direction) {
    glm::dvec3 end;
    for (int i = 0; i < 3; ++i)
    {
      end[i] = direction[i] == 0.0 ? from[i] : std::copysign(Infinity, direction[i]);
    }
    return end;
  };
  const glm::dvec3 start = this->Origin + t0 * unitDirection;
  const glm::dvec3 end =
    std::isfinite(t1) ? this->Origin + t1 * unitDirection : reach(start, unitDirection);
  this->Bounds = { glm::min(start, end), glm::max(start, end) };
  if (light.w != 0.0)
  {
    const glm::dvec3 position = glm::dvec3(light) / light.w;
    this->Bounds = { glm::min(this->Bounds.Least, position),
      glm::max(this->Bounds.Greatest, position) };
  }
  else
  {
    const glm::dvec3 far = reach(start, glm::dvec3(light));
    this->Bounds = { glm::min(this->Bounds.Least, far), glm::max(this->Bounds.Greatest, far) };
  }
  const double error = 1e-14 * (Largest(this->Origin) + scale + std::abs(t0));
  this->Bounds.Least -= error;
  this->Bounds.Greatest += error;
}

//------------------------------------------------------------------------------
OccluderTree::OccluderTree(const std::vector<OccluderTriangle>& triangles)
{
  std::vector<int> ids(triangles.size());
  std::iota(ids.begin(), ids.end(), 0);
  std::vector<Boxes::Volume> boxes;
  boxes.reserve(triangles.size());
  for (const OccluderTriangle& t : triangles)
  {
    boxes.emplace_back(
      Convert(glm::min(glm::min(t.A, t.B), t.C)), Convert(glm::max(glm::max(t.A, t.B), t.C)));
  }
  this->Hierarchy.init(ids.begin(), ids.end(), boxes.begin(), boxes.end());
}
}
