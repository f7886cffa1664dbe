// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightFrameRecorder.h"

#include "Frame/AirlightTargets.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
bool HasMean(const std::string& buffer) { return buffer != "Depth" && buffer != "BoundaryCount"; }

vtkSmartPointer<vtkImageData> MakeBlack(vtkImageData* like)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->DeepCopy(like);
  image->GetPointData()->GetScalars()->Fill(0.0);
  return image;
}
}

//------------------------------------------------------------------------------
bool FrameRecorder::Record(Targets& targets, bool several)
{
  std::vector<vtkTextureObject*> colours = { targets.Radiance, targets.Airlight, targets.Surface,
    targets.Transmittance };
  if (several)
  {
    colours.push_back(targets.Several);
  }
  if (!targets.Bind(colours, nullptr))
  {
    return false;
  }
  this->Buffers["Radiance"] = targets.Read(0, 0, 3);
  this->Buffers["Airlight"] = targets.Read(1, 0, 3);
  this->Buffers["Surface"] = targets.Read(2, 0, 3);
  this->Buffers["Transmittance"] = targets.Read(3, 0, 3);
  this->Buffers["Depth"] = targets.Read(3, 3, 1);
  this->Buffers["ErrorBound"] = targets.Read(1, 3, 1);
  this->Buffers["MultipleScattering"] =
    several ? targets.Read(4, 0, 3) : MakeBlack(this->Buffers["Airlight"]);
  if (!targets.Bind({ targets.Counts }, nullptr))
  {
    return false;
  }
  this->Buffers["BoundaryCount"] = targets.Read(0, 0, 1);
  this->Buffers["LitLength"] = targets.Read(0, 2, 1);
  return true;
}

//------------------------------------------------------------------------------
bool FrameRecorder::RecordLight(Targets& targets, int light)
{
  if (!targets.Bind({ targets.Single }, nullptr))
  {
    return false;
  }
  this->Buffers["Airlight:" + std::to_string(light)] = targets.Read(0, 0, 3);
  return true;
}

//------------------------------------------------------------------------------
void FrameRecorder::BeginMean()
{
  this->Means.clear();
  for (const auto& buffer : this->Buffers)
  {
    vtkSmartPointer<vtkImageData>& mean = this->Means[buffer.first];
    mean = vtkSmartPointer<vtkImageData>::New();
    mean->DeepCopy(buffer.second);
  }
}

//------------------------------------------------------------------------------
void FrameRecorder::AddToMean(float weight, const std::vector<float>& mask)
{
  for (const auto& buffer : this->Buffers)
  {
    if (!HasMean(buffer.first))
    {
      continue;
    }
    const auto* values = static_cast<const float*>(buffer.second->GetScalarPointer());
    auto* means = static_cast<float*>(this->Means[buffer.first]->GetScalarPointer());
    const auto components = static_cast<size_t>(buffer.second->GetNumberOfScalarComponents());
    for (size_t i = 0; i < components * mask.size(); ++i)
    {
      means[i] += mask[i / components] > 0.0f ? weight * (values[i] - means[i]) : 0.0f;
    }
  }
}

//------------------------------------------------------------------------------
void FrameRecorder::AddToMean(float weight)
{
  for (const auto& buffer : this->Buffers)
  {
    if (!HasMean(buffer.first))
    {
      continue;
    }
    vtkSmartPointer<vtkImageData>& mean = this->Means[buffer.first];
    if (!mean)
    {
      mean = vtkSmartPointer<vtkImageData>::New();
      mean->DeepCopy(buffer.second);
      continue;
    }
    const auto* values = static_cast<const float*>(buffer.second->GetScalarPointer());
    auto* means = static_cast<float*>(mean->GetScalarPointer());
    const vtkIdType count = mean->GetNumberOfPoints() * mean->GetNumberOfScalarComponents();
    std::transform(values, values + count, means, means,
      [weight](float value, float before) { return before + weight * (value - before); });
  }
}

//------------------------------------------------------------------------------
void FrameRecorder::TakeMean()
{
  for (const auto& mean : this->Means)
  {
    const auto image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(mean.second);
    this->Buffers[mean.first] = image;
  }
}

//------------------------------------------------------------------------------
vtkImageData* FrameRecorder::Get(const std::string& name) const
{
  const auto it = this->Buffers.find(name);
  return it != this->Buffers.end() ? it->second.Get() : nullptr;
}
}
