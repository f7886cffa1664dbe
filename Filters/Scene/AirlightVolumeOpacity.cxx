// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightVolumeOpacity.h"

#include "Integration/AirlightMatrix.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr int TableSize = 65536;
constexpr double OpaqueDepth = 12.0;

glm::dmat4 GetPointsToData(vtkImageData* image)
{
  const int* extent = image->GetExtent();
  const double* origin = image->GetOrigin();
  glm::dmat4 result(1.0);
  for (int row = 0; row < 3; ++row)
  {
    result[3][row] = origin[row];
    for (int axis = 0; axis < 3; ++axis)
    {
      result[axis][row] =
        image->GetDirectionMatrix()->GetElement(row, axis) * image->GetSpacing()[axis];
      result[3][row] += result[axis][row] * extent[2 * axis];
    }
  }
  return result;
}

std::vector<glm::dvec3> GetColours(vtkVolumeProperty* property, double range[2])
{
  std::vector<glm::dvec3> colours(TableSize);
  if (property->GetColorChannels() == 3)
  {
    property->GetRGBTransferFunction()->GetTable(range[0], range[1], TableSize, &colours[0].x);
  }
  else
  {
    std::vector<double> greys(TableSize);
    property->GetGrayTransferFunction()->GetTable(range[0], range[1], TableSize, greys.data());
    std::transform(
      greys.begin(), greys.end(), colours.begin(), [](double grey) { return glm::dvec3(grey); });
  }
  for (glm::dvec3& colour : colours)
  {
    colour = glm::clamp(colour, 0.0, 1.0);
  }
  return colours;
}
}

//------------------------------------------------------------------------------
VolumeOpacity::VolumeOpacity(
  vtkVolume* volume, const VolumeScalars& scalars, vtkMatrix4x4* toWorld, bool colours)
  : Values(scalars.Values)
  , Table(TableSize)
{
  scalars.Image->GetDimensions(&this->Size.x);
  const glm::dmat4 matrix = ToGlm(toWorld);
  this->ToWorld = matrix * GetPointsToData(scalars.Image);
  vtkVolumeProperty* property = volume->GetProperty();
  const double unit = property->GetScalarOpacityUnitDistance() *
    std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix))));
  const double step = std::min({ glm::length(this->ToWorld[0]), glm::length(this->ToWorld[1]),
    glm::length(this->ToWorld[2]) });
  double range[2];
  this->Values->GetRange(range, 0);
  this->Lowest = range[0];
  this->PerScalar = range[1] > range[0] ? (TableSize - 1) / (range[1] - range[0]) : 0.0;
  property->GetScalarOpacity()->GetTable(range[0], range[1], TableSize, this->Table.data());
  if (colours)
  {
    this->Colours = GetColours(property, range);
  }
  for (double& entry : this->Table)
  {
    entry = std::min(
      -std::log1p(-std::clamp(entry, 0.0, 1.0)) / unit, OpaqueDepth / std::min(step, unit));
  }
}

//------------------------------------------------------------------------------
// The place of a scalar in the tables, interpolated at a place.
double VolumeOpacity::GetEntry(const glm::dvec3& place) const
{
  const glm::dvec3 p = glm::clamp(place, glm::dvec3(0.0), glm::dvec3(this->Size - 1));
  const glm::ivec3 cell = glm::min(glm::ivec3(p), this->Size - 2);
  const glm::dvec3 f = p - glm::dvec3(cell);
  const auto row = [&](int y, int z) {
    const vtkIdType first = cell.x +
      static_cast<vtkIdType>(this->Size.x) *
        (cell.y + y + static_cast<vtkIdType>(this->Size.y) * (cell.z + z));
    return glm::mix(
      this->Values->GetComponent(first, 0), this->Values->GetComponent(first + 1, 0), f.x);
  };
  const double scalar =
    glm::mix(glm::mix(row(0, 0), row(1, 0), f.y), glm::mix(row(0, 1), row(1, 1), f.y), f.z);
  return std::clamp((scalar - this->Lowest) * this->PerScalar, 0.0, TableSize - 1.0);
}
}
