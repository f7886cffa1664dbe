// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestReader.h"

#include <memory>

namespace airlight_test
{
//------------------------------------------------------------------------------
std::string WriteFiles(const std::string& test, int argc, char* argv[])
{
  const std::unique_ptr<char[]> temporary(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary"));
  const std::string folder = std::string(temporary.get()) + "/" + test + "/";
  vtksys::SystemTools::MakeDirectory(folder);
  WriteOpenVDBFiles(folder);
  return folder;
}

//------------------------------------------------------------------------------
bool HasSize(vtkImageData* image, int x, int y, int z)
{
  const int* size = image->GetDimensions();
  return size[0] == x && size[1] == y && size[2] == z;
}

//------------------------------------------------------------------------------
double GetSum(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    sum += values->GetComponent(i, 0);
  }
  return sum;
}

//------------------------------------------------------------------------------
double GetValueAt(vtkImageData* image, const double world[3])
{
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(world, index);
  int point[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = static_cast<int>(std::lround(index[axis]));
    if (std::abs(index[axis] - point[axis]) > 1e-6 || point[axis] < 0 ||
      point[axis] >= image->GetDimensions()[axis])
    {
      return std::nan("");
    }
  }
  return image->GetScalarComponentAsDouble(point[0], point[1], point[2], 0);
}
}
