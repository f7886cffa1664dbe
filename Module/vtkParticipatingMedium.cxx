// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticipatingMedium.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Koschmieder's constant -ln(0.02): contrast 2 % at the meteorological range.
constexpr double KoschmiederConstant = 3.912;
// Sums and products of coefficients stay finite.
constexpr double LargestCoefficient = 1e100;
constexpr double SmallestLength = 1e-99;

double Mean(const double v[3]) { return (v[0] + v[1] + v[2]) / 3.0; }
bool IsLength(double distance) { return std::isfinite(distance) && distance >= SmallestLength; }
}

vtkStandardNewMacro(vtkParticipatingMedium);

//------------------------------------------------------------------------------
vtkParticipatingMedium::vtkParticipatingMedium()
  : PhaseTableRead(std::make_unique<airlight::PhaseTable>())
{
}

vtkParticipatingMedium::~vtkParticipatingMedium() = default;

//------------------------------------------------------------------------------
bool vtkParticipatingMedium::SetCoefficients(
  const char* name, double target[3], double r, double g, double b)
{
  const double values[3] = { r, g, b };
  for (double value : values)
  {
    if (!(value >= 0.0 && value <= LargestCoefficient))
    {
      vtkErrorMacro(<< name << " (" << r << ", " << g << ", " << b
                    << ") must be finite, at least 0 and at most " << LargestCoefficient
                    << " in each channel; the old values stay.");
      return false;
    }
  }
  if (!std::equal(values, values + 3, target))
  {
    std::copy(values, values + 3, target);
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetScattering(double r, double g, double b)
{
  this->SetCoefficients("Scattering", this->Scattering, r, g, b);
}

void vtkParticipatingMedium::SetScattering(const double rgb[3])
{
  this->SetScattering(rgb[0], rgb[1], rgb[2]);
}

void vtkParticipatingMedium::SetAbsorption(double r, double g, double b)
{
  this->SetCoefficients("Absorption", this->Absorption, r, g, b);
}

void vtkParticipatingMedium::SetAbsorption(const double rgb[3])
{
  this->SetAbsorption(rgb[0], rgb[1], rgb[2]);
}

void vtkParticipatingMedium::SetAmbientRadiance(double r, double g, double b)
{
  this->SetCoefficients("AmbientRadiance", this->AmbientRadiance, r, g, b);
}

void vtkParticipatingMedium::SetAmbientRadiance(const double rgb[3])
{
  this->SetAmbientRadiance(rgb[0], rgb[1], rgb[2]);
}

//------------------------------------------------------------------------------
double* vtkParticipatingMedium::GetExtinction()
{
  this->GetExtinction(this->Extinction);
  return this->Extinction;
}

void vtkParticipatingMedium::GetExtinction(double rgb[3])
{
  for (int i = 0; i < 3; ++i)
  {
    rgb[i] = this->Scattering[i] + this->Absorption[i];
  }
}

double* vtkParticipatingMedium::GetAlbedo()
{
  this->GetAlbedo(this->Albedo);
  return this->Albedo;
}

void vtkParticipatingMedium::GetAlbedo(double rgb[3])
{
  for (int i = 0; i < 3; ++i)
  {
    const double extinction = this->Scattering[i] + this->Absorption[i];
    rgb[i] = extinction > 0.0 ? this->Scattering[i] / extinction : 1.0;
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::ScaleExtinction(double meanExtinction)
{
  const double mean = Mean(this->GetExtinction());
  if (mean > 0.0)
  {
    for (int i = 0; i < 3; ++i)
    {
      // In this order no quotient of tiny numbers overflows.
      this->Scattering[i] = this->Scattering[i] / mean * meanExtinction;
      this->Absorption[i] = this->Absorption[i] / mean * meanExtinction;
    }
  }
  else
  {
    std::fill_n(this->Scattering, 3, meanExtinction);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetVisibility(double distance)
{
  if (!IsLength(distance))
  {
    vtkErrorMacro(<< "Visibility " << distance << " must be finite, above 0 and at least "
                  << SmallestLength << "; the coefficients stay.");
    return;
  }
  this->ScaleExtinction(KoschmiederConstant / distance);
}

double vtkParticipatingMedium::GetVisibility()
{
  return KoschmiederConstant * this->GetMeanFreePath();
}

void vtkParticipatingMedium::SetMeanFreePath(double distance)
{
  if (!IsLength(distance))
  {
    vtkErrorMacro(<< "MeanFreePath " << distance << " must be finite, above 0 and at least "
                  << SmallestLength << "; the coefficients stay.");
    return;
  }
  this->ScaleExtinction(1.0 / distance);
}

double vtkParticipatingMedium::GetMeanFreePath()
{
  const double mean = Mean(this->GetExtinction());
  return mean > 0.0 ? 1.0 / mean : std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkParticipatingMedium::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->PhaseTable ? std::max(time, this->PhaseTable->GetMTime()) : time;
  time = this->DensityImage ? std::max(time, this->DensityImage->GetMTime()) : time;
  return this->Surface ? std::max(time, this->Surface->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print3 = [&](const char* name, const double v[3]) {
    os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n";
  };
  print3("Scattering", this->Scattering);
  print3("Absorption", this->Absorption);
  print3("AmbientRadiance", this->AmbientRadiance);
  this->PrintPhase(os, indent);
  const char* regions[] = { "Unbounded", "Box", "Sphere", "Surface" };
  os << indent << "Region: " << regions[this->Region] << "\n";
  os << indent << "Bounds: (" << this->Bounds[0];
  for (int i = 1; i < 6; ++i)
  {
    os << ", " << this->Bounds[i];
  }
  os << ")\n";
  print3("Center", this->Center);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Surface: " << this->Surface.Get() << "\n";
  const char* densities[] = { "Uniform", "ExponentialHeight", "Image" };
  os << indent << "Density: " << densities[this->Density] << "\n";
  os << indent << "DensityImage: " << this->DensityImage.Get() << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  os << indent << "ReferenceHeight: " << this->ReferenceHeight << "\n";
  print3("Up", this->Up);
}
