// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of OpenVDB, damaged anywhere: an image without a number that is not finite, or an error and
// no image.

#include "AirlightFuzz.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenVDBDensityReader.h"
#include "vtkPointData.h"

using namespace airlight_fuzz;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  vtkNew<vtkOpenVDBDensityReader> reader;
  reader->SetFileName(WriteInput(data, size, ".vdb").c_str());
  reader->SetMaximumDimension(16);
  reader->Update();
  for (int i = -1; i <= reader->GetNumberOfGrids(); ++i)
  {
    Require(reader->GetGridName(i) && reader->GetGridType(i), "names are never null");
  }
  vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetTuple1(i);
    RequireFinite(&value, 1, "a density");
  }
  RequireFinite(reader->GetOutput()->GetSpacing(), 3, "the spacing");
  RequireFinite(reader->GetOutput()->GetOrigin(), 3, "the origin");
  return 0;
}
