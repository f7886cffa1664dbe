// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// The medium's phase function and its fit; the rest of the class is in vtkParticipatingMedium.cxx.
#include "vtkParticipatingMedium.h"

#include "Integration/AirlightMath.h"
#include "Phase/AirlightPhaseFit.h"
#include "Phase/AirlightPhaseFunctions.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int HazyExponent = 8;
constexpr int MurkyExponent = 32;

const char* const Names[] = { "Isotropic", "HenyeyGreenstein", "Rayleigh", "Schlick",
  "CornetteShanks", "MieHazy", "MieMurky", "Tabulated" };

bool HasAnisotropy(int type)
{
  return type == vtkParticipatingMedium::HENYEY_GREENSTEIN ||
    type == vtkParticipatingMedium::SCHLICK || type == vtkParticipatingMedium::CORNETTE_SHANKS;
}

airlight::PhaseFit Fit(int type, double g, const airlight::PhaseTable& table, double tolerance)
{
  switch (type)
  {
    case vtkParticipatingMedium::HENYEY_GREENSTEIN:
      return airlight::FitHenyeyGreenstein(g, tolerance, AIRLIGHT_MAX_POLES);
    case vtkParticipatingMedium::RAYLEIGH:
      return airlight::ExactRayleigh();
    case vtkParticipatingMedium::SCHLICK:
      return airlight::ExactSchlick(g);
    case vtkParticipatingMedium::CORNETTE_SHANKS:
      return airlight::FitCornetteShanks(g, tolerance, AIRLIGHT_MAX_POLES);
    case vtkParticipatingMedium::MIE_HAZY:
      return airlight::ExactMie(HazyExponent);
    case vtkParticipatingMedium::MIE_MURKY:
      return airlight::ExactMie(MurkyExponent);
    case vtkParticipatingMedium::TABULATED:
      return table.IsEmpty() ? airlight::ExactIsotropic()
                             : airlight::FitTable(table, tolerance, AIRLIGHT_MAX_POLES);
    default:
      return airlight::ExactIsotropic();
  }
}
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetPhaseFunction(int type)
{
  if (type < ISOTROPIC || type > TABULATED)
  {
    vtkErrorMacro(<< "PhaseFunction " << type << " is not a phase function: use ISOTROPIC ("
                  << ISOTROPIC << ") to TABULATED (" << TABULATED << ").");
    return;
  }
  this->PhaseFunctionChosen = true;
  this->AnisotropyUnused = false;
  if (this->PhaseFunction != type)
  {
    this->PhaseFunction = type;
    this->Phase = nullptr;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetAnisotropy(double g)
{
  if (!(g >= -0.99 && g <= 0.99))
  {
    vtkErrorMacro(<< "Anisotropy " << g << " must lie in [-0.99, 0.99]; it stays "
                  << this->Anisotropy << ".");
    return;
  }
  const bool unused = g != 0.0 && !HasAnisotropy(this->PhaseFunction);
  if (unused && this->PhaseFunctionChosen)
  {
    vtkErrorMacro(<< "Anisotropy " << g << " means nothing to the phase function "
                  << Names[this->PhaseFunction]
                  << ", which has none: choose HenyeyGreenstein, Schlick or CornetteShanks first. "
                     "It stays "
                  << this->Anisotropy << ".");
    return;
  }
  this->AnisotropyUnused = unused;
  if (this->Anisotropy != g)
  {
    this->Anisotropy = g;
    this->Phase = nullptr;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetPhaseTable(vtkTable* table)
{
  if (this->PhaseTable == table)
  {
    return;
  }
  std::string error;
  if (table && airlight::PhaseTable::Read(table, error).IsEmpty())
  {
    vtkErrorMacro(<< "PhaseTable " << error << ". The old table stays.");
    return;
  }
  this->PhaseTable = table;
  this->Phase = nullptr;
  this->Modified();
}

vtkTable* vtkParticipatingMedium::GetPhaseTable() { return this->PhaseTable; }

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetPhaseTolerance(double tolerance)
{
  if (!(tolerance >= 1e-6 && tolerance <= 0.1))
  {
    vtkErrorMacro(<< "PhaseTolerance " << tolerance << " must lie in [1e-6, 0.1]; it stays "
                  << this->PhaseTolerance << ".");
    return;
  }
  if (this->PhaseTolerance != tolerance)
  {
    this->PhaseTolerance = tolerance;
    this->Phase = nullptr;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// What a table says may have changed since it was set.
airlight::PhaseTable vtkParticipatingMedium::ReadPhaseTable()
{
  std::string error;
  airlight::PhaseTable table;
  if (this->PhaseFunction == TABULATED)
  {
    table = airlight::PhaseTable::Read(this->PhaseTable, error);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< "The phase function is Tabulated and its table "
                  << (this->PhaseTable ? error : "is missing: call SetPhaseTable()")
                  << ". Scattering is isotropic until it is mended.");
  }
  return table;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkParticipatingMedium::GetPhaseShape()
{
  const vtkMTimeType time =
    this->PhaseFunction == TABULATED && this->PhaseTable ? this->PhaseTable->GetMTime() : 0;
  if (this->Phase && this->PhaseTime == time)
  {
    return this->Phase;
  }
  if (this->AnisotropyUnused)
  {
    vtkErrorMacro(<< "Anisotropy " << this->Anisotropy
                  << " has no effect: the phase function is Isotropic, which has none. Choose "
                     "HenyeyGreenstein, Schlick or CornetteShanks.");
  }
  *this->PhaseTableRead = this->ReadPhaseTable();
  const airlight::PhaseTable& table = *this->PhaseTableRead;
  auto shape = std::make_shared<airlight::PhaseShape>();
  shape->Fit = Fit(this->PhaseFunction, this->Anisotropy, table, this->PhaseTolerance);
  const bool follows = shape->Fit.ErrorBound <= this->PhaseTolerance &&
    airlight::HasClosedForm(airlight::Convert(shape->Fit));
  if (!table.IsEmpty() && !follows)
  {
    shape->Fit = airlight::PhaseFit();
    shape->Rows = table.GetRows();
  }
  this->Phase = shape;
  this->PhaseTime = time;
  return this->Phase;
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
  const double mu = std::clamp(cosTheta, -1.0, 1.0);
  const double s = mu > -1.0 ? std::sqrt((1.0 - mu) / (1.0 + mu)) : 1e150;
  switch (this->PhaseFunction)
  {
    case HENYEY_GREENSTEIN:
      return airlight::HenyeyGreenstein(this->Anisotropy, s);
    case RAYLEIGH:
      return airlight::Rayleigh(s);
    case SCHLICK:
      return airlight::Schlick(this->Anisotropy, s);
    case CORNETTE_SHANKS:
      return airlight::CornetteShanks(this->Anisotropy, s);
    case MIE_HAZY:
      return airlight::Mie(HazyExponent, s);
    case MIE_MURKY:
      return airlight::Mie(MurkyExponent, s);
    case TABULATED:
      this->GetPhaseShape();
      return this->PhaseTableRead->IsEmpty() ? 0.25 / M_PI : this->PhaseTableRead->Evaluate(s);
    default:
      return 0.25 / M_PI;
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::PrintPhase(ostream& os, vtkIndent indent)
{
  os << indent << "PhaseFunction: " << Names[this->PhaseFunction] << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "PhaseTable: " << this->PhaseTable.Get() << "\n";
  os << indent << "PhaseTolerance: " << this->PhaseTolerance << "\n";
  os << indent << "PhaseErrorBound: ";
  if (this->Phase)
  {
    os << this->Phase->Fit.ErrorBound << " (" << this->Phase->Fit.Poles.size() << " poles)\n";
  }
  else
  {
    os << "(not fitted yet)\n";
  }
}
