// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Density/AirlightDensityGrid.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace airlight
{
namespace
{
// Gauss and Legendre's two nodes.
const double Node = 1.0 / std::sqrt(3.0);

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const DensityGrid> DensityGrid::Build(vtkImageData* image, std::string& error)
{
  const std::shared_ptr<DensityGrid> grid(new DensityGrid);
  return grid->ReadGeometry(image, error) && grid->ReadSamples(image, error) ? grid : nullptr;
}

//------------------------------------------------------------------------------
bool DensityGrid::ReadGeometry(vtkImageData* image, std::string& error)
{
  image->GetDimensions(&this->Size.x);
  if (glm::any(glm::lessThan(this->Size, glm::ivec3(2))))
  {
    std::ostringstream text;
    text << "has " << this->Size.x << " x " << this->Size.y << " x " << this->Size.z
         << " points and needs at least 2 along each axis: give it an extent, or make a flat image "
            "thicker";
    error = text.str();
    return false;
  }
  // Place of a sample: image's origin + direction matrix * (spacing * (extent's start + index)).
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const int* extent = image->GetExtent();
  glm::dmat3 steps;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int row = 0; row < 3; ++row)
    {
      steps[axis][row] = image->GetDirectionMatrix()->GetElement(row, axis) * spacing[axis];
    }
  }
  this->First = glm::dvec3(origin[0], origin[1], origin[2]) +
    steps * glm::dvec3(extent[0], extent[2], extent[4]);
  this->Axes = glm::inverse(steps);
  const bool finite = IsFinite(this->First) && IsFinite(this->Axes[0]) && IsFinite(this->Axes[1]) &&
    IsFinite(this->Axes[2]);
  if (!finite || glm::determinant(steps) == 0.0)
  {
    std::ostringstream text;
    text << "has the origin (" << origin[0] << ", " << origin[1] << ", " << origin[2]
         << ") and the spacing (" << spacing[0] << ", " << spacing[1] << ", " << spacing[2]
         << "): they must be finite, the spacing not 0, and the direction matrix invertible";
    error = text.str();
    return false;
  }
  this->Least = this->First;
  this->Greatest = this->First;
  for (int corner = 1; corner < 8; ++corner)
  {
    const glm::dvec3 far(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 position = this->First + steps * (far * glm::dvec3(this->Size - 1));
    this->Least = glm::min(this->Least, position);
    this->Greatest = glm::max(this->Greatest, position);
  }
  return true;
}

//------------------------------------------------------------------------------
bool DensityGrid::ReadSamples(vtkImageData* image, std::string& error)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  std::ostringstream text;
  if (!scalars)
  {
    error = "has no point scalars: set the array of densities active with "
            "GetPointData()->SetActiveScalars()";
    return false;
  }
  const vtkIdType count = scalars->GetNumberOfTuples();
  const char* name = scalars->GetName() ? scalars->GetName() : "without name";
  if (scalars->GetNumberOfComponents() != 1 || count != image->GetNumberOfPoints())
  {
    text << "has scalars '" << name << "' of " << count << " values with "
         << scalars->GetNumberOfComponents() << " components: one number for each of its "
         << image->GetNumberOfPoints() << " points is needed";
    error = text.str();
    return false;
  }
  this->Samples.resize(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = scalars->GetComponent(i, 0);
    if (!(value >= 0.0 && value <= 1e100))
    {
      text << "has the value " << value << " at point " << i << " of its scalars '" << name
           << "': densities must be finite, at least 0 and at most 1e100";
      error = text.str();
      return false;
    }
    this->Samples[i] = value;
  }
  return true;
}

//------------------------------------------------------------------------------
double DensityGrid::Interpolate(const glm::ivec3& cell, const glm::dvec3& position) const
{
  const glm::dvec3 f = position - glm::dvec3(cell);
  const size_t rowLength = this->Size.x;
  const size_t sliceLength = rowLength * this->Size.y;
  const double* s = &this->Samples[cell.x + rowLength * cell.y + sliceLength * cell.z];
  const auto along = [&](const double* row) { return row[0] + f.x * (row[1] - row[0]); };
  const auto across = [&](const double* slice) {
    const double low = along(slice);
    return low + f.y * (along(slice + rowLength) - low);
  };
  const double low = across(s);
  // Rounding must not make a density of zeros negative.
  return std::max(low + f.z * (across(s + sliceLength) - low), 0.0);
}

