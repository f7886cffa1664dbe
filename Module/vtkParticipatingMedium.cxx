// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticipatingMedium.h"

#include "Density/AirlightDensityGrid.h"
#include "Medium/AirlightDerivedData.h"
#include "Medium/AirlightMediumColours.h"
#include "Medium/AirlightMediumSky.h"
#include "MultipleScattering/AirlightMediumSource.h"
#include "Phase/AirlightMediumPhase.h"
#include "Region/AirlightRegionKinds.h"
#include "Region/AirlightSurfaceTree.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

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
struct vtkParticipatingMedium::Internals
{
  airlight::MediumPhase Phase;
  airlight::MediumSource Source;
  airlight::MediumSky Sky;
  airlight::DerivedData<vtkPolyData, airlight::SurfaceTree> Surface{ "surface", "surface",
    "The region is a surface and there is none: call SetSurface(). The medium is ignored until "
    "then." };
  airlight::DerivedData<vtkImageData, airlight::DensityGrid> Image{ "density image", "image",
    "The density is an image and there is none: call SetDensityImage(). The medium is ignored "
    "until then." };
  airlight::MediumColours Albedo;
  airlight::MediumColours EmissionFactors;

  // An array of the image, if that is in use.
  static std::shared_ptr<const airlight::ImageColours> UpdateColours(vtkParticipatingMedium* medium,
    airlight::MediumColours& colours, const std::string& name, double most)
  {
    airlight::Change problem;
    const auto grid = medium->GetDensityGrid();
    auto updated = colours.Update(medium->GetDensityImage(), grid, name, most, problem.Error);
    medium->Apply(problem);
    return updated;
  }
};

//------------------------------------------------------------------------------
vtkParticipatingMedium::vtkParticipatingMedium()
  : Impl(std::make_unique<Internals>())
{
}

vtkParticipatingMedium::~vtkParticipatingMedium() = default;

//------------------------------------------------------------------------------
void vtkParticipatingMedium::Apply(const airlight::Change& change)
{
  if (!change.Error.empty())
  {
    vtkErrorMacro(<< change.Error);
  }
  if (change.Changed)
  {
    this->Modified();
  }
}

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
bool vtkParticipatingMedium::SetVector(
  const char* name, double target[3], double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorMacro(<< name << " (" << x << ", " << y << ", " << z
                  << ") must be finite; the old one stays.");
    return false;
  }
  const double values[3] = { x, y, z };
  if (!std::equal(values, values + 3, target))
  {
    std::copy(values, values + 3, target);
    this->Modified();
  }
  return true;
}

// The vector is normalised. Its square may be beyond all numbers.
bool vtkParticipatingMedium::SetDirection(
  const char* name, double target[3], double x, double y, double z)
{
  const double largest = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  const bool finite = std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  if (!finite || largest == 0.0)
  {
    vtkErrorMacro(<< name << " (" << x << ", " << y << ", " << z
                  << ") must be a direction: finite and not 0; the old one stays.");
    return false;
  }
  const double v[3] = { x / largest, y / largest, z / largest };
  const double length = std::hypot(v[0], v[1], v[2]);
  return this->SetVector(name, target, v[0] / length, v[1] / length, v[2] / length);
}

