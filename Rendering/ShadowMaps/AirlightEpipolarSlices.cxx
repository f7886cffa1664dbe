// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AirlightEpipolarSlices.h"

#include "Scene/AirlightCameraUniforms.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace airlight
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
// Half a circle and what single precision adds to it.
constexpr double HalfCircle = Pi + 1e-5;
// Of lengths: what is nearer to the pole counts as on it.
constexpr double OnPole = 1e-7;
// Of the columns' farthest end: so wide they are at least.
constexpr double LeastRange = 1e-6;
// With fewer, shadows of small pictures are as coarse as those.
constexpr int LeastRows = 1536;
// Both limit how fine shadows are, and rows across rays more than columns along them.
constexpr double RowsPerColumn = 1.5;
// Points on each of the picture's borders at which angles are taken.
constexpr int BorderPoints = 16;
// Of angles between those, and of roundings.
constexpr double ViewMargin = 0.02;

// Of a float from 1 on, 16 bits above this one are kept. For a light at a place, 11 bits after the
// point and five of the exponent hold distances down to 1e-9 of the largest. For a light at
// infinity all numbers are between 1 and 2.
constexpr int PointShift = 12;
constexpr int ParallelShift = 7;

double GetAngle(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Unit directions through the picture's border, corner by corner.
std::vector<glm::dvec3> GetBorder(const CameraUniforms& view)
{
  const auto corners = view.GetCornerRays();
  std::vector<glm::dvec3> border;
  for (size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec3& a = corners[i].Direction;
    const glm::dvec3& b = corners[(i + 1) % corners.size()].Direction;
    for (int k = 0; k < BorderPoints; ++k)
    {
      border.push_back(glm::normalize(glm::mix(a, b, double(k) / BorderPoints)));
    }
  }
  return border;
}

// Into the middle of the picture, which need not be along the camera's axis.
glm::dvec3 GetMiddle(const CameraUniforms& view)
{
  return view.GetRay(0.5 * view.GetWidth(), 0.5 * view.GetHeight()).Direction;
}

// Whether a direction or its opposite is in a perspective view or nearly so.
bool IsInView(const CameraUniforms& view, const glm::dvec3& direction)
{
  const auto corners = view.GetCornerRays();
  const glm::dvec3 middle = GetMiddle(view);
  bool inside[2] = { true, true };
  for (size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec3 side =
      glm::normalize(glm::cross(corners[i].Direction, corners[(i + 1) % corners.size()].Direction));
    const double inwards = glm::dot(side, middle) < 0.0 ? -1.0 : 1.0;
    const double height = inwards * glm::dot(side, direction);
    inside[0] = inside[0] && height > -ViewMargin;
    inside[1] = inside[1] && -height > -ViewMargin;
  }
  return inside[0] || inside[1];
}
}

//------------------------------------------------------------------------------
EpipolarSlices::EpipolarSlices(
  const ShadowMapProjection& projection, const CameraUniforms& view, int columns, int mostRows)
{
  if (!projection.HasCasters())
  {
    return;
  }
  this->Columns = std::min((columns + Word - 1) / Word * Word, MostColumns);
  // Two pixels apart at the picture's border, if the light is in its middle.
  const int perColumn = static_cast<int>(RowsPerColumn * columns);
  this->Rows =
    std::min(std::max({ LeastRows, view.GetWidth() + view.GetHeight(), perColumn }), mostRows);
  this->SetValue(projection, view);
  if (!projection.IsParallel())
  {
    this->SetAround(projection, view);
  }
  else if (view.IsParallel())
  {
    this->SetParallel(projection, view);
  }
  else
  {
    this->SetFan(projection, view);
  }
}

//------------------------------------------------------------------------------
// The axes across the last one, the first of them towards a direction.
void EpipolarSlices::TurnTo(const glm::dvec3& direction)
{
  const glm::dvec3& pole = this->Axes[2];
  const glm::dvec3 across = direction - pole * glm::dot(pole, direction);
  const double length = glm::length(across);
  if (length > 0.0)
  {
    this->Axes[0] = across / length;
    this->Axes[1] = glm::cross(pole, this->Axes[0]);
  }
}

