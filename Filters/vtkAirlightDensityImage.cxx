// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightDensityImage.h"

#include "DataSets/AirlightResample.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace airlight;

namespace
{
constexpr int DefaultDimension = 64;
constexpr int LargestDimension = 4096;
}

vtkStandardNewMacro(vtkAirlightDensityImage);

//------------------------------------------------------------------------------
void vtkAirlightDensityImage::SetFactor(double factor)
{
  if (!(factor > 0.0 && std::isfinite(factor)))
  {
    vtkErrorMacro(<< "Factor " << factor << " must be finite and above 0; it stays " << this->Factor
                  << ".");
    return;
  }
  if (this->Factor != factor)
  {
    this->Factor = factor;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightDensityImage::SetDimensions(int x, int y, int z)
{
  const int dimensions[3] = { x, y, z };
  this->SetDimensions(dimensions);
}

void vtkAirlightDensityImage::SetDimensions(const int dimensions[3])
{
  const int* end = dimensions + 3;
  const bool none = std::all_of(dimensions, end, [](int n) { return n == 0; });
  if (!none && !std::all_of(dimensions, end, [](int n) { return n >= 2 && n <= LargestDimension; }))
  {
    vtkErrorMacro(<< "Dimensions (" << dimensions[0] << ", " << dimensions[1] << ", "
                  << dimensions[2] << ") must all be from 2 to " << LargestDimension
                  << ", or all 0; the old ones stay.");
    return;
  }
  if (!std::equal(dimensions, end, this->Dimensions))
  {
    std::copy(dimensions, end, this->Dimensions);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkAirlightDensityImage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkAirlightDensityImage::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  int extent[6] = { 0, DefaultDimension - 1, 0, DefaultDimension - 1, 0, DefaultDimension - 1 };
  if (this->Dimensions[0] > 0)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis + 1] = this->Dimensions[axis] - 1;
    }
  }
  else if (vtkImageData::GetData(input) &&
    input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  }
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAirlightDensityImage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  if (input->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
      input->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkAirlightDensityImage::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize(); // VTK keeps scalars of the last run, of another size
  try
  {
    const std::vector<DensityBlock> blocks = FindDensityBlocks(
      input, { this->ArrayName, this->Component, this->ComponentName, this->Factor });
    if (this->Dimensions[0] == 0 && blocks.size() == 1 && IsWholeImage(blocks[0]))
    {
      CopyImage(blocks[0], this->Factor, this->PassArrays, output);
      return 1;
    }
    const int usual[3] = { DefaultDimension, DefaultDimension, DefaultDimension };
    ResampleBlocks(blocks, this->Factor, this->PassArrays,
      this->Dimensions[0] > 0 ? this->Dimensions : usual, output);
  }
  catch (const std::runtime_error& error)
  {
    vtkErrorMacro(<< "The input " << error.what() << ".");
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkAirlightDensityImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "ComponentName: " << this->ComponentName << "\n";
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << ", "
     << this->Dimensions[2] << "\n";
  os << indent << "PassArrays: " << (this->PassArrays ? "On" : "Off") << "\n";
}