bool vtkParticipatingMedium::SetNumber(
  const char* name, double& target, double value, bool accepted, const char* range)
{
  if (!std::isfinite(value) || !accepted)
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

void vtkParticipatingMedium::SetSkyRadiance(double r, double g, double b)
{
  this->SetCoefficients("SkyRadiance", this->SkyRadiance, r, g, b);
}

void vtkParticipatingMedium::SetSkyRadiance(const double rgb[3])
{
  this->SetSkyRadiance(rgb[0], rgb[1], rgb[2]);
}

void vtkParticipatingMedium::SetGroundRadiance(double r, double g, double b)
{
  this->SetCoefficients("GroundRadiance", this->GroundRadiance, r, g, b);
}

void vtkParticipatingMedium::SetGroundRadiance(const double rgb[3])
{
  this->SetGroundRadiance(rgb[0], rgb[1], rgb[2]);
}

void vtkParticipatingMedium::SetSkyHarmonics(const double coefficients[27])
{
  for (int i = 0; i < 27; ++i)
  {
    if (!(std::abs(coefficients[i]) <= LargestCoefficient))
    {
      vtkErrorMacro(<< "SkyHarmonics has the coefficient " << coefficients[i] << " at " << i
                    << ", which must be finite and from -" << LargestCoefficient << " to "
                    << LargestCoefficient << "; the old ones stay.");
      return;
    }
  }
  if (!std::equal(coefficients, coefficients + 27, this->SkyHarmonics))
  {
    std::copy_n(coefficients, 27, this->SkyHarmonics);
    this->Modified();
  }
}

void vtkParticipatingMedium::ClearSkyHarmonics()
{
  const double none[27] = {};
  this->SetSkyHarmonics(none);
}

//------------------------------------------------------------------------------
const airlight::MediumSky& vtkParticipatingMedium::UpdateSky(bool needsHemisphere)
{
  // Objects and tables change by themselves.
  this->GetPhaseShape();
  this->Impl->Sky.Update(
    this->Impl->Phase.GetTime(), [this](double mu) { return this->EvaluatePhaseFunction(mu); },
    needsHemisphere);
  return this->Impl->Sky;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetEmission(double r, double g, double b)
{
  this->SetCoefficients("Emission", this->Emission, r, g, b);
}

void vtkParticipatingMedium::SetEmission(const double rgb[3])
{
  this->SetEmission(rgb[0], rgb[1], rgb[2]);
}

void vtkParticipatingMedium::GetFiniteEmission(double rgb[3])
{
  std::copy_n(this->Emission, 3, rgb);
  if (this->Region != UNBOUNDED || this->Density == IMAGE)
  {
    return;
  }
  for (int c = 0; c < 3; ++c)
  {
    if (rgb[c] > 0.0 && !(this->GetExtinction()[c] > 0.0))
    {
      rgb[c] = 0.0;
      if (this->EmissionProblemTime != this->GetMTime())
      {
        this->EmissionProblemTime = this->GetMTime();
        vtkErrorMacro(<< "Emission (" << this->Emission[0] << ", " << this->Emission[1] << ", "
                      << this->Emission[2] << ") of an unbounded medium is infinitely bright in "
                      << "channel " << c
                      << ", whose extinction is 0; the channel emits nothing. Call "
                      << "SetAbsorption() or SetRegion().");
      }
    }
  }
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
void vtkParticipatingMedium::SetPhaseFunction(int type)
{
  this->Apply(this->Impl->Phase.SetType(type));
}

int vtkParticipatingMedium::GetPhaseFunction() { return this->Impl->Phase.GetType(); }

void vtkParticipatingMedium::SetPhaseFunction(vtkPhaseFunction* function)
{
  this->Apply(this->Impl->Phase.SetFunction(function));
}

vtkPhaseFunction* vtkParticipatingMedium::GetPhaseFunctionObject()
{
  return this->Impl->Phase.GetFunction();
}

void vtkParticipatingMedium::SetAnisotropy(double g)
{
  this->Apply(this->Impl->Phase.SetAnisotropy(g));
}

double vtkParticipatingMedium::GetAnisotropy() { return this->Impl->Phase.GetAnisotropy(); }

void vtkParticipatingMedium::SetPhaseTable(vtkTable* table)
{
  this->Apply(this->Impl->Phase.SetTable(table));
}

vtkTable* vtkParticipatingMedium::GetPhaseTable() { return this->Impl->Phase.GetTable(); }

void vtkParticipatingMedium::SetPhaseTolerance(double tolerance)
{
  this->Apply(this->Impl->Phase.SetTolerance(tolerance));
}

double vtkParticipatingMedium::GetPhaseTolerance() { return this->Impl->Phase.GetTolerance(); }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkParticipatingMedium::GetPhaseShape()
{
  airlight::Change problem;
  const std::shared_ptr<const airlight::PhaseShape> shape =
    this->Impl->Phase.GetShape(problem.Error);
  this->Apply(problem);
  return shape;
}

//------------------------------------------------------------------------------
double vtkParticipatingMedium::GetPhaseErrorBound()
{
  return this->GetPhaseShape()->Fit.ErrorBound;
}

int vtkParticipatingMedium::GetNumberOfPhasePoles()
{
  return static_cast<int>(this->GetPhaseShape()->Fit.Poles.size());
}

void vtkParticipatingMedium::GetPhasePole(int index, double pole[4])
{
  const auto shape = this->GetPhaseShape();
  const int count = static_cast<int>(shape->Fit.Poles.size());
  airlight::PhasePole found;
  if (index < 0 || index >= count)
  {
    vtkErrorMacro(<< "Phase pole " << index << " does not exist: there are " << count << ".");
  }
  else
  {
    found = shape->Fit.Poles[index];
  }
  pole[0] = found.b;
  std::copy(found.c.begin(), found.c.end(), pole + 1);
}

void vtkParticipatingMedium::GetPhasePower(double power[2])
{
  const auto shape = this->GetPhaseShape();
  power[0] = shape->Fit.Factor;
  power[1] = shape->Fit.Exponent;
}

//------------------------------------------------------------------------------
double vtkParticipatingMedium::EvaluatePhaseFunction(double cosTheta)
{
  if (std::isnan(cosTheta))
  {
    vtkErrorMacro("The cosine of the scattering angle is not a number.");
    return 0.0;
  }
  airlight::Change problem;
  const double value = this->Impl->Phase.Evaluate(cosTheta, problem.Error);
  this->Apply(problem);
  return value;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetMultipleScattering(bool on)
{
  if (this->MultipleScattering != on)
  {
    this->MultipleScattering = on;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::SourceFit> vtkParticipatingMedium::GetSourceFit(bool alone)
{
  if (!this->MultipleScattering)
  {
    return nullptr;
  }
  airlight::Change problem;
  std::shared_ptr<const airlight::SourceFit> fit;
  const bool layers = this->Density == EXPONENTIAL_HEIGHT && this->Region == UNBOUNDED;
  if (!alone || !(layers || (this->Density == UNIFORM && this->Region != SURFACE)))
  {
    if (this->MultipleProblemTime != this->GetMTime())
    {
      problem.Error =
        "Multiple scattering is left out, as it needs one medium alone: of uniform density, "
        "unbounded or in a box, sphere or cylinder, or unbounded and falling with height. See "
        "SetDensity() and SetRegion(). SetAmbientRadiance() approximates it.";
      this->MultipleProblemTime = this->GetMTime();
    }
  }
  else
  {
    // Objects and tables change by themselves.
    this->GetPhaseShape();
    double albedo[3]; // without the member that the other getter writes
    this->GetAlbedo(albedo);
    fit = this->Impl->Source.Update(
      glm::dvec3(albedo[0], albedo[1], albedo[2]), this->Impl->Phase.GetTime(),
      [this](double mu) { return this->EvaluatePhaseFunction(mu); }, problem.Error);
  }
  this->Apply(problem);
  return fit;
}

//------------------------------------------------------------------------------
double vtkParticipatingMedium::GetMultipleScatteringErrorBound()
{
  const std::shared_ptr<const airlight::SourceFit> fit = this->GetSourceFit();
  return fit ? fit->ErrorBound : 0.0;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetRegion(int type)
{
  if (airlight::GetRegionName(type).empty())
  {
    vtkErrorMacro(<< "Region " << type << " is not a region: use "
                  << airlight::ListRegionConstants() << ".");
    return;
  }
  this->RegionChosen = true;
  if (this->Region != type)
  {
    this->Region = type;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetBounds(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const double bounds[6] = { xmin, xmax, ymin, ymax, zmin, zmax };
  for (int i = 0; i < 6; i += 2)
  {
    if (!std::isfinite(bounds[i]) || !std::isfinite(bounds[i + 1]) || bounds[i] > bounds[i + 1])
    {
      vtkErrorMacro(<< "Bounds (" << xmin << ", " << xmax << ", " << ymin << ", " << ymax << ", "
                    << zmin << ", " << zmax
                    << ") must be finite, each minimum at most its maximum; the old ones stay.");
      return;
    }
  }
  if (!std::equal(bounds, bounds + 6, this->Bounds))
  {
    std::copy(bounds, bounds + 6, this->Bounds);
    this->Modified();
  }
}

void vtkParticipatingMedium::SetBounds(const double bounds[6])
{
  this->SetBounds(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetCenter(double x, double y, double z)
{
  this->SetVector("Center", this->Center, x, y, z);
}

void vtkParticipatingMedium::SetCenter(const double center[3])
{
  this->SetCenter(center[0], center[1], center[2]);
}

void vtkParticipatingMedium::SetRadius(double radius)
{
  this->SetNumber("Radius", this->Radius, radius, radius >= 0.0, "finite and at least 0");
}

void vtkParticipatingMedium::SetHeight(double height)
{
  this->SetNumber("Height", this->Height, height, height > 0.0, "finite and above 0");
}

void vtkParticipatingMedium::SetAxis(double x, double y, double z)
{
  this->SetDirection("Axis", this->Axis, x, y, z);
}

void vtkParticipatingMedium::SetAxis(const double axis[3])
{
  this->SetAxis(axis[0], axis[1], axis[2]);
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetSurface(vtkPolyData* surface)
{
  this->Apply(this->Impl->Surface.Set(surface));
  if (!this->RegionChosen)
  {
    this->Region = this->GetSurface() ? SURFACE : UNBOUNDED;
  }
}

vtkPolyData* vtkParticipatingMedium::GetSurface() { return this->Impl->Surface.Get(); }

std::shared_ptr<const airlight::SurfaceTree> vtkParticipatingMedium::GetSurfaceTree()
{
  if (this->Region != SURFACE)
  {
    return nullptr;
  }
  airlight::Change problem;
  const auto tree = this->Impl->Surface.Update(this->GetMTime(), problem.Error);
  this->Apply(problem);
  return tree;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetDensity(int type)
{
  if (type < UNIFORM || type > IMAGE)
  {
    vtkErrorMacro(<< "Density " << type
                  << " is not a density: use UNIFORM, EXPONENTIAL_HEIGHT or IMAGE.");
    return;
  }
  this->DensityChosen = true;
  if (this->Density != type)
  {
    this->Density = type;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetScaleHeight(double height)
{
  this->SetNumber("ScaleHeight", this->ScaleHeight, height, height > 0.0, "finite and above 0");
}

void vtkParticipatingMedium::SetReferenceHeight(double height)
{
  this->SetNumber("ReferenceHeight", this->ReferenceHeight, height, true, "finite");
}

void vtkParticipatingMedium::SetGround(bool on)
{
  if (this->Ground != on)
  {
    this->Ground = on;
    this->Modified();
  }
}

void vtkParticipatingMedium::SetGroundHeight(double height)
{
  this->SetNumber("GroundHeight", this->GroundHeight, height, true, "finite");
}

void vtkParticipatingMedium::SetGroundAlbedo(double r, double g, double b)
{
  for (const double share : { r, g, b })
  {
    if (!(share >= 0.0 && share <= 1.0))
    {
      vtkErrorMacro(<< "GroundAlbedo (" << r << ", " << g << ", " << b
                    << ") must be from 0 to 1; it stays (" << this->GroundAlbedo[0] << ", "
                    << this->GroundAlbedo[1] << ", " << this->GroundAlbedo[2] << ").");
      return;
    }
  }
  this->SetVector("GroundAlbedo", this->GroundAlbedo, r, g, b);
}

void vtkParticipatingMedium::SetGroundAlbedo(const double rgb[3])
{
  this->SetGroundAlbedo(rgb[0], rgb[1], rgb[2]);
}

void vtkParticipatingMedium::SetUp(double x, double y, double z)
{
  this->SetDirection("Up", this->Up, x, y, z);
}

void vtkParticipatingMedium::SetUp(const double up[3]) { this->SetUp(up[0], up[1], up[2]); }

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetDensityImage(vtkImageData* image)
{
  this->Apply(this->Impl->Image.Set(image));
  if (!this->DensityChosen)
  {
    this->Density = this->GetDensityImage() ? IMAGE : UNIFORM;
  }
}

vtkImageData* vtkParticipatingMedium::GetDensityImage() { return this->Impl->Image.Get(); }

std::shared_ptr<const airlight::DensityGrid> vtkParticipatingMedium::GetDensityGrid()
{
  if (this->Density != IMAGE)
  {
    return nullptr;
  }
  airlight::Change problem;
  const auto grid = this->Impl->Image.Update(this->GetMTime(), problem.Error);
  this->Apply(problem);
  return grid;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::ImageColours> vtkParticipatingMedium::GetAlbedoColours()
{
  return Internals::UpdateColours(this, this->Impl->Albedo, this->AlbedoArrayName, 1.0);
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::ImageColours> vtkParticipatingMedium::GetEmissionColours()
{
  return Internals::UpdateColours(this, this->Impl->EmissionFactors, this->EmissionArrayName, 1e10);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkParticipatingMedium::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Impl->Phase.GetMTime(),
    this->Impl->Surface.GetMTime(), this->Impl->Image.GetMTime() });
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
  print3("SkyRadiance", this->SkyRadiance);
  print3("GroundRadiance", this->GroundRadiance);
  os << indent << "SkyHarmonics:";
  for (const double coefficient : this->SkyHarmonics)
  {
    os << " " << coefficient;
  }
  os << "\n";
  print3("Emission", this->Emission);
  os << indent << "MultipleScattering: " << this->MultipleScattering << "\n";
  this->Impl->Phase.Print(os, indent);
  os << indent << "Region: " << airlight::GetRegionName(this->Region) << "\n";
  os << indent << "Bounds: (" << this->Bounds[0];
  for (int i = 1; i < 6; ++i)
  {
    os << ", " << this->Bounds[i];
  }
  os << ")\n";
  print3("Center", this->Center);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Height: " << this->Height << "\n";
  print3("Axis", this->Axis);
  os << indent << "Surface: " << this->GetSurface() << "\n";
  const char* densities[] = { "Uniform", "ExponentialHeight", "Image" };
  os << indent << "Density: " << densities[this->Density] << "\n";
  os << indent << "DensityImage: " << this->GetDensityImage() << "\n";
  os << indent << "AlbedoArrayName: " << this->AlbedoArrayName << "\n";
  os << indent << "EmissionArrayName: " << this->EmissionArrayName << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  os << indent << "ReferenceHeight: " << this->ReferenceHeight << "\n";
  os << indent << "Ground: " << (this->Ground ? "on" : "off") << "\n";
  os << indent << "GroundHeight: " << this->GroundHeight << "\n";
  os << indent << "GroundAlbedo: " << this->GroundAlbedo[0] << ", " << this->GroundAlbedo[1] << ", "
     << this->GroundAlbedo[2] << "\n";
  print3("Up", this->Up);
}
