// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferencePicture.h"

#include "Reference/AirlightReferenceTracer.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
static double* AddArray(vtkImageData* image, const char* name, int components)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  array->Fill(0.0);
  image->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}

//------------------------------------------------------------------------------
ReferencePicture::ReferencePicture(vtkImageData* image)
  : Width(image->GetDimensions()[0])
  , Radiance(AddArray(image, "Radiance", 3))
  , Airlight(AddArray(image, "Airlight", 3))
  , Surface(AddArray(image, "Surface", 3))
  , Transmittance(AddArray(image, "Transmittance", 3))
  , Depth(AddArray(image, "Depth", 1))
  , LitLength(AddArray(image, "LitLength", 1))
{
  image->GetPointData()->SetActiveScalars("Radiance");
}

//------------------------------------------------------------------------------
void ReferencePicture::Set(vtkIdType index, const ReferencePixel& pixel) const
{
  std::copy_n(&pixel.Radiance.x, 3, this->Radiance + 3 * index);
  std::copy_n(&pixel.Airlight.x, 3, this->Airlight + 3 * index);
  std::copy_n(&pixel.Surface.x, 3, this->Surface + 3 * index);
  std::copy_n(&pixel.Transmittance.x, 3, this->Transmittance + 3 * index);
  this->Depth[index] = pixel.Depth;
  this->LitLength[index] = pixel.LitLength;
}

//------------------------------------------------------------------------------
void ReferencePicture::Trace(const ReferenceTracer& tracer, int row, int rows)
{
  const vtkIdType width = this->Width;
  vtkSMPTools::For(row * width, (row + rows) * width, 16, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      const auto column = static_cast<double>(i % width);
      this->Set(i, tracer.Trace(column + 0.5, static_cast<double>(i / width) + 0.5));
    }
  });
}
}
