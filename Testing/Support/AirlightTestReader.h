// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A reader of OpenVDB's files with listeners, for its tests.
 */

#ifndef AirlightTestReader_h
#define AirlightTestReader_h

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestOpenVDB.h"
#include "AirlightTestTools.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenVDBDensityReader.h"
#include "vtkPointData.h"
#include "vtkTestUtilities.h"

#include <vtksys/SystemTools.hxx>

#include <memory>
#include <string>

namespace airlight_test
{
// Writes all files into a folder of the test's own; its name, with a slash.
inline std::string WriteFiles(const std::string& test, int argc, char* argv[])
{
  const std::unique_ptr<char[]> temporary(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary"));
  const std::string folder = std::string(temporary.get()) + "/" + test + "/";
  vtksys::SystemTools::MakeDirectory(folder);
  WriteOpenVDBFiles(folder);
  return folder;
}

class Reader
{
public:
  explicit Reader(const std::string& fileName, const char* grid = nullptr)
    : Errors(this->Object)
    , Warnings(this->Object, vtkCommand::WarningEvent)
  {
    this->Object->SetFileName(fileName.c_str());
    this->Object->SetGridName(grid);
  }

  vtkOpenVDBDensityReader* operator->() const { return this->Object; }

  // The image, after an update that must not report an error.
  vtkImageData* Read(int warnings = 0)
  {
    this->Object->Update();
    const std::string name = this->Object->GetFileName();
    Check(this->Errors.Take() == 0, name + " is read without error: " + this->Errors.GetText());
    Check(this->Warnings.Take() == warnings,
      name + ": number of warnings, the last: " + this->Warnings.GetText());
    return this->Object->GetOutput();
  }

  vtkNew<vtkOpenVDBDensityReader> Object;
  ErrorListener Errors;
  ErrorListener Warnings;
};

inline bool HasSize(vtkImageData* image, int x, int y, int z)
{
  const int* size = image->GetDimensions();
  return size[0] == x && size[1] == y && size[2] == z;
}

inline double GetSum(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    sum += values->GetComponent(i, 0);
  }
  return sum;
}

// The value at a place that has to be that of a point; NaN where it is not.
inline double GetValueAt(vtkImageData* image, const double world[3])
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

#endif
