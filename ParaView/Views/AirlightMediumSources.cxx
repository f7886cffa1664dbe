// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightMediumSources.h"

#include "vtkImageData.h"
#include "vtkPVParticipatingMedium.h"
#include "vtkPolyData.h"

namespace airlight
{
namespace
{
//------------------------------------------------------------------------------
// The state of the session.
vtkTypeUInt64 BringUpToDate(MediumSource& source, double time, const MediumSources::Reduce& reduce)
{
  const vtkTypeUInt64 state = reduce(source.Update(time));
  if (state != MediumSource::UNCHANGED)
  {
    source.Deliver(state);
  }
  return state;
}
}

//------------------------------------------------------------------------------
// Sources that are not needed are left. A window draws before a user has come to the list of
// sources: that is no error.
bool MediumSources::Update(vtkPVParticipatingMedium* medium, double time, const Reduce& reduce)
{
  const bool needsSurface = medium->GetRegion() == vtkParticipatingMedium::SURFACE;
  const bool needsImage = medium->GetDensity() == vtkParticipatingMedium::IMAGE;
  if (needsSurface)
  {
    const vtkTypeUInt64 state = BringUpToDate(this->Surface, time, reduce);
    if (state != MediumSource::UNCHANGED)
    {
      medium->FollowSurface(state == MediumSource::CHANGED ? this->Surface.GetSurface() : nullptr);
    }
  }
  if (needsImage)
  {
    const vtkTypeUInt64 state = BringUpToDate(this->Image, time, reduce);
    if (state != MediumSource::UNCHANGED)
    {
      medium->FollowDensityImage(state == MediumSource::CHANGED ? this->Image.GetImage() : nullptr);
      medium->SetAlbedoArrayName(this->Image.GetArrays().Albedo);
      medium->SetEmissionArrayName(this->Image.GetArrays().Emission);
    }
  }
  return !(needsSurface && !medium->GetSurface()) && !(needsImage && !medium->GetDensityImage());
}
}
