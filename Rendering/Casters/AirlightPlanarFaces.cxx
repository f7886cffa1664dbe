// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightPlanarFaces.h"

#include "Silhouette/AirlightCasterMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace airlight
{
namespace
{
constexpr size_t MostPlanes = 6;
constexpr size_t MostCorners = 4;
// Of a mesh's extent: what points of single precision are off.
constexpr double Tolerance = 1e-6;

double Cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// The triangles of a mesh that lie in one plane.
struct PlaneGroup
{
  glm::dvec3 Normal{ 0.0 }; // unit
  double Offset = 0.0;
  double Area = 0.0;
  std::vector<CasterMesh::EdgeEnds> Border;
  bool IsPlain = true; // no edge has two of its triangles on the same side
};

double GetDistance(const PlaneGroup& group, const glm::dvec3& point)
{
  return std::abs(glm::dot(group.Normal, point) + group.Offset);
}

class FaceFinder
{
public:
  explicit FaceFinder(const CasterMesh& mesh)
    : Mesh(mesh)
    , Nearness(Tolerance * glm::length(mesh.BoundsMax - mesh.BoundsMin))
  {
  }

  std::vector<PlanarFace> Find()
  {
    std::vector<PlanarFace> faces;
    if (!this->GroupTriangles())
    {
      return faces;
    }
    this->FindBorders();
    for (const PlaneGroup& group : this->Groups)
    {
      PlanarFace face = this->MakeFace(group);
      if (!face.empty())
      {
        faces.push_back(std::move(face));
      }
    }
    return faces;
  }

private:
  // Where a triangle belongs, and whether it is turned against the group's normal.
  struct Membership
  {
    size_t Group = MostPlanes; // none: it has no area
    bool Flipped = false;
  };

  bool GroupTriangles();
  bool AddTriangle(size_t triangle);
  void FindBorders();
  template <typename Uses>
  void AddEdge(const CasterMesh::EdgeEnds& ends, const Uses& uses);
  PlanarFace MakeFace(const PlaneGroup& group) const;

  const CasterMesh& Mesh;
  double Nearness;
  std::vector<PlaneGroup> Groups;
  std::vector<Membership> Memberships; // by triangle
};

//------------------------------------------------------------------------------
// False where there are too many planes.
bool FaceFinder::GroupTriangles()
{
  this->Memberships.resize(this->Mesh.Triangles.size());
  for (size_t f = 0; f < this->Memberships.size(); ++f)
  {
    if (!this->AddTriangle(f))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool FaceFinder::AddTriangle(size_t triangle)
{
  const glm::dvec3 normal(this->Mesh.Planes[triangle]);
  const double length = glm::length(normal);
  if (!(length > this->Nearness * this->Nearness))
  {
    return true;
  }
  const std::array<int, 3>& corners = this->Mesh.Triangles[triangle];
  const auto holds = [&](const PlaneGroup& group) {
    return std::all_of(corners.begin(), corners.end(),
      [&](int point) { return GetDistance(group, this->Mesh.Points[point]) <= this->Nearness; });
  };
  const auto found = std::find_if(this->Groups.begin(), this->Groups.end(), holds);
  const auto index = static_cast<size_t>(found - this->Groups.begin());
  if (found == this->Groups.end())
  {
    if (this->Groups.size() == MostPlanes)
    {
      return false;
    }
    PlaneGroup group;
    group.Normal = normal / length;
    group.Offset = this->Mesh.Planes[triangle].w / length;
    this->Groups.push_back(group);
  }
  PlaneGroup& group = this->Groups[index];
  group.Area += 0.5 * length;
  this->Memberships[triangle] = { index, glm::dot(group.Normal, normal) < 0.0 };
  return true;
}

//------------------------------------------------------------------------------
// All triangles turned to the group's normal, those inside it run along an edge in both directions.
template <typename Uses>
void FaceFinder::AddEdge(const CasterMesh::EdgeEnds& ends, const Uses& uses)
{
  std::array<int, MostPlanes + 1> sums{};
  for (const CasterMesh::EdgeUse use : uses)
  {
    const Membership& membership = this->Memberships[use / 2];
    sums[membership.Group] += (use % 2 == 1) != membership.Flipped ? 1 : -1;
  }
  for (size_t g = 0; g < this->Groups.size(); ++g)
  {
    PlaneGroup& group = this->Groups[g];
    if (sums[g] != 0)
    {
      group.Border.push_back(ends);
    }
    group.IsPlain = group.IsPlain && std::abs(sums[g]) <= 1;
  }
}

//------------------------------------------------------------------------------
void FaceFinder::FindBorders()
{
  const CasterMesh& mesh = this->Mesh;
  for (size_t i = 0; i < mesh.PairEnds.size(); ++i)
  {
    this->AddEdge(mesh.PairEnds[i], mesh.PairUses[i]);
  }
  for (size_t i = 0; i < mesh.OtherEnds.size(); ++i)
  {
    this->AddEdge(mesh.OtherEnds[i],
      std::vector<CasterMesh::EdgeUse>(
        mesh.OtherUses.begin() + mesh.FirstUse[i], mesh.OtherUses.begin() + mesh.FirstUse[i + 1]));
  }
}

//------------------------------------------------------------------------------
// The convex hull, counterclockwise (Andrew's monotone chain).
std::vector<glm::dvec2> FindHull(std::vector<glm::dvec2> points)
{
  std::sort(points.begin(), points.end(),
    [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<glm::dvec2> hull;
  for (int half = 0; half < 2; ++half)
  {
    const size_t start = hull.size();
    for (const glm::dvec2& point : points)
    {
      while (hull.size() >= start + 2 &&
        Cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back(); // the other half begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// How far a point is from the line through two others.
double GetDistanceToLine(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b)
{
  return std::abs(Cross(b - a, point - a)) / glm::length(b - a);
}

// Without corners that lie on the line between their neighbours.
std::vector<glm::dvec2> Straighten(const std::vector<glm::dvec2>& hull, double nearness)
{
  std::vector<glm::dvec2> corners;
  for (size_t i = 0; i < hull.size() && corners.size() <= MostCorners; ++i)
  {
    const glm::dvec2& before = corners.empty() ? hull.back() : corners.back();
    const glm::dvec2& after = hull[(i + 1) % hull.size()];
    if (GetDistanceToLine(hull[i], before, after) > nearness)
    {
      corners.push_back(hull[i]);
    }
  }
  return corners;
}

double GetArea(const std::vector<glm::dvec2>& corners)
{
  double twice = 0.0;
  for (size_t i = 0; i < corners.size(); ++i)
  {
    twice += Cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return 0.5 * twice;
}

bool IsOnSide(
  const std::vector<glm::dvec2>& corners, const glm::dvec2& a, const glm::dvec2& b, double nearness)
{
  for (size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec2& from = corners[i];
    const glm::dvec2& to = corners[(i + 1) % corners.size()];
    if (GetDistanceToLine(a, from, to) <= nearness && GetDistanceToLine(b, from, to) <= nearness)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// How many triangles cover a place changes at the group's borders only. Where all of these are on
// the outline of the convex hull it is the same number everywhere inside, and 1 where the areas are
// the same.
PlanarFace FaceFinder::MakeFace(const PlaneGroup& group) const
{
  if (!group.IsPlain || group.Border.size() < 3)
  {
    return {};
  }
  const glm::dvec3 aside =
    std::abs(group.Normal.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(group.Normal, aside));
  const glm::dvec3 y = glm::cross(group.Normal, x);
  const auto flatten = [&](int point) {
    const glm::dvec3& p = this->Mesh.Points[point];
    return glm::dvec2(glm::dot(x, p), glm::dot(y, p));
  };
  std::vector<glm::dvec2> points;
  points.reserve(2 * group.Border.size());
  for (const CasterMesh::EdgeEnds& ends : group.Border)
  {
    points.push_back(flatten(ends[0]));
    points.push_back(flatten(ends[1]));
  }
  const double nearness = 4.0 * this->Nearness;
  const std::vector<glm::dvec2> corners = Straighten(FindHull(points), nearness);
  if (corners.size() < 3 || corners.size() > MostCorners)
  {
    return {};
  }
  for (size_t i = 0; i < points.size(); i += 2)
  {
    if (!IsOnSide(corners, points[i], points[i + 1], nearness))
    {
      return {};
    }
  }
  const double area = GetArea(corners);
  if (!(std::abs(group.Area - area) <= 1e-5 * area))
  {
    return {};
  }
  PlanarFace face;
  for (const glm::dvec2& corner : corners)
  {
    face.push_back(corner.x * x + corner.y * y - group.Offset * group.Normal);
  }
  return face;
}
}

//------------------------------------------------------------------------------
std::vector<PlanarFace> FindPlanarFaces(const CasterMesh& mesh) { return FaceFinder(mesh).Find(); }
}