//------------------------------------------------------------------------------
double DensityGrid::GetDensity(const glm::dvec3& point) const
{
  const glm::dvec3 p = this->ToSamples(point);
  const glm::dvec3 last = this->GetLast();
  // Written so that NaN is outside.
  if (!(glm::all(glm::greaterThanEqual(p, glm::dvec3(0.0))) &&
        glm::all(glm::lessThanEqual(p, last))))
  {
    return 0.0;
  }
  return this->Interpolate(glm::min(glm::ivec3(p), this->Size - 2), p);
}

//------------------------------------------------------------------------------
double DensityGrid::GetDensityAt(const glm::dvec3& samples) const
{
  const glm::dvec3 p = glm::clamp(samples, glm::dvec3(0.0), this->GetLast());
  return this->Interpolate(glm::min(glm::ivec3(p), this->Size - 2), p);
}

//------------------------------------------------------------------------------
glm::dvec2 DensityGrid::GetRange(
  const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const
{
  Line line;
  return this->Clip(origin, direction, from, to, line) ? glm::dvec2(line.From, line.To)
                                                       : glm::dvec2(from, from);
}

//------------------------------------------------------------------------------
bool DensityGrid::Clip(
  const glm::dvec3& origin, const glm::dvec3& direction, double from, double to, Line& line) const
{
  line = { this->ToSamples(origin), this->Axes * direction, from, to };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double p = line.Point[axis];
    const double slope = line.Slope[axis];
    const double last = this->Size[axis] - 1;
    if (slope == 0.0)
    {
      if (!(p >= 0.0 && p <= last))
      {
        return false;
      }
      continue;
    }
    line.From = std::max(line.From, (slope > 0.0 ? -p : last - p) / slope);
    line.To = std::min(line.To, (slope > 0.0 ? last - p : -p) / slope);
  }
  return line.From < line.To;
}

//------------------------------------------------------------------------------
template <typename Visit>
void DensityGrid::Walk(const Line& line, const Visit& visit) const
{
  glm::ivec3 cell;
  glm::dvec3 next; // where the line leaves the cell, for each axis
  const auto leave = [&](int axis) {
    const double slope = line.Slope[axis];
    return slope == 0.0 ? std::numeric_limits<double>::infinity()
                        : (cell[axis] + (slope > 0.0 ? 1.0 : 0.0) - line.Point[axis]) / slope;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double p = line.Point[axis] + line.From * line.Slope[axis];
    const double below = line.Slope[axis] < 0.0 ? std::ceil(p) - 1.0 : std::floor(p);
    cell[axis] = static_cast<int>(std::clamp(below, 0.0, this->Size[axis] - 2.0));
    next[axis] = leave(axis);
  }
  double t = line.From;
  while (t < line.To)
  {
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    const double end = std::min(next[axis], line.To);
    if (end > t)
    {
      visit(t, end, cell);
      t = end;
    }
    cell[axis] += line.Slope[axis] > 0.0 ? 1 : -1;
    if (cell[axis] < 0 || cell[axis] > this->Size[axis] - 2)
    {
      // Rounding may leave a rest in the last cell.
      cell[axis] = std::clamp(cell[axis], 0, this->Size[axis] - 2);
      next[axis] = std::numeric_limits<double>::infinity();
      continue;
    }
    next[axis] = leave(axis);
  }
}

//------------------------------------------------------------------------------
double DensityGrid::Integrate(
  const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const
{
  Line line;
  double sum = 0.0;
  if (this->Clip(origin, direction, from, to, line))
  {
    this->Walk(line, [&](double t0, double t1, const glm::ivec3& cell) {
      const double middle = 0.5 * (t0 + t1);
      const double reach = 0.5 * (t1 - t0);
      const glm::dvec3 position = line.Point + middle * line.Slope;
      const glm::dvec3 step = Node * reach * line.Slope;
      sum += reach *
        (this->Interpolate(cell, position - step) + this->Interpolate(cell, position + step));
    });
  }
  return sum;
}

//------------------------------------------------------------------------------
void DensityGrid::AddCuts(const glm::dvec3& origin, const glm::dvec3& direction, double from,
  double to, std::vector<double>& cuts) const
{
  Line line;
  if (this->Clip(origin, direction, from, to, line))
  {
    cuts.push_back(line.From);
    this->Walk(line, [&](double, double t1, const glm::ivec3&) { cuts.push_back(t1); });
  }
}
}
