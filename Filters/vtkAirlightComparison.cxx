// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightComparison.h"

#include "Comparison/AirlightImageMetrics.h"

#include "vtkDataArray.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <exception>

vtkStandardNewMacro(vtkAirlightComparison);

namespace
{
void FillTable(const airlight::ImageMetrics& metrics, vtkTable* table)
{
  table->Initialize();
  for (const auto& [name, value] : metrics.GetNamed())
  {
    vtkSmartPointer<vtkDataArray> column;
    if (std::holds_alternative<double>(value))
    {
      column = vtkSmartPointer<vtkDoubleArray>::New();
    }
    else
    {
      column = vtkSmartPointer<vtkIdTypeArray>::New();
    }
    column->SetName(name.c_str());
    column->InsertNextTuple1(
      std::visit([](auto number) { return static_cast<double>(number); }, value));
    table->AddColumn(column);
  }
}

void FillDifference(vtkImageData* image, vtkImageData* reference, const std::vector<bool>& counts,
  vtkImageData* output)
{
  vtkDataArray* a = image->GetPointData()->GetScalars();
  vtkDataArray* b = reference->GetPointData()->GetScalars();
  const bool isFloat = a->GetDataType() == VTK_FLOAT && b->GetDataType() == VTK_FLOAT;
  output->Initialize();
  output->CopyStructure(image);
  output->AllocateScalars(isFloat ? VTK_FLOAT : VTK_DOUBLE, a->GetNumberOfComponents());
  vtkDataArray* difference = output->GetPointData()->GetScalars();
  difference->SetName("Difference");
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    const bool count = counts[static_cast<std::size_t>(i)];
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      difference->SetComponent(i, c, count ? a->GetComponent(i, c) - b->GetComponent(i, c) : 0.0);
    }
  }
}

// All of each input: they may differ in extent, which then is reported.
void RequestWholeExtents(vtkInformationVector** input)
{
  for (int port = 0; port < 3; ++port)
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* information = input[port]->GetInformationObject(0);
    if (information && information->Has(Pipeline::WHOLE_EXTENT()))
    {
      information->Set(Pipeline::UPDATE_EXTENT(), information->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkAirlightComparison::vtkAirlightComparison()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkAirlightComparison::~vtkAirlightComparison() = default;

//------------------------------------------------------------------------------
void vtkAirlightComparison::SetImageData(vtkImageData* image)
{
  this->SetInputDataObject(0, image);
}

//------------------------------------------------------------------------------
void vtkAirlightComparison::SetReferenceData(vtkImageData* reference)
{
  this->SetInputDataObject(1, reference);
}

//------------------------------------------------------------------------------
void vtkAirlightComparison::SetMaskData(vtkImageData* mask) { this->SetInputDataObject(2, mask); }

//------------------------------------------------------------------------------
vtkTable* vtkAirlightComparison::GetMetrics()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
vtkImageData* vtkAirlightComparison::GetDifference()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkAirlightComparison::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 2 ? 1 : 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkAirlightComparison::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkTable" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkAirlightComparison::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    RequestWholeExtents(input);
    return 1;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->RequestData(input, output);
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

//------------------------------------------------------------------------------
int vtkAirlightComparison::RequestData(vtkInformationVector** input, vtkInformationVector* output)
{
  vtkTable* table = vtkTable::GetData(output, 0);
  vtkImageData* difference = vtkImageData::GetData(output, 1);
  try
  {
    vtkImageData* image = vtkImageData::GetData(input[0]);
    vtkImageData* reference = vtkImageData::GetData(input[1]);
    std::vector<bool> counts;
    const airlight::ImageMetrics metrics = airlight::CompareImages(
      image, reference, vtkImageData::GetData(input[2]), this->SkipNonFinite, counts);
    FillTable(metrics, table);
    FillDifference(image, reference, counts, difference);
  }
  catch (const std::exception& error)
  {
    table->Initialize();
    difference->Initialize();
    vtkErrorMacro(<< error.what() << ".");
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkAirlightComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SkipNonFinite: " << (this->SkipNonFinite ? "on" : "off") << "\n";
}
