// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Occlusion/AirlightOccluders.h"

#include "Occlusion/AirlightOccluderTree.h"
#include "Occlusion/AirlightOccluderTriangle.h"
#include "Region/AirlightTriangulate.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
const char* const CellIds = "AirlightCellIds";

// The polygons and strips as triangles that know their cells.
vtkSmartPointer<vtkPolyData> TriangulateCells(vtkPolyData* data)
{
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName(CellIds);
  cells->SetNumberOfValues(data->GetNumberOfCells());
  for (vtkIdType i = 0; i < cells->GetNumberOfValues(); ++i)
  {
    cells->SetValue(i, i);
  }
  return Triangulate(data, cells);
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

//------------------------------------------------------------------------------
void Occluders::Add(vtkPolyData* data, vtkMatrix4x4* toWorld, int caster)
{
  if (!data || !data->GetPoints() || data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    return;
  }
  const vtkSmartPointer<vtkPolyData> triangles = TriangulateCells(data);
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
    const OccluderTriangle& triangle = this->Triangles[i];
    Shadow shadow{ t0, t1, i };
    if (fan.MayMeet(triangle) &&
      FindShadow(triangle, light, origin, unitDirection, t0, t1, shadow.From, shadow.To))
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
