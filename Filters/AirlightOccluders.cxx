// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightOccluders.h"

#include "AirlightOccluderTree.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
const char* const CellIds = "AirlightCellIds";

// The polygons and strips as triangles that know their cells.
void Triangulate(vtkPolyData* data, vtkTriangleFilter* triangulate)
{
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName(CellIds);
  cells->SetNumberOfValues(data->GetNumberOfCells());
  for (vtkIdType i = 0; i < cells->GetNumberOfValues(); ++i)
  {
    cells->SetValue(i, i);
  }
  vtkNew<vtkPolyData> copy; // keeps the pipeline from touching the caller's data
  copy->CopyStructure(data);
  copy->GetCellData()->AddArray(cells);
  triangulate->SetInputData(copy);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
}

glm::dvec3 Transform(vtkMatrix4x4* matrix, const glm::dvec3& p)
{
  if (!matrix)
  {
    return p;
  }
  const double in[4] = { p.x, p.y, p.z, 1.0 };
  glm::dvec4 out;
  matrix->MultiplyPoint(in, &out.x);
  return glm::dvec3(out) / out.w;
}

double LargestCoordinate(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

// Large enough to be told from rounding, and of coordinates whose products are finite.
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

bool Precedes(const glm::dvec3& a, const glm::dvec3& b)
{
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

// An edge from its lower to its higher end, the same for all triangles that share it.
struct Edge
{
  Edge(const glm::dvec3& a, const glm::dvec3& b)
    : Turned(Precedes(b, a))
    , P(Turned ? b : a)
    , Q(Turned ? a : b)
  {
  }

  bool Turned;
  glm::dvec3 P;
  glm::dvec3 Q;
};

// Volume between the ray's line and an edge, above 0 where the line passes on the edge's left.
double EdgeSide(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& origin, const glm::dvec3& direction)
{
  const Edge edge(a, b);
  const double volume = glm::dot(direction, glm::cross(edge.P - origin, edge.Q - origin));
  return edge.Turned ? -volume : volume;
}

// Where the ray's line meets the triangle; NaN where it does not. Lines through a shared edge meet
// at least one of its triangles, as the signs for both come from the same number.
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
struct Occluders::Tree : public OccluderTree
{
  using OccluderTree::OccluderTree;
};

//------------------------------------------------------------------------------
Occluders::Occluders() = default;
Occluders::~Occluders() = default;
Occluders::Occluders(Occluders&&) noexcept = default;
Occluders& Occluders::operator=(Occluders&&) noexcept = default;

//------------------------------------------------------------------------------
void Occluders::Add(vtkPolyData* data, vtkMatrix4x4* toWorld, int caster)
{
  if (!data || !data->GetPoints() || data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    return;
  }
  vtkNew<vtkTriangleFilter> triangulate;
  Triangulate(data, triangulate);
  vtkPolyData* triangles = triangulate->GetOutput();
  vtkDataArray* cells = triangles->GetCellData()->GetArray(CellIds);
  auto cell = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    if (size != 3)
    {
      continue;
    }
    glm::dvec3 corners[3];
    for (int i = 0; i < 3; ++i)
    {
      triangles->GetPoint(ids[i], &corners[i].x);
      corners[i] = Transform(toWorld, corners[i]);
    }
    const auto id = static_cast<long long>(cells->GetTuple1(cell->GetCurrentCellId()));
    const OccluderTriangle t{ corners[0], corners[1], corners[2], caster, id };
    if (IsGood(t))
    {
      this->Triangles.push_back(t);
    }
  }
}

//------------------------------------------------------------------------------
void Occluders::Build()
{
  this->Scale = 0.0;
  for (const OccluderTriangle& t : this->Triangles)
  {
    for (const glm::dvec3* p : { &t.A, &t.B, &t.C })
    {
      this->Scale = std::max(this->Scale, LargestCoordinate(*p));
    }
  }
  this->Boxes = std::make_unique<Tree>(this->Triangles);
}

//------------------------------------------------------------------------------
bool Occluders::FirstHit(const glm::dvec3& origin, const glm::dvec3& unitDirection, double t0,
  double t1, Hit& hit, const Predicate& skip) const
{
  hit = { t1, -1 };
  const double scale = std::max(this->Scale, LargestCoordinate(origin));
  this->Boxes->VisitRay(origin, unitDirection, t0, hit.T, 1e-14 * scale, [&](int i) {
    const double t = HitTriangle(this->Triangles[i], origin, unitDirection);
    const bool nearer = t < hit.T || (t == hit.T && i < hit.Triangle);
    if (t > t0 && nearer && !(skip && skip(i)))
    {
      hit = { t, i };
    }
    return false;
  });
  return hit.Triangle >= 0;
}

//------------------------------------------------------------------------------
bool Occluders::Blocked(const glm::dvec3& point, const HomogeneousPoint& light, double margin,
  const Predicate& skip) const
{
  const glm::dvec3 way = glm::dvec3(light) - light.w * point;
  const double length = glm::length(way);
  if (!(length > 0.0))
  {
    return false;
  }
  const glm::dvec3 direction = way / length;
  const double end =
    light.w != 0.0 ? length / std::abs(light.w) - margin : std::numeric_limits<double>::infinity();
  const double scale = std::max(this->Scale, LargestCoordinate(point));
  return this->Boxes->VisitRay(point, direction, margin, end, 1e-14 * scale, [&](int i) {
    const double t = HitTriangle(this->Triangles[i], point, direction);
    return t > margin && t < end && !(skip && skip(i));
  });
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

//------------------------------------------------------------------------------
void Occluders::FindShadows(const HomogeneousPoint& light, const glm::dvec3& origin,
  const glm::dvec3& unitDirection, double t0, double t1, std::vector<Shadow>& shadows) const
{
  shadows.clear();
  if (!(t0 < t1))
  {
    return;
  }
  const OccluderFan fan(light, origin, unitDirection, t0, t1, this->Scale);
  this->Boxes->VisitFan(fan, [&](int i) {
    Shadow shadow{ t0, t1, i };
    if (FindShadow(
          this->Triangles[i], light, origin, unitDirection, t0, t1, shadow.From, shadow.To))
    {
      shadows.push_back(shadow);
    }
  });
}

//------------------------------------------------------------------------------
void Occluders::LitIntervals(
  std::vector<Shadow>& shadows, double t0, double t1, std::vector<Interval>& lit, double gap)
{
  lit.clear();
  std::sort(shadows.begin(), shadows.end(), [](const Shadow& a, const Shadow& b) {
    return a.From != b.From ? a.From < b.From : a.Triangle < b.Triangle;
  });
  double from = t0;
  int cause = -1;
  for (const Shadow& shadow : shadows)
  {
    if (!(shadow.To - shadow.From > gap))
    {
      continue;
    }
    if (shadow.From - from > gap && from < t1)
    {
      const bool ends = shadow.From < t1;
      lit.push_back({ from, std::min(shadow.From, t1), cause, ends ? shadow.Triangle : -1 });
    }
    if (shadow.To > from)
    {
      from = shadow.To;
      cause = shadow.Triangle;
    }
  }
  if (t1 - from > gap || (cause < 0 && from < t1))
  {
    lit.push_back({ from, t1, cause, -1 });
  }
}

//------------------------------------------------------------------------------
double Occluders::GetGap(const HomogeneousPoint& light, const glm::dvec3& origin) const
{
  const double lightScale = light.w != 0.0 ? LargestCoordinate(glm::dvec3(light)) : 0.0;
  return 1e-12 * std::max({ this->Scale, lightScale, LargestCoordinate(origin) });
}
}
