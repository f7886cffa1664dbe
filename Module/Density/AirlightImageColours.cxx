// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Density/AirlightImageColours.h"

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
}

//------------------------------------------------------------------------------
std::shared_ptr<const ImageColours> ImageColours::Build(
  vtkImageData* image, const std::string& name, double most, std::string& error)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  error = FindProblem(image, array, name);
  if (!error.empty())
  {
    return nullptr;
  }
  const std::shared_ptr<ImageColours> colours(new ImageColours);
  image->GetDimensions(&colours->Size.x);
  const auto tuples = vtk::DataArrayTupleRange(array);
  colours->Texels.reserve(tuples.size());
  // As in VTK's own arrays of colours.
  const double one = array->GetDataType() == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  const int step = array->GetNumberOfComponents() == 3 ? 1 : 0;
  for (const auto tuple : tuples)
  {
    const glm::dvec3 colour(static_cast<double>(tuple[0]), static_cast<double>(tuple[step]),
      static_cast<double>(tuple[2 * step]));
    // Written so that NaN is refused.
    if (!(glm::all(glm::greaterThanEqual(colour, glm::dvec3(0.0))) &&
          glm::all(glm::lessThanEqual(colour / one, glm::dvec3(most * Rounding)))))
    {
      std::ostringstream text;
      text << "has the colour (" << colour.x << ", " << colour.y << ", " << colour.z
           << ") at point " << colours->Texels.size() << " of its array '" << name
           << "': its values must be from 0 to " << most * one;
      error = text.str();
      return nullptr;
    }
    colours->Texels.emplace_back(glm::vec3(glm::min(colour / one, most)), 0.0f);
  }
  return colours;
}

//------------------------------------------------------------------------------
glm::dvec3 ImageColours::GetAt(const glm::dvec3& samples) const
{
  const glm::dvec3 place = glm::clamp(samples, glm::dvec3(0.0), glm::dvec3(this->Size - 1));
  return glm::dvec3(InterpolateTrilinearly<glm::dvec4>(this->Texels, this->Size, place));
}
}
