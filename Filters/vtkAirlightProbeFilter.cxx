// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightProbeFilter.h"

#include "RayProbes/AirlightFilterInput.h"
#include "RayProbes/AirlightProbe.h"
#include "RayProbes/AirlightProbeArrays.h"
#include "vtkParticipatingMedium.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace airlight;

vtkStandardNewMacro(vtkAirlightProbeFilter);

//------------------------------------------------------------------------------
vtkAirlightProbeFilter::vtkAirlightProbeFilter() { this->SetNumberOfInputPorts(2); }

vtkAirlightProbeFilter::~vtkAirlightProbeFilter() = default;

//------------------------------------------------------------------------------
void vtkAirlightProbeFilter::AddLight(vtkLight* light)
{
  if (!light)
  {
    vtkErrorMacro("The light is null; give it a vtkLight.");
    return;
  }
  if (std::find(this->Lights.begin(), this->Lights.end(), light) == this->Lights.end())
  {
    this->Lights.emplace_back(light);
    this->Modified();
  }
}

void vtkAirlightProbeFilter::RemoveLight(vtkLight* light)
{
  const auto found = std::find(this->Lights.begin(), this->Lights.end(), light);
  if (found != this->Lights.end())
  {
    this->Lights.erase(found);
    this->Modified();
  }
}

void vtkAirlightProbeFilter::RemoveAllLights()
{
  if (!this->Lights.empty())
  {
    this->Lights.clear();
    this->Modified();
  }
}

int vtkAirlightProbeFilter::GetNumberOfLights() { return static_cast<int>(this->Lights.size()); }

