// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultipleScattering/AirlightMediumSource.h"

#include "MultipleScattering/AirlightLegendreMoments.h"

#include <cmath>
#include <string>

namespace airlight
{
namespace
{
constexpr double MaximumFitError = 0.1; // that is not spoken of
}

//------------------------------------------------------------------------------
std::shared_ptr<const SourceFit> MediumSource::Update(const glm::dvec3& albedo,
  vtkMTimeType phaseTime, const std::function<double(double)>& phaseFunction, std::string& error)
{
  if (this->PhaseTime != phaseTime)
  {
    this->PhaseTime = phaseTime;
    this->Legendre = GetLegendreMoments(phaseFunction);
    this->Albedo = glm::dvec3(-1.0);
    if (this->Legendre.empty())
    {
      this->Made = nullptr;
      error = "Multiple scattering is left out, as the phase function has too narrow a peak: its "
              "Legendre moments are above 1e-4 beyond degree " +
        std::to_string(MaximumLegendreDegree) +
        ". Take one that is less anisotropic, Henyey and Greenstein's to +-0.96.";
    }
  }
  if (!this->Legendre.empty() && this->Albedo != albedo)
  {
    this->Albedo = albedo;
    this->Made = std::make_shared<SourceFit>(FitSource(albedo, this->Legendre));
    if (this->Made->ErrorBound > MaximumFitError)
    {
      error = "Multiple scattering is off by up to " +
        std::to_string(std::lround(100.0 * this->Made->ErrorBound)) +
        " %, as the phase function has narrow or backward lobes, which its fit follows badly. "
        "Take a smoother one, or vtkAirlightReference::SetScatteringOrders().";
    }
  }
  return this->Made;
}
}
