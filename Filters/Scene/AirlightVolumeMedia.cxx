// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightVolumeMedia.h"

#include "Density/AirlightDensityGrid.h"
#include "Integration/AirlightMatrix.h"
#include "Scene/AirlightCasterKeys.h"
#include "Scene/AirlightVolumeCheck.h"
#include "Scene/AirlightVolumeExtinction.h"

#include "vtkMatrix4x4.h"
#include "vtkPhaseFunction.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <iterator>

namespace airlight
{
namespace
{
// Renderers may share a pass.
constexpr int OldestMedium = 4;

VolumeMedium MakeMedium(vtkVolume* volume)
{
  VolumeMedium result{ volume, nullptr, {} };
  std::string reason;
  const VolumeImage image = MakeVolumeImage(volume, volume->GetMatrix(), true, reason);
  if (!reason.empty())
  {
    result.Error = DescribeNoMedium(volume, reason);
  }
  if (image.Image && !DensityGrid::Build(image.Image, reason))
  {
    result.Error = DescribeNoMedium(volume, "its image " + reason);
  }
  else if (image.Image)
  {
    result.Medium = vtkSmartPointer<vtkParticipatingMedium>::New();
    result.Medium->SetAbsorption(image.SigmaT, image.SigmaT, image.SigmaT);
    result.Medium->SetDensityImage(image.Image);
    result.Medium->SetDensityToImage();
    result.Medium->SetAlbedoArrayName(VolumeAlbedos);
  }
  return result;
}
}

//------------------------------------------------------------------------------
const VolumeMedium& VolumeMedia::Get(vtkVolume* volume)
{
  const vtkMTimeType time = GetVolumeTime(volume);
  const glm::dmat4 matrix = ToGlm(volume->GetMatrix());
  Entry& entry = this->Entries[volume];
  entry.Age = 0;
  if (entry.Time != time || entry.ToWorld != matrix)
  {
    entry.ToWorld = matrix;
    entry.Found = MakeMedium(volume);
    // A property makes the functions that it does not have.
    entry.Time = GetVolumeTime(volume);
  }
  if (entry.Found.Medium)
  {
    entry.Found.Medium->SetPhaseFunction(GetVolumePhaseFunction(volume));
  }
  return entry.Found;
}

//------------------------------------------------------------------------------
std::vector<VolumeMedium> VolumeMedia::Update(vtkRenderer* renderer)
{
  std::vector<VolumeMedium> found;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it = nullptr;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && volume->GetVisibility() && volume->GetMapper() && IsMedium(volume, volume))
    {
      found.push_back(this->Get(volume));
    }
  }
  for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
  {
    entry = ++entry->second.Age > OldestMedium ? this->Entries.erase(entry) : std::next(entry);
  }
  return found;
}
}