vtkLight* vtkAirlightProbeFilter::GetLight(int index)
{
  return index >= 0 && index < this->GetNumberOfLights() ? this->Lights[index].Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkAirlightProbeFilter::AddMedium(vtkParticipatingMedium* medium)
{
  if (!medium)
  {
    vtkErrorMacro("The medium is null; give it a vtkParticipatingMedium.");
    return;
  }
  if (std::find(this->Media.begin(), this->Media.end(), medium) == this->Media.end())
  {
    this->Media.emplace_back(medium);
    this->Modified();
  }
}

void vtkAirlightProbeFilter::RemoveMedium(vtkParticipatingMedium* medium)
{
  const auto found = std::find(this->Media.begin(), this->Media.end(), medium);
  if (found != this->Media.end())
  {
    this->Media.erase(found);
    this->Modified();
  }
}

void vtkAirlightProbeFilter::RemoveAllMedia() { this->SetMedium(nullptr); }

void vtkAirlightProbeFilter::SetMedium(vtkParticipatingMedium* medium)
{
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> media;
  if (medium)
  {
    media.emplace_back(medium);
  }
  if (this->Media != media)
  {
    this->Media = media;
    this->Modified();
  }
}

int vtkAirlightProbeFilter::GetNumberOfMedia() { return static_cast<int>(this->Media.size()); }

vtkParticipatingMedium* vtkAirlightProbeFilter::GetMedium(int index)
{
  return index >= 0 && index < this->GetNumberOfMedia() ? this->Media[index].Get() : nullptr;
}

//------------------------------------------------------------------------------
void vtkAirlightProbeFilter::SetViewpoint(double x, double y, double z)
{
  if (!IsUsable({ x, y, z }))
  {
    vtkErrorMacro("The viewpoint (" << x << ", " << y << ", " << z
                                    << ") must be finite and at most 1e15; the old one stays.");
    return;
  }
  const double values[3] = { x, y, z };
  if (!std::equal(values, values + 3, this->Viewpoint))
  {
    std::copy(values, values + 3, this->Viewpoint);
    this->Modified();
  }
}

void vtkAirlightProbeFilter::SetViewpoint(const double viewpoint[3])
{
  this->SetViewpoint(viewpoint[0], viewpoint[1], viewpoint[2]);
}

//------------------------------------------------------------------------------
bool vtkAirlightProbeFilter::SetNumber(
  const char* name, double& target, double value, bool accepted, const char* range)
{
  if (!accepted)
  {
    vtkErrorMacro(<< name << " " << value << " must be " << range << "; it stays " << target
                  << ".");
    return false;
  }
  if (target != value)
  {
    target = value;
    this->Modified();
  }
  return true;
}

void vtkAirlightProbeFilter::SetReflectingSignConstant(double constant)
{
  this->SetNumber("ReflectingSignConstant", this->ReflectingSignConstant, constant,
    constant > 0.0 && std::isfinite(constant), "finite and above 0");
}

void vtkAirlightProbeFilter::SetEmittingSignConstant(double constant)
{
  this->SetNumber("EmittingSignConstant", this->EmittingSignConstant, constant,
    constant > 0.0 && std::isfinite(constant), "finite and above 0");
}

void vtkAirlightProbeFilter::SetMaximumVisibility(double distance)
{
  this->SetNumber(
    "MaximumVisibility", this->MaximumVisibility, distance, distance > 0.0, "above 0");
}

void vtkAirlightProbeFilter::SetSignRadiance(double radiance)
{
  this->SetNumber("SignRadiance", this->SignRadiance, radiance,
    radiance >= 0.0 && radiance <= 1e100, "from 0 to 1e100");
}

void vtkAirlightProbeFilter::SetSignReflectance(double reflectance)
{
  this->SetNumber("SignReflectance", this->SignReflectance, reflectance,
    reflectance >= 0.0 && reflectance <= 1.0, "from 0 to 1");
}

void vtkAirlightProbeFilter::SetSignGroundReflectance(double reflectance)
{
  this->SetNumber("SignGroundReflectance", this->SignGroundReflectance, reflectance,
    reflectance >= 0.0 && reflectance <= 1.0, "from 0 to 1");
}

//------------------------------------------------------------------------------
void vtkAirlightProbeFilter::AddOccluderData(vtkPolyData* data)
{
  if (!data)
  {
    vtkErrorMacro("The occluder is null; give it a vtkPolyData.");
    return;
  }
  this->AddInputDataObject(1, data);
}

void vtkAirlightProbeFilter::RemoveAllOccluders() { this->RemoveAllInputConnections(1); }

//------------------------------------------------------------------------------
vtkMTimeType vtkAirlightProbeFilter::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkLight* light : this->Lights)
  {
    time = std::max(time, GetLightTime(light));
  }
  for (vtkParticipatingMedium* medium : this->Media)
  {
    time = std::max(time, medium->GetMTime());
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkAirlightProbeFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkAirlightProbeFilter::CheckSettings()
{
  if (this->Media.empty())
  {
    vtkErrorMacro("There is no medium: call SetMedium().");
    return false;
  }
  if (this->GetNumberOfMedia() > AIRLIGHT_MAX_MEDIA)
  {
    vtkErrorMacro(<< "There are " << this->GetNumberOfMedia() << " media and at most "
                  << AIRLIGHT_MAX_MEDIA << " are computed: call RemoveMedium().");
    return false;
  }
  // They prepare the media for several threads.
  ConvertMedia({ this->Media.begin(), this->Media.end() }, glm::dvec3(0.0));
  for (vtkParticipatingMedium* medium : this->Media)
  {
    medium->GetPhaseErrorBound();
    medium->GetSourceFit(this->GetNumberOfMedia() == 1);
  }
  return std::all_of(this->Lights.begin(), this->Lights.end(),
    [this](vtkLight* light) { return CheckSceneLight(this, this->GetMedium(), light); });
}

//------------------------------------------------------------------------------
bool vtkAirlightProbeFilter::CanScatter(bool hasNormals)
{
  if (!this->ScatteredIrradiance)
  {
    return false;
  }
  if (!hasNormals)
  {
    vtkWarningMacro("ScatteredIrradiance is left out: it needs point normals "
                    "(vtkPolyDataNormals makes them).");
    return false;
  }
  if (std::any_of(this->Media.begin(), this->Media.end(), [](vtkParticipatingMedium* medium) {
        return medium->GetDensity() == vtkParticipatingMedium::IMAGE;
      }))
  {
    vtkWarningMacro("ScatteredIrradiance is left out: it needs media that are uniform or of "
                    "exponential height.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkAirlightProbeFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
  vtkDataSet* output = vtkDataSet::GetData(outputs);
  if (!input || !output)
  {
    return 1;
  }
  output->ShallowCopy(input);
  if (!this->CheckSettings())
  {
    return 1;
  }
  const Occluders occluders = CollectOccluders(inputs[1]);
  const Probe probe{ { this->Media.begin(), this->Media.end() },
    { this->Lights.begin(), this->Lights.end() }, &occluders };
  ProbeArrays arrays(probe, input);
  arrays.Eye = glm::dvec3(this->Viewpoint[0], this->Viewpoint[1], this->Viewpoint[2]);
  arrays.Margin = this->ShadowTolerance * occluders.GetScale();
  if (this->CanScatter(input->GetPointData()->GetNormals()))
  {
    arrays.AddScattered();
  }
  if (this->SightLines)
  {
    arrays.AddSightLines(
      { this->ReflectingSignConstant, this->EmittingSignConstant, this->MaximumVisibility,
        { this->SignRadiance, this->SignReflectance, this->SignGroundReflectance } });
  }
  const auto measure = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      arrays.Measure(i);
    }
  };
  if (!RunInParts(this, input->GetNumberOfPoints(), 0.1, 1.0, measure))
  {
    return 1;
  }
  if (arrays.Bad > 0)
  {
    vtkWarningMacro(<< arrays.Bad << " points get zeros, because they are not finite or more than "
                    << "1e15 from the origin.");
  }
  arrays.AddTo(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkAirlightProbeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfMedia: " << this->Media.size() << "\n";
  os << indent << "Lights: " << this->Lights.size() << "\n";
  os << indent << "Viewpoint: " << this->Viewpoint[0] << ", " << this->Viewpoint[1] << ", "
     << this->Viewpoint[2] << "\n";
  os << indent << "ScatteredIrradiance: " << this->ScatteredIrradiance << "\n";
  os << indent << "ShadowTolerance: " << this->ShadowTolerance << "\n";
  os << indent << "SightLines: " << this->SightLines << "\n";
  os << indent << "ReflectingSignConstant: " << this->ReflectingSignConstant << "\n";
  os << indent << "EmittingSignConstant: " << this->EmittingSignConstant << "\n";
  os << indent << "MaximumVisibility: " << this->MaximumVisibility << "\n";
  os << indent << "SignRadiance: " << this->SignRadiance << "\n";
  os << indent << "SignReflectance: " << this->SignReflectance << "\n";
  os << indent << "SignGroundReflectance: " << this->SignGroundReflectance << "\n";
}
