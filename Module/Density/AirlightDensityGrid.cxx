// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Density/AirlightDensityGrid.h"

#include "Integration/AirlightMath.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

// The shaders' mathematics in double precision, with samples in memory, x fastest.
#define AIRLIGHT_FN inline
#define AIRLIGHT_IN(T) const T&
#define AIRLIGHT_INOUT(T) T&
#define AIRLIGHT_SAMPLES const DensityGrid*
#define AIRLIGHT_LAYER FetchLayer
#define AIRLIGHT_IS_EMPTY_BLOCK IsEmptyBlock
#define AIRLIGHT_DOUBLE

namespace airlight
{
namespace f64
{
namespace
{
using int3 = glm::ivec3;
using real3x3 = glm::dmat3;

// The four samples of a cell, of which there is one less along each axis, in one layer.
inline real4 FetchLayer(const DensityGrid* grid, const int3& cells, const int3& cell)
{
  const size_t rowLength = cells.x + 1;
  return grid->GetSamples().GetSquare(
    cell.x + rowLength * (cell.y + (cells.y + size_t(1)) * cell.z), rowLength);
}

inline bool IsEmptyBlock(const DensityGrid* grid, int block)
{
  return grid->GetBlocks().GetFilled()[block] == 0;
}

#include "Medium/AirlightGrid.glsl"

static_assert(FilledBlocks::Cells == 1 << AIRLIGHT_BLOCK_SHIFT, "one size of blocks");
}
}

namespace
{
// Where the first sample is the origin: far away from that of the world, it keeps more digits.
f64::AirlightGrid MakeGrid(const DensityGrid& grid)
{
  return { grid.GetAxes(), glm::dvec3(0.0), grid.GetLast(), &grid };
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const DensityGrid> DensityGrid::Build(vtkImageData* image, std::string& error)
{
  const std::shared_ptr<DensityGrid> grid(new DensityGrid);
  if (!grid->ReadGeometry(image, error) || !grid->ReadSamples(image, error))
  {
    return nullptr;
  }
  grid->Crop();
  grid->Blocks = FilledBlocks(grid->Samples, grid->Size);
  return grid;
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
  return this->Samples.Read(scalars, error);
}

//------------------------------------------------------------------------------
// A cell has a density where one of its corners has. Of an image without any, one cell stays.
void DensityGrid::Crop()
{
  glm::ivec3 low = this->Size;
  glm::ivec3 high(-1);
  size_t row = 0;
  for (int k = 0; k < this->Size.z; ++k)
  {
    for (int j = 0; j < this->Size.y; ++j)
    {
      const auto [first, last] = this->Samples.FindAboveZero(row, row + this->Size.x);
      if (first <= last)
      {
        low = glm::min(low, glm::ivec3(static_cast<int>(first - row), j, k));
        high = glm::max(high, glm::ivec3(static_cast<int>(last - row), j, k));
      }
      row += this->Size.x;
    }
  }
  const bool isEmpty = high.x < 0;
  low = isEmpty ? glm::ivec3(0) : glm::max(low - 1, 0);
  high = isEmpty ? glm::ivec3(1) : glm::min(high + 1, this->Size - 1);
  const glm::ivec3 count = high - low + 1;
  if (count != this->Size)
  {
    this->Samples.Crop(low, count, this->Size);
    this->First = this->ToWorld(glm::dvec3(low));
    this->FirstPoint = low;
    this->Size = count;
  }
}

//------------------------------------------------------------------------------
double DensityGrid::GetDensity(const glm::dvec3& point) const
{
  return f64::airlightGridDensity(MakeGrid(*this), point - this->First);
}

//------------------------------------------------------------------------------
double DensityGrid::GetDensityAt(const glm::dvec3& samples) const
{
  const glm::dvec3 last = this->GetLast();
  const glm::dvec3 p = glm::clamp(samples, glm::dvec3(0.0), last);
  // Rounding must not make a density of zeros negative, here and below.
  return std::max(f64::airlightInterpolated(this, last, p), 0.0);
}

//------------------------------------------------------------------------------
glm::dvec2 DensityGrid::GetRange(
  const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const
{
  return f64::airlightGridRange(MakeGrid(*this), origin - this->First, direction, from, to);
}

//------------------------------------------------------------------------------
double DensityGrid::Integrate(
  const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const
{
  return std::max(
    f64::airlightGridDepth(MakeGrid(*this), origin - this->First, direction, from, to), 0.0);
}

//------------------------------------------------------------------------------
void DensityGrid::AddCuts(const glm::dvec3& origin, const glm::dvec3& direction, double from,
  double to, std::vector<double>& cuts) const
{
  f64::AirlightWalk walk =
    f64::airlightWalk(MakeGrid(*this), origin - this->First, direction, from, to);
  if (walk.t < walk.end)
  {
    cuts.push_back(walk.t);
  }
  while (walk.t < walk.end)
  {
    const double end = f64::airlightCellEnd(walk);
    if (end > walk.t)
    {
      cuts.push_back(end);
    }
    f64::airlightEnterNext(walk, end);
  }
}
}
