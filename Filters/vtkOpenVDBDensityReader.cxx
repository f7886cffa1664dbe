// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenVDBDensityReader.h"

#include "OpenVDB/AirlightDensityImage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>
#include <new>
#include <stdexcept>

// The grid is kept from the request for information to the one for data only.
class vtkOpenVDBDensityReader::Internals
{
public:
  std::vector<airlight::OpenVDBGridInfo> Grids;
  std::size_t Chosen = 0;
  std::unique_ptr<airlight::OpenVDBGrid> Grid;
  airlight::DensityImagePlan Plan{};

  void Read(const std::string& fileName, int maximum)
  {
    try
    {
      this->Grid = airlight::ReadOpenVDBGrid(fileName, this->Chosen);
      this->Plan = airlight::PlanDensityImage(*this->Grid, maximum);
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error("grid '" + this->Grids[this->Chosen].Name + "': " + error.what());
    }
  }
};

vtkStandardNewMacro(vtkOpenVDBDensityReader);

namespace
{
std::string Describe(const std::vector<airlight::OpenVDBGridInfo>& grids)
{
  std::string text;
  for (const airlight::OpenVDBGridInfo& grid : grids)
  {
    text += (text.empty() ? "" : ", ") + ("'" + grid.Name + "' (" + grid.Type + ")");
  }
  return text.empty() ? "no grids" : text;
}
}

//------------------------------------------------------------------------------
vtkOpenVDBDensityReader::vtkOpenVDBDensityReader()
  : Current(new Internals)
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkOpenVDBDensityReader::~vtkOpenVDBDensityReader() = default;

//------------------------------------------------------------------------------
void vtkOpenVDBDensityReader::SetFileName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->FileName != text)
  {
    this->FileName = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpenVDBDensityReader::SetGridName(const char* name)
{
  const std::string text = name ? name : "";
  if (this->GridName != text)
  {
    this->GridName = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkOpenVDBDensityReader::SetMaximumDimension(int points)
{
  if (points < 8 || points > 4096)
  {
    vtkErrorMacro(<< "MaximumDimension " << points << " must be from 8 to 4096; it stays "
                  << this->MaximumDimension << ".");
    return;
  }
  if (this->MaximumDimension != points)
  {
    this->MaximumDimension = points;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkOpenVDBDensityReader::GetNumberOfGrids() const
{
  return static_cast<int>(this->Current->Grids.size());
}

//------------------------------------------------------------------------------
const char* vtkOpenVDBDensityReader::GetGridName(int index) const
{
  const bool known = index >= 0 && index < this->GetNumberOfGrids();
  return known ? this->Current->Grids[static_cast<std::size_t>(index)].Name.c_str() : "";
}

//------------------------------------------------------------------------------
const char* vtkOpenVDBDensityReader::GetGridType(int index) const
{
  const bool known = index >= 0 && index < this->GetNumberOfGrids();
  return known ? this->Current->Grids[static_cast<std::size_t>(index)].Type.c_str() : "";
}

//------------------------------------------------------------------------------
std::size_t vtkOpenVDBDensityReader::FindGrid() const
{
  const std::vector<airlight::OpenVDBGridInfo>& grids = this->Current->Grids;
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    if (this->GridName.empty() ? grids[i].Scalar : grids[i].Name == this->GridName)
    {
      if (!grids[i].Scalar)
      {
        throw std::runtime_error("grid '" + this->GridName + "' holds " + grids[i].Type +
          ", but a density is of float or double; the file holds " + Describe(grids));
      }
      return i;
    }
  }
  throw std::runtime_error(
    (this->GridName.empty() ? "no grid of float or double" : "no grid '" + this->GridName + "'") +
    "; the file holds " + Describe(grids));
}

//------------------------------------------------------------------------------
int vtkOpenVDBDensityReader::Fail(vtkInformationVector* output, const std::string& reason)
{
  this->Current->Grid.reset();
  if (vtkImageData* image = vtkImageData::GetData(output))
  {
    image->Initialize();
  }
  if (this->FileName.empty())
  {
    vtkErrorMacro(<< "There is no file to read: call SetFileName().");
  }
  else
  {
    vtkErrorMacro(<< this->FileName << ": " << reason << ".");
  }
  return 0;
}

//------------------------------------------------------------------------------
int vtkOpenVDBDensityReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  Internals& current = *this->Current;
  try
  {
    current.Grids.clear();
    current.Grids = airlight::ListOpenVDBGrids(this->FileName);
    current.Chosen = this->FindGrid();
    current.Read(this->FileName, this->MaximumDimension);
  }
  catch (const std::exception& error)
  {
    return this->Fail(output, error.what());
  }
  const airlight::DensityImagePlan& plan = current.Plan;
  this->ReductionFactor = static_cast<vtkIdType>(plan.Factor);
  vtkInformation* information = output->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 0, plan.Dimensions[0] - 1, 0,
    plan.Dimensions[1] - 1, 0, plan.Dimensions[2] - 1);
  information->Set(vtkDataObject::ORIGIN(), plan.Origin, 3);
  information->Set(vtkDataObject::SPACING(), plan.Spacing, 3);
  information->Set(vtkDataObject::DIRECTION(), plan.Direction, 9);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkOpenVDBDensityReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  Internals& current = *this->Current;
  vtkImageData* image = vtkImageData::GetData(output);
  const airlight::DensityImagePlan& plan = current.Plan;
  try
  {
    if (!current.Grid)
    {
      current.Read(this->FileName, this->MaximumDimension);
    }
    image->SetDimensions(plan.Dimensions);
    image->SetOrigin(plan.Origin);
    image->SetSpacing(plan.Spacing);
    image->SetDirectionMatrix(plan.Direction);
    image->AllocateScalars(VTK_FLOAT, 1);
    vtkDataArray* values = image->GetPointData()->GetScalars();
    const std::string& name = current.Grids[current.Chosen].Name;
    values->SetName(name.empty() ? "density" : name.c_str());
    this->Warn(airlight::FillDensityImage(
      *current.Grid, plan, static_cast<float*>(values->GetVoidPointer(0))));
  }
  catch (const std::bad_alloc&)
  {
    return this->Fail(output, "there is not enough memory; lower MaximumDimension");
  }
  catch (const std::exception& error)
  {
    return this->Fail(output, error.what());
  }
  current.Grid.reset();
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpenVDBDensityReader::Warn(std::size_t bad)
{
  const airlight::DensityImagePlan& plan = this->Current->Plan;
  const std::string& name = this->Current->Grids[this->Current->Chosen].Name;
  if (plan.Factor > 1)
  {
    vtkWarningMacro(<< this->FileName << ": grid '" << name << "' of " << plan.Voxels[0] << "x"
                    << plan.Voxels[1] << "x" << plan.Voxels[2] << " voxels is read at 1/"
                    << plan.Factor << " of its resolution, as means of voxels, because "
                    << "MaximumDimension is " << this->MaximumDimension << ".");
  }
  if (bad > 0)
  {
    vtkWarningMacro(
      << this->FileName << ": grid '" << name << "' has " << bad
      << " values or tiles that are not finite or beyond 8e37; they count as background.");
  }
}

//------------------------------------------------------------------------------
void vtkOpenVDBDensityReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "GridName: " << this->GridName << "\n";
  os << indent << "MaximumDimension: " << this->MaximumDimension << "\n";
  os << indent << "ReductionFactor: " << this->ReductionFactor << "\n";
  os << indent << "Grids: " << Describe(this->Current->Grids) << "\n";
}
