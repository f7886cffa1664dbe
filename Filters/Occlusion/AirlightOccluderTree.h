// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The hierarchy of boxes behind AirlightOccluders.h: Eigen's tree, walked in our own order.
 */

#ifndef AirlightOccluderTree_h
#define AirlightOccluderTree_h

#include "Occlusion/AirlightOccluders.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace airlight
{
struct OccluderBox
{
  glm::dvec3 Least;
  glm::dvec3 Greatest;
};

// Where triangles lie that can cast a shadow on a part of a ray: between it and the light, in the
// plane of both. For a light at infinity that is a strip, otherwise a triangle. A little larger
// than that, so that rounding loses nothing.
class OccluderFan
{
public:
  // `scale` is the largest coordinate of the triangles.
  OccluderFan(const HomogeneousPoint& light, const glm::dvec3& origin,
    const glm::dvec3& unitDirection, double t0, double t1, double scale);

  // Never false for a box that the fan meets.
  bool MayMeet(const OccluderBox& box) const
  {
    if (glm::any(glm::lessThan(box.Greatest, this->Bounds.Least)) ||
      glm::any(glm::greaterThan(box.Least, this->Bounds.Greatest)))
    {
      return false;
    }
    const glm::dvec3 centre = 0.5 * (box.Least + box.Greatest) - this->Origin;
    const glm::dvec3 half = 0.5 * (box.Greatest - box.Least);
    if (std::abs(glm::dot(this->Plane.Normal, centre)) >
      glm::dot(this->Plane.Absolute, half) + this->Plane.Offset)
    {
      return false;
    }
    for (int i = 0; i < this->Count; ++i)
    {
      const Side& side = this->Sides[i];
      if (glm::dot(side.Normal, centre) + glm::dot(side.Absolute, half) + side.Offset < 0.0)
      {
        return false;
      }
    }
    return true;
  }

  // Never false for a triangle that the fan meets.
  bool MayMeet(const OccluderTriangle& t) const
  {
    const glm::dvec3 a = t.A - this->Origin;
    const glm::dvec3 b = t.B - this->Origin;
    const glm::dvec3 c = t.C - this->Origin;
    const double heights[3] = { glm::dot(this->Plane.Normal, a), glm::dot(this->Plane.Normal, b),
      glm::dot(this->Plane.Normal, c) };
    const auto [least, greatest] = std::minmax_element(heights, heights + 3);
    if (*least > this->Plane.Offset || *greatest < -this->Plane.Offset)
    {
      return false;
    }
    for (int i = 0; i < this->Count; ++i)
    {
      const Side& side = this->Sides[i];
      const double furthest =
        std::max({ glm::dot(side.Normal, a), glm::dot(side.Normal, b), glm::dot(side.Normal, c) });
      if (furthest + side.Offset < 0.0)
      {
        return false;
      }
    }
    return true;
  }

private:
  // dot(Normal, x - Origin) + Offset >= 0
  struct Side
  {
    glm::dvec3 Normal;
    glm::dvec3 Absolute; // of the normal, component by component
    double Offset;
  };

  void AddSide(const glm::dvec3& normal, const glm::dvec3& point, double error);
  void SetBounds(const HomogeneousPoint& light, const glm::dvec3& unitDirection, double t0,
    double t1, double scale);

  glm::dvec3 Origin;
  Side Plane; // abs(dot(Normal, x - Origin)) <= Offset
  std::array<Side, 3> Sides;
  int Count = 0;
  OccluderBox Bounds;
};

class OccluderTree
{
public:
  explicit OccluderTree(const std::vector<OccluderTriangle>& triangles);

  // Calls visit(triangle) for all triangles whose boxes the ray may meet between t0 and t1, nearer
  // boxes first, until it returns true, which is then returned. visit() may lower t1. Boxes are
  // made larger by `error`.
  template <typename Visit>
  bool VisitRay(const glm::dvec3& origin, const glm::dvec3& direction, double t0, const double& t1,
    double error, const Visit& visit) const;

  // Calls visit(triangle) for all triangles whose boxes may meet the fan.
  template <typename Visit>
  void VisitFan(const OccluderFan& fan, const Visit& visit) const;

private:
  using Boxes = Eigen::KdBVH<double, 3, int>;

  // Halved each time, the tree of 2^31 triangles is 31 deep; each level leaves one node waiting.
  static constexpr int MaxStack = 64;

  OccluderBox GetBox(int node) const
  {
    const Boxes::Volume& box = this->Hierarchy.getVolume(node);
    return { { box.min().x(), box.min().y(), box.min().z() },
      { box.max().x(), box.max().y(), box.max().z() } };
  }

  struct Children
  {
    Boxes::VolumeIterator Nodes = nullptr;
    Boxes::VolumeIterator NodesEnd = nullptr;
    Boxes::ObjectIterator Triangles = nullptr;
    Boxes::ObjectIterator TrianglesEnd = nullptr;
  };

  Children GetChildren(int node) const
  {
    Children c;
    this->Hierarchy.getChildren(node, c.Nodes, c.NodesEnd, c.Triangles, c.TrianglesEnd);
    return c;
  }

  Boxes Hierarchy;
};

//------------------------------------------------------------------------------
template <typename Visit>
bool OccluderTree::VisitRay(const glm::dvec3& origin, const glm::dvec3& direction, double t0,
  const double& t1, double error, const Visit& visit) const
{
  struct Entry
  {
    int Node;
    double From;
  };
  // Where the ray enters the box; above any t1 where it misses it. A ray in the plane of a face
  // divides 0 by 0: the comparisons then keep the other value.
  const glm::dvec3 inverse = 1.0 / direction;
  const auto enter = [&](int node, double& from) {
    const OccluderBox box = this->GetBox(node);
    const glm::dvec3 a = (box.Least - error - origin) * inverse;
    const glm::dvec3 b = (box.Greatest + error - origin) * inverse;
    double to = t1;
    from = t0;
    for (int i = 0; i < 3; ++i)
    {
      from = std::max(from, std::min(a[i], b[i]));
      to = std::min(to, std::max(a[i], b[i]));
    }
    return !(from > to);
  };
  std::array<Entry, MaxStack> stack;
  int count = 0;
  Entry root{ this->Hierarchy.getRootIndex(), t0 };
  if (root.Node < 0 || enter(root.Node, root.From))
  {
    stack[count++] = root;
  }
  while (count > 0)
  {
    const Entry entry = stack[--count];
    if (entry.From > t1)
    {
      continue;
    }
    const Children children = this->GetChildren(entry.Node);
    for (auto i = children.Triangles; i != children.TrianglesEnd; ++i)
    {
      if (visit(*i))
      {
        return true;
      }
    }
    const int before = count;
    for (auto i = children.Nodes; i != children.NodesEnd; ++i)
    {
      Entry next{ *i, t0 };
      if (enter(next.Node, next.From))
      {
        stack[count++] = next;
      }
    }
    if (count == before + 2 && stack[count - 1].From > stack[count - 2].From)
    {
      std::swap(stack[count - 1], stack[count - 2]);
    }
  }
  return false;
}

//------------------------------------------------------------------------------
template <typename Visit>
void OccluderTree::VisitFan(const OccluderFan& fan, const Visit& visit) const
{
  std::array<int, MaxStack> stack;
  int count = 0;
  const int root = this->Hierarchy.getRootIndex();
  if (root < 0 || fan.MayMeet(this->GetBox(root)))
  {
    stack[count++] = root;
  }
  while (count > 0)
  {
    const Children children = this->GetChildren(stack[--count]);
    std::for_each(children.Triangles, children.TrianglesEnd, visit);
    for (auto i = children.Nodes; i != children.NodesEnd; ++i)
    {
      if (fan.MayMeet(this->GetBox(*i)))
      {
        stack[count++] = *i;
      }
    }
  }
}
}

#endif
