// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Density/AirlightImageColours.h"

#include "Density/AirlightDensityGrid.h"
#include "Density/AirlightTrilinear.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <sstream>

namespace airlight
{
namespace
{
// Quotients in single precision may be above 1.
constexpr double Rounding = 1.0 + 1e-6;

// Empty, or why the array cannot be the colours.
std::string FindProblem(vtkImageData* image, vtkDataArray* array, const std::string& name)
{
  std::ostringstream text;
  if (!array)
  {
    text << "has no point array '" << name << "'";
    return text.str();
  }
  const int components = array->GetNumberOfComponents();
  if ((components != 1 && components != 3) ||
    array->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    text << "has a point array '" << name << "' of " << array->GetNumberOfTuples() << " tuples of "
         << components << " components: one or three are needed for each of its "
         << image->GetNumberOfPoints() << " points";
  }
  return text.str();
}

// One component is that of all channels.
template <typename Tuple>
glm::dvec3 GetColour(const Tuple& tuple)
{
  const int step = tuple.size() == 3 ? 1 : 0;
  return { static_cast<double>(tuple[0]), static_cast<double>(tuple[step]),
    static_cast<double>(tuple[2 * step]) };
}

// The first one that is not from 0 to `most`, or the number of all.
vtkIdType FindBadColour(vtkDataArray* array, double most)
{
  vtkIdType point = 0;
  for (const auto tuple : vtk::DataArrayTupleRange(array))
  {
    const glm::dvec3 colour = GetColour(tuple);
    // Written so that NaN is bad.
    if (!(glm::all(glm::greaterThanEqual(colour, glm::dvec3(0.0))) &&
          glm::all(glm::lessThanEqual(colour, glm::dvec3(most)))))
    {
      break;
    }
    ++point;
  }
  return point;
}

// The image's points at which the grid has samples, x fastest.
template <typename Visit>
void VisitPoints(vtkImageData* image, const DensityGrid& grid, const Visit& visit)
{
  const glm::ivec3 low = grid.GetFirstPoint();
  const glm::ivec3 end = low + grid.GetSize();
  const int* extent = image->GetExtent();
  for (int k = low.z; k < end.z; ++k)
  {
    for (int j = low.y; j < end.y; ++j)
    {
      int ijk[3] = { extent[0] + low.x, extent[2] + j, extent[4] + k };
      const vtkIdType first = image->ComputePointId(ijk);
      for (int i = 0; i < end.x - low.x; ++i)
      {
        visit(first + i);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const ImageColours> ImageColours::Build(vtkImageData* image,
  const DensityGrid& grid, const std::string& name, double most, std::string& error)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  error = FindProblem(image, array, name);
  if (!error.empty())
  {
    return nullptr;
  }
  // As in VTK's own arrays of colours.
  const double one = array->GetDataType() == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  const vtkIdType bad = FindBadColour(array, most * one * Rounding);
  if (bad < array->GetNumberOfTuples())
  {
    const glm::dvec3 colour = GetColour(vtk::DataArrayTupleRange(array)[bad]);
    std::ostringstream text;
    text << "has the colour (" << colour.x << ", " << colour.y << ", " << colour.z << ") at point "
         << bad << " of its array '" << name << "': its values must be from 0 to " << most * one;
    error = text.str();
    return nullptr;
  }
  const std::shared_ptr<ImageColours> colours(new ImageColours);
  colours->Size = grid.GetSize();
  const auto tuples = vtk::DataArrayTupleRange(array);
  colours->Texels.reserve(static_cast<size_t>(colours->Size.x) * colours->Size.y * colours->Size.z);
  VisitPoints(image, grid, [&](vtkIdType point) {
    const glm::dvec3 colour = GetColour(tuples[point]) / one;
    colours->Texels.emplace_back(glm::vec3(glm::min(colour, most)), 0.0f);
  });
  return colours;
}

//------------------------------------------------------------------------------
glm::dvec3 ImageColours::GetAt(const glm::dvec3& samples) const
{
  const glm::dvec3 place = glm::clamp(samples, glm::dvec3(0.0), glm::dvec3(this->Size - 1));
  return glm::dvec3(InterpolateTrilinearly<glm::dvec4>(this->Texels, this->Size, place));
}
}
