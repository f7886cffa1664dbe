// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVMediumRepresentation.h"

#include "AirlightMediumSources.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVAirlightRenderView.h"
#include "vtkPVParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

vtkStandardNewMacro(vtkPVMediumRepresentation);

namespace
{
enum DataKind : vtkTypeUInt64
{
  NO_DATA = 0,
  SURFACE_DATA = 1,
  IMAGE_DATA = 2
};

//------------------------------------------------------------------------------
void GetDataBounds(vtkDataObject* data, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    set->GetBounds(bounds);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    composite->GetBounds(bounds);
  }
}

//------------------------------------------------------------------------------
double GetDiagonal(const double bounds[6])
{
  return vtkMath::AreBoundsInitialized(bounds)
    ? std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
    : 0.0;
}
}

//------------------------------------------------------------------------------
vtkPVMediumRepresentation::vtkPVMediumRepresentation()
  : Sources(std::make_unique<airlight::MediumSources>())
{
  vtkMath::UninitializeBounds(this->Bounds);
}

vtkPVMediumRepresentation::~vtkPVMediumRepresentation() = default;

//------------------------------------------------------------------------------
void vtkPVMediumRepresentation::SetMedium(vtkPVParticipatingMedium* medium)
{
  this->Medium = medium;
  this->MarkModified();
}

//------------------------------------------------------------------------------
vtkPVParticipatingMedium* vtkPVMediumRepresentation::GetMedium() { return this->Medium; }

//------------------------------------------------------------------------------
void vtkPVMediumRepresentation::SetDensityArray(int, int, int, int, const char* name)
{
  this->Sources->GetImage().SetDensityArray(name);
}

//------------------------------------------------------------------------------
void vtkPVMediumRepresentation::SetAlbedoArrayName(const char* name)
{
  this->Sources->GetImage().SetAlbedoArray(name);
}

//------------------------------------------------------------------------------
void vtkPVMediumRepresentation::SetEmissionArrayName(const char* name)
{
  this->Sources->GetImage().SetEmissionArray(name);
}

//------------------------------------------------------------------------------
int vtkPVMediumRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVMediumRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkDataObject* data =
    input[0]->GetNumberOfInformationObjects() > 0 ? vtkDataObject::GetData(input[0], 0) : nullptr;
  GetDataBounds(data, this->Bounds);
  this->DataKind = NO_DATA;
  if (data)
  {
    this->DataKind = vtkImageData::SafeDownCast(data) ? IMAGE_DATA : SURFACE_DATA;
  }
  return this->Superclass::RequestData(request, input, output);
}

//------------------------------------------------------------------------------
// The view asks for the data itself, later: all processes need all of them.
int vtkPVMediumRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  if (!this->Superclass::ProcessViewRequest(request, input, output))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVRenderView::SetPiece(input, this, this->Piece);
    vtkPVRenderView::SetGeometryBounds(input, this, this->Bounds);
    if (!vtkPVAirlightRenderView::SafeDownCast(this->GetView()) && !this->WarnedOfView)
    {
      this->WarnedOfView = true;
      vtkWarningMacro(
        << "Only the view \"Render View + Airlight\" shows media; choose it, or another "
           "representation than Medium.");
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
// At the greatest density, 2 % of the light is left along the diagonal. 0: unknown.
double vtkPVMediumRepresentation::GetFullVisibility() const
{
  if (this->Medium->GetDensity() != vtkParticipatingMedium::IMAGE)
  {
    return GetDiagonal(this->Sources->GetSurface().GetSurface()->GetBounds());
  }
  vtkImageData* image = this->Sources->GetImage().GetImage();
  vtkDataArray* densities = image->GetPointData()->GetScalars();
  const double most = densities ? densities->GetRange()[1] : 0.0;
  const double visibility = GetDiagonal(image->GetBounds()) * most;
  return std::isfinite(visibility) && visibility > 0.0 ? visibility : 0.0;
}

//------------------------------------------------------------------------------
bool vtkPVMediumRepresentation::UpdateMedium(
  double time, const std::function<vtkTypeUInt64(vtkTypeUInt64)>& findLargest)
{
  const vtkTypeUInt64 kind = findLargest(this->DataKind);
  if (!this->Medium || kind == NO_DATA)
  {
    return false;
  }
  vtkAlgorithmOutput* connection =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputConnection(0, 0) : nullptr;
  this->Sources->GetSurface().SetConnection(connection);
  this->Sources->GetImage().SetConnection(connection);
  const bool isImage = kind == IMAGE_DATA;
  this->Medium->SetRegion(
    isImage ? vtkParticipatingMedium::UNBOUNDED : vtkParticipatingMedium::SURFACE);
  this->Medium->SetDensity(
    isImage ? vtkParticipatingMedium::IMAGE : vtkParticipatingMedium::UNIFORM);
  const bool hasSource = this->Sources->Update(this->Medium, time, findLargest);
  this->Medium->SetAutomaticVisibility(this->GetFullVisibility());
  return hasSource;
}

//------------------------------------------------------------------------------
void vtkPVMediumRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Medium:";
  if (this->Medium)
  {
    os << "\n";
    this->Medium->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << " (none)\n";
  }
}
