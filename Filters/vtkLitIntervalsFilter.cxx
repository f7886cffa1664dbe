// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLitIntervalsFilter.h"

#include "RayProbes/AirlightFilterInput.h"
#include "RayProbes/AirlightLitLinesOutput.h"
#include "vtkParticipatingMedium.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace airlight;

vtkStandardNewMacro(vtkLitIntervalsFilter);

//------------------------------------------------------------------------------
vtkLitIntervalsFilter::vtkLitIntervalsFilter() { this->SetNumberOfInputPorts(2); }

vtkLitIntervalsFilter::~vtkLitIntervalsFilter() = default;

//------------------------------------------------------------------------------
void vtkLitIntervalsFilter::SetLight(vtkLight* light)
{
  if (this->Light != light)
  {
    this->Light = light;
    this->Modified();
  }
}

vtkLight* vtkLitIntervalsFilter::GetLight() { return this->Light; }

//------------------------------------------------------------------------------
void vtkLitIntervalsFilter::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->Medium != medium)
  {
    this->Medium = medium;
    this->Modified();
  }
}

vtkParticipatingMedium* vtkLitIntervalsFilter::GetMedium() { return this->Medium; }

//------------------------------------------------------------------------------
void vtkLitIntervalsFilter::AddOccluderData(vtkPolyData* data)
{
  if (!data)
  {
    vtkErrorMacro("The occluder is null; give it a vtkPolyData.");
    return;
  }
  this->AddInputDataObject(1, data);
}

void vtkLitIntervalsFilter::RemoveAllOccluders() { this->RemoveAllInputConnections(1); }

//------------------------------------------------------------------------------
vtkMTimeType vtkLitIntervalsFilter::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->Light ? std::max(time, GetLightTime(this->Light)) : time;
  return this->Medium ? std::max(time, this->Medium->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkLitIntervalsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkLitIntervalsFilter::CheckSettings()
{
  if (!this->Light)
  {
    vtkErrorMacro("There is no light: call SetLight().");
    return false;
  }
  if (!this->Medium)
  {
    vtkErrorMacro("There is no medium: call SetMedium().");
    return false;
  }
  return CheckSceneLight(this, this->Medium, this->Light);
}

//------------------------------------------------------------------------------
int vtkLitIntervalsFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* lines = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!lines || !output || !this->CheckSettings())
  {
    return 1; // the output is empty
  }
  vtkIdType badPoint = -1;
  vtkIdType badLines = 0;
  std::vector<LineSegment> segments = CollectSegments(lines, badPoint, badLines);
  if (badLines > 0)
  {
    const double* p = lines->GetPoint(badPoint);
    vtkWarningMacro(<< badLines << " lines are left out, because not all their points are finite "
                    << "and within 1e15 of the origin: first point " << badPoint << " (" << p[0]
                    << ", " << p[1] << ", " << p[2] << ").");
  }
  const Occluders occluders = CollectOccluders(inputs[1]);
  const auto count = static_cast<vtkIdType>(segments.size());
  std::vector<glm::dvec3> depths(segments.size());
  std::vector<std::vector<LitPart>> parts(segments.size());
  const auto measure = [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      depths[i] = FindDepth(this->Medium, segments[i]);
      parts[i] = FindLitParts(this->Medium, this->Light, occluders, segments[i]);
    }
  };
  if (!RunInParts(this, count, 0.1, 0.9, measure))
  {
    return 1;
  }
  LitLinesOutput writer(occluders);
  for (size_t i = 0; i < segments.size(); ++i)
  {
    const bool follows = i > 0 && segments[i].Cell == segments[i - 1].Cell;
    segments[i].DepthBefore =
      follows ? segments[i - 1].DepthBefore + depths[i - 1] : glm::dvec3(0.0);
    writer.Add(segments[i], parts[i]);
  }
  writer.Finish(output);
  return 1;
}

//------------------------------------------------------------------------------
void vtkLitIntervalsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Light: " << this->Light.Get() << "\n";
  os << indent << "Medium: " << this->Medium.Get() << "\n";
}