//------------------------------------------------------------------------------
// A light at a place: angles around the way to the eye, and from it.
void EpipolarSlices::SetAround(const ShadowMapProjection& projection, const CameraUniforms& view)
{
  const glm::dvec3 toEye = view.GetEye() - projection.GetAnchor();
  const double distance = glm::length(toEye);
  const glm::dvec3 along = GetMiddle(view);
  if (!view.IsParallel() && distance <= OnPole * projection.GetExtent())
  {
    this->Rows = 0;
    return;
  }
  this->Axes[2] = view.IsParallel() ? -along : toEye / distance;
  const glm::dvec3 least =
    glm::abs(this->Axes[2].x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  this->TurnTo(least);
  Range columns{ 0.0, Pi };
  const ShadowMapProjection::Cover cover = projection.GetCover();
  const double fromPole = GetAngle(this->Axes[2], cover.Axis);
  columns.First = std::max(columns.First, fromPole - cover.Angle);
  columns.Last = std::min(columns.Last, fromPole + cover.Angle);
  Arc arc{ HalfCircle, this->Axes[0] };
  if (fromPole > cover.Angle && fromPole + cover.Angle < Pi)
  {
    arc = { std::asin(std::min(std::sin(cover.Angle) / std::sin(fromPole), 1.0)), cover.Axis };
  }
  if (!view.IsParallel())
  {
    columns.Last = std::min(columns.Last, this->LimitToView(view, arc));
  }
  this->TurnTo(arc.Middle);
  this->SetRanges({ -arc.Width, arc.Width }, columns);
}

//------------------------------------------------------------------------------
// Narrows the rows to a perspective view that does not look along the last axis. Returns the
// largest angle of its rays from there.
double EpipolarSlices::LimitToView(const CameraUniforms& view, Arc& arc)
{
  if (IsInView(view, this->Axes[2]))
  {
    return Pi;
  }
  const glm::dmat3 axes = this->Axes;
  const glm::dvec3 middle = GetMiddle(view);
  this->TurnTo(middle);
  double widest = 0.0;
  double farthest = 0.0;
  for (const glm::dvec3& ray : GetBorder(view))
  {
    const double angle = std::atan2(glm::dot(ray, this->Axes[1]), glm::dot(ray, this->Axes[0]));
    widest = std::max(widest, std::abs(angle));
    farthest = std::max(farthest, GetAngle(this->Axes[2], ray));
  }
  this->Axes = axes;
  widest += ViewMargin;
  if (widest < arc.Width)
  {
    arc = { widest, middle };
  }
  return farthest + ViewMargin;
}

//------------------------------------------------------------------------------
// A directional light and a perspective view: angles around the eye, and distances from it.
void EpipolarSlices::SetFan(const ShadowMapProjection& projection, const CameraUniforms& view)
{
  this->Axes[2] = projection.GetFrame(0)[2];
  const glm::dvec3 toMap = projection.GetAnchor() - view.GetEye();
  this->TurnTo(projection.GetFrame(0)[0]);
  const glm::dvec2 place(glm::dot(toMap, this->Axes[0]), glm::dot(toMap, this->Axes[1]));
  const double radius = glm::length(1.0 / projection.GetScale());
  const double away = glm::length(place);
  Arc arc{ HalfCircle, this->Axes[0] };
  if (away > radius)
  {
    arc = { std::asin(radius / away), toMap };
  }
  this->LimitToView(view, arc);
  this->TurnTo(arc.Middle);
  this->SetRanges({ -arc.Width, arc.Width }, { std::max(away - radius, 0.0), away + radius });
}

//------------------------------------------------------------------------------
// A directional light and a parallel view: lengths across the light.
void EpipolarSlices::SetParallel(const ShadowMapProjection& projection, const CameraUniforms& view)
{
  this->Fan = false;
  this->Axes[2] = projection.GetFrame(0)[2];
  const glm::dvec3 along = GetMiddle(view);
  const glm::dvec3 across = along - this->Axes[2] * glm::dot(along, this->Axes[2]);
  if (glm::length(across) <= OnPole)
  {
    this->Rows = 0;
    return;
  }
  this->TurnTo(along);
  const glm::dvec3 toMap = projection.GetAnchor() - view.GetEye();
  Range rows{ 1e300, -1e300 };
  Range columns = rows;
  const glm::dvec2 half = 1.0 / projection.GetScale();
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::dvec3 point = toMap + (corner & 1 ? half.x : -half.x) * projection.GetFrame(0)[0] +
      (corner & 2 ? half.y : -half.y) * projection.GetFrame(0)[1];
    const double column = glm::dot(point, this->Axes[0]);
    const double row = glm::dot(point, this->Axes[1]);
    columns = { std::min(columns.First, column), std::max(columns.Last, column) };
    rows = { std::min(rows.First, row), std::max(rows.Last, row) };
  }
  Range seen{ 1e300, -1e300 };
  for (const CameraRays::Ray& ray : view.GetCornerRays())
  {
    const double row = glm::dot(ray.Origin, this->Axes[1]);
    seen = { std::min(seen.First, row), std::max(seen.Last, row) };
  }
  rows = { std::max(rows.First, seen.First), std::min(rows.Last, seen.Last) };
  if (rows.First >= rows.Last)
  {
    rows = seen;
  }
  this->SetRanges(rows, columns);
}

//------------------------------------------------------------------------------
// With a column more at each end, in which there is nothing.
void EpipolarSlices::SetRanges(Range rows, Range columns)
{
  const double least = LeastRange * std::max(std::abs(columns.First), std::abs(columns.Last));
  const double column = std::max(columns.Last - columns.First, least) / (this->Columns - 3);
  this->RowRange = rows;
  this->ColumnRange = { columns.First - 1.5 * column, columns.Last + 1.5 * column };
}

//------------------------------------------------------------------------------
// All that the map holds gets numbers above 1: the reciprocal of a distance from 1 on, the distance
// below 0 from 1 to 2. A slope's bias may move it beyond that, where it does not matter.
void EpipolarSlices::SetValue(const ShadowMapProjection& projection, const CameraUniforms& view)
{
  const double reach = projection.GetReach() + 2.0 * projection.GetSlack(view);
  const bool parallel = projection.IsParallel();
  this->Value = parallel ? glm::dvec2(0.499 / reach, 1.5) : glm::dvec2(1.2 * reach, 0.0);
  this->Shift = parallel ? ParallelShift : PointShift;
}

//------------------------------------------------------------------------------
void EpipolarSlices::SetUniforms(vtkShaderProgram* program) const
{
  const glm::mat3 axes(this->Axes);
  const auto set = [program](const char* name, const Range& range, int count) {
    const glm::vec2 value(range.First, count / std::max(range.Last - range.First, 1e-30));
    program->SetUniform2f(name, &value.x);
  };
  const glm::ivec2 size(this->Columns, this->Rows);
  program->SetUniform3fv("sliceAxes", 3, &axes[0].x);
  set("sliceRow", this->RowRange, this->Rows);
  set("sliceColumn", this->ColumnRange, this->Columns);
  program->SetUniform2i("sliceSize", &size.x);
  const glm::vec2 numbers(this->Value);
  program->SetUniform2f("sliceValue", &numbers.x);
  program->SetUniformi("sliceShift", this->Shift);
  program->SetUniformi("sliceFan", this->Fan ? 1 : 0);
}
}
