// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightProbeFilter.h"

#include "RayProbes/AirlightFilterInput.h"
#include "RayProbes/AirlightProbe.h"
#include "vtkParticipatingMedium.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <atomic>

using namespace airlight;

namespace
{
// One of the arrays. The filter's work writes to different tuples at once.
class Result
{
public:
  Result(const char* name, vtkIdType count)
  {
    this->Array->SetName(name);
    this->Array->SetNumberOfComponents(3);
    this->Array->SetNumberOfTuples(count);
    this->Array->Fill(0.0);
  }
  void Set(vtkIdType i, const glm::dvec3& rgb) { this->Array->SetTypedTuple(i, &rgb.x); }
  void AddTo(vtkDataSet* data) { data->GetPointData()->AddArray(this->Array); }

private:
  vtkNew<vtkDoubleArray> Array;
};

// The unit normal of a point; 0 where that is none.
glm::dvec3 GetNormal(vtkDataArray* normals, vtkIdType i)
{
  glm::dvec3 n;
  normals->GetTuple(i, &n.x);
  const double length = glm::length(n);
  return std::isfinite(length) && length > 0.0 ? n / length : glm::dvec3(0.0);
}
}

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
void vtkAirlightProbeFilter::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->Medium != medium)
  {
    this->Medium = medium;
    this->Modified();
  }
}

vtkParticipatingMedium* vtkAirlightProbeFilter::GetMedium() { return this->Medium; }

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
  return this->Medium ? std::max(time, this->Medium->GetMTime()) : time;
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
  if (!this->Medium)
  {
    vtkErrorMacro("There is no medium: call SetMedium().");
    return false;
  }
  // They prepare it for several threads.
  this->Medium->GetPhaseErrorBound();
  this->Medium->GetMultipleScatteringErrorBound();
  return std::all_of(this->Lights.begin(), this->Lights.end(),
    [this](vtkLight* light) { return CheckSceneLight(this, this->Medium, light); });
}

//------------------------------------------------------------------------------
bool vtkAirlightProbeFilter::CanScatter(bool hasNormals)
{
  if (!this->ScatteredIrradiance)
  {
    return false;
  }
  const int density = this->Medium->GetDensity();
  if (!hasNormals)
  {
    vtkWarningMacro("ScatteredIrradiance is left out: it needs point normals "
                    "(vtkPolyDataNormals makes them).");
    return false;
  }
  if (density != vtkParticipatingMedium::UNIFORM &&
    density != vtkParticipatingMedium::EXPONENTIAL_HEIGHT)
  {
    vtkWarningMacro("ScatteredIrradiance is left out: it needs a medium that is uniform or of "
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
  const Probe probe{ this->Medium, { this->Lights.begin(), this->Lights.end() }, &occluders };
  const glm::dvec3 eye(this->Viewpoint[0], this->Viewpoint[1], this->Viewpoint[2]);
  const double margin = this->ShadowTolerance * occluders.GetScale();
  vtkDataArray* normals = input->GetPointData()->GetNormals();
  const bool scatters = this->CanScatter(normals);
  const vtkIdType count = input->GetNumberOfPoints();
  Result radiance("Radiance", count);
  Result transmittance("Transmittance", count);
  Result direct("DirectIrradiance", count);
  Result scattered("ScatteredIrradiance", scatters ? count : 0);
  std::atomic<vtkIdType> bad{ 0 };
  const auto measure = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      glm::dvec3 p;
      input->GetPoint(i, &p.x);
      if (!IsUsable(p))
      {
        ++bad;
        continue;
      }
      radiance.Set(i, probe.FindRadiance(eye, p));
      transmittance.Set(i, probe.FindTransmittance(eye, p));
      const glm::dvec3 normal = normals ? GetNormal(normals, i) : glm::dvec3(0.0);
      direct.Set(i, probe.FindDirect(p, normals ? &normal : nullptr, margin));
      if (scatters && normal != glm::dvec3(0.0))
      {
        scattered.Set(i, probe.FindScattered(p, normal));
      }
    }
  };
  if (count > 0)
  {
    double first[3]; // lets the data prepare what it prepares on first use
    input->GetPoint(0, first);
  }
  if (!RunInParts(this, count, 0.1, 1.0, measure))
  {
    return 1;
  }
  if (bad > 0)
  {
    vtkWarningMacro(<< bad << " points get zeros, because they are not finite or more than 1e15 "
                    << "from the origin.");
  }
  radiance.AddTo(output);
  transmittance.AddTo(output);
  direct.AddTo(output);
  if (scatters)
  {
    scattered.AddTo(output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkAirlightProbeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Medium: " << this->Medium.Get() << "\n";
  os << indent << "Lights: " << this->Lights.size() << "\n";
  os << indent << "Viewpoint: " << this->Viewpoint[0] << ", " << this->Viewpoint[1] << ", "
     << this->Viewpoint[2] << "\n";
  os << indent << "ScatteredIrradiance: " << this->ScatteredIrradiance << "\n";
  os << indent << "ShadowTolerance: " << this->ShadowTolerance << "\n";
}
