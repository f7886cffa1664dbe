// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Medium/AirlightMediumSky.h"

#include "MultipleScattering/AirlightLegendreMoments.h"

namespace airlight
{
//------------------------------------------------------------------------------
void MediumSky::Update(
  vtkMTimeType phaseTime, const std::function<double(double)>& phaseFunction, bool needsHemisphere)
{
  if (this->PhaseTime != phaseTime)
  {
    this->PhaseTime = phaseTime;
    this->Moments = GetLegendreMomentsTo(2, phaseFunction);
    this->Hemisphere.reset();
  }
  if (needsHemisphere && !this->Hemisphere)
  {
    this->Hemisphere = FitHemisphere(phaseFunction);
  }
}
}
