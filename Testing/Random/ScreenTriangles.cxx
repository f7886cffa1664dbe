// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ScreenTriangles.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <limits>

namespace airlight_test
{
namespace
{
double Cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// The nearest point of a polygon's border.
glm::dvec2 FindNearest(const std::vector<glm::dvec2>& polygon, const glm::dvec2& p)
{
  glm::dvec2 nearest = polygon[0];
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 d = polygon[(i + 1) % polygon.size()] - a;
    const double length2 = glm::dot(d, d);
    const double share = length2 > 0.0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec2 q = a + share * d;
    nearest = glm::distance(q, p) < glm::distance(nearest, p) ? q : nearest;
  }
  return nearest;
}

// The part (from, to) of the line p + s d in a convex polygon; to < from: none.
glm::dvec2 Clip(
  const std::vector<glm::dvec2>& polygon, double turn, const glm::dvec2& p, const glm::dvec2& d)
{
  glm::dvec2 range(-std::numeric_limits<double>::infinity(), 0.0);
  range.y = -range.x;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 edge = polygon[(i + 1) % polygon.size()] - a;
    // Inside where inside + s slope >= 0.
    const double inside = turn * Cross(edge, p - a);
    const double slope = turn * Cross(edge, d);
    if (slope > 0.0)
    {
      range.x = std::max(range.x, -inside / slope);
    }
    else if (slope < 0.0)
    {
      range.y = std::min(range.y, -inside / slope);
    }
    else if (inside < 0.0)
    {
      range.y = -std::numeric_limits<double>::infinity();
    }
  }
  return range;
}

double GetTwiceArea(const std::vector<glm::dvec2>& polygon)
{
  double area = 0.0;
  for (size_t i = 2; i < polygon.size(); ++i)
  {
    area += Cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return area;
}
}

//------------------------------------------------------------------------------
ScreenTriangles::ScreenTriangles(vtkRenderer* renderer, int width, int height)
{
  vtkMatrix4x4* clip = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    static_cast<double>(width) / height, -1.0, 1.0);
  vtkCollectionSimpleIterator it = nullptr;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    vtkNew<vtkMatrix4x4> toClip;
    vtkMatrix4x4::Multiply4x4(clip, actor->GetMatrix(), toClip);
    for (vtkIdType cell = 0; actor->GetVisibility() && cell < mesh->GetNumberOfCells(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetCellPoints(cell, count, ids);
      glm::dvec4 corners[3];
      for (int k = 0; k < 3; ++k)
      {
        double p[4] = { 0.0, 0.0, 0.0, 1.0 };
        mesh->GetPoint(ids[k], p);
        toClip->MultiplyPoint(p, &corners[k].x);
      }
      Polygon polygon;
      const auto add = [&](const glm::dvec4& p) {
        polygon.emplace_back(0.5 * width * (1.0 + p.x / p.w), 0.5 * height * (1.0 + p.y / p.w));
      };
      for (int k = 0; k < 3; ++k)
      {
        const glm::dvec4& a = corners[k];
        const glm::dvec4& b = corners[(k + 1) % 3];
        const double nearest = 1e-9 * std::max(std::abs(a.w), std::abs(b.w));
        if (a.w > nearest)
        {
          add(a);
        }
        if ((a.w > nearest) != (b.w > nearest))
        {
          add(glm::mix(a, b, (a.w - nearest) / (a.w - b.w)));
        }
      }
      if (polygon.size() > 2)
      {
        this->Polygons.push_back(polygon);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<glm::dvec2> ScreenTriangles::FindPlaces(const glm::dvec2& pixel, double reach) const
{
  std::vector<glm::dvec2> places;
  for (const Polygon& polygon : this->Polygons)
  {
    const glm::dvec2 nearest = FindNearest(polygon, pixel);
    const double distance = glm::distance(nearest, pixel);
    if (!(distance > 0.0 && distance < reach))
    {
      continue;
    }
    // Right behind the border, and in the middle of what the polygon has of the line through both.
    const glm::dvec2 direction = (nearest - pixel) / distance;
    const glm::dvec2 range =
      Clip(polygon, GetTwiceArea(polygon) < 0.0 ? -1.0 : 1.0, pixel, direction);
    if (range.x > 0.0 && range.y >= range.x)
    {
      const double width = std::min(range.y - range.x, reach);
      places.push_back(pixel + (range.x + 1e-3 * width) * direction);
      places.push_back(pixel + (range.x + 0.5 * width) * direction);
    }
  }
  return places;
}

//------------------------------------------------------------------------------
bool ScreenTriangles::IsNearBorder(const glm::dvec2& pixel, double reach) const
{
  return std::any_of(this->Polygons.begin(), this->Polygons.end(), [&](const Polygon& polygon) {
    return glm::distance(FindNearest(polygon, pixel), pixel) < reach;
  });
}
}
