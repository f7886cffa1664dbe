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

#include <string>

namespace airlight_test
{
// Writes all files into a folder of the test's own; its name, with a slash.
std::string WriteFiles(const std::string& test, int argc, char* argv[]);

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

bool HasSize(vtkImageData* image, int x, int y, int z);

inline bool IsNear(double value, double expected, double tolerance)
{
  return std::abs(value - expected) <= tolerance; // false for NaN
}

double GetSum(vtkImageData* image);

// The value at a place that has to be that of a point; NaN where it is not.
double GetValueAt(vtkImageData* image, const double world[3]);
}

#endif
