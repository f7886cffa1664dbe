// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightMediumPhase.h"

#include "vtkParticipatingMedium.h"
#include "vtkTabulatedPhaseFunction.h"

#include <algorithm>
#include <sstream>

namespace airlight
{
namespace
{
using Medium = vtkParticipatingMedium;

// By vtkParticipatingMedium::PhaseFunctionType.
const char* const Names[] = { "Isotropic", "HenyeyGreenstein", "Rayleigh", "Schlick",
  "CornetteShanks", "MieHazy", "MieMurky", "Tabulated" };

template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}
}

//------------------------------------------------------------------------------
MediumPhase::MediumPhase() { this->Use(Medium::ISOTROPIC, nullptr); }

//------------------------------------------------------------------------------
// Takes the given object, or makes one.
void MediumPhase::Use(int type, vtkPhaseFunction* function)
{
  this->Type = type;
  this->Used = function;
  this->Shape = nullptr;
  if (!function)
  {
    this->Used.TakeReference(vtkPhaseFunction::NewByName(Names[type]));
  }
  if (this->HasAnisotropy())
  {
    this->Used->SetParameter(this->Used->GetParameterName(0), this->Anisotropy);
    this->AnisotropyUnused = false;
  }
  if (type == Medium::TABULATED)
  {
    vtkTabulatedPhaseFunction::SafeDownCast(this->Used)->UseTable(this->Table);
  }
}

//------------------------------------------------------------------------------
// Whether the medium's own anisotropy has an effect.
bool MediumPhase::HasAnisotropy() const
{
  return this->Type != Medium::OBJECT && this->Used->GetNumberOfParameters() > 0;
}

//------------------------------------------------------------------------------
Change MediumPhase::SetType(int type)
{
  if (type == Medium::OBJECT && this->Given)
  {
    return this->SetFunction(this->Given);
  }
  if (type < Medium::ISOTROPIC || type > Medium::TABULATED)
  {
    return { false,
      Text("PhaseFunction ", type, " is not a phase function: use ISOTROPIC (", Medium::ISOTROPIC,
        ") to TABULATED (", Medium::TABULATED, "), or a vtkPhaseFunction.") };
  }
  const bool changed = this->Type != type;
  if (changed)
  {
    this->Use(type, nullptr);
  }
  return { changed, "" };
}

//------------------------------------------------------------------------------
Change MediumPhase::SetFunction(vtkPhaseFunction* function)
{
  const bool used = this->Type == Medium::OBJECT;
  const bool changed = this->Given != function || (function && !used);
  this->Given = function;
  if (function && changed)
  {
    this->Use(Medium::OBJECT, function);
  }
  else if (!function && used)
  {
    this->Use(Medium::ISOTROPIC, nullptr);
  }
  return { changed, "" };
}

//------------------------------------------------------------------------------
Change MediumPhase::SetAnisotropy(double g)
{
  if (!(g >= -0.99 && g <= 0.99))
  {
    return { false,
      Text("Anisotropy ", g, " must lie in [-0.99, 0.99]; it stays ", this->Anisotropy, ".") };
  }
  const bool changed = this->Anisotropy != g;
  this->Anisotropy = g;
  this->AnisotropyUnused = g != 0.0 && !this->HasAnisotropy();
  if (this->HasAnisotropy() && changed)
  {
    this->Used->SetParameter(this->Used->GetParameterName(0), g);
  }
  if (changed)
  {
    this->Shape = nullptr;
  }
  return { changed, "" };
}

//------------------------------------------------------------------------------
Change MediumPhase::SetTable(vtkTable* table)
{
  if (this->Table == table)
  {
    return {};
  }
  std::string error;
  if (table && PhaseTable::Read(table, error).IsEmpty())
  {
    return { false, "PhaseTable " + error + ". The old table stays." };
  }
  this->Table = table;
  if (this->Type == Medium::TABULATED)
  {
    this->Use(Medium::TABULATED, nullptr);
  }
  return { true, "" };
}

//------------------------------------------------------------------------------
Change MediumPhase::SetTolerance(double tolerance)
{
  if (!(tolerance >= 1e-6 && tolerance <= 0.1))
  {
    return { false,
      Text("PhaseTolerance ", tolerance, " must lie in [1e-6, 0.1]; it stays ", this->Tolerance,
        ".") };
  }
  const bool changed = this->Tolerance != tolerance;
  this->Tolerance = tolerance;
  if (changed)
  {
    this->Shape = nullptr;
  }
  return { changed, "" };
}

//------------------------------------------------------------------------------
vtkMTimeType MediumPhase::GetMTime() const
{
  const vtkMTimeType object = this->Given ? this->Given->GetMTime() : 0;
  return this->Table ? std::max(object, this->Table->GetMTime()) : object;
}

//------------------------------------------------------------------------------
std::string MediumPhase::FindProblem() const
{
  std::string text;
  if (this->AnisotropyUnused)
  {
    text = Text("Anisotropy ", this->Anisotropy, " has no effect: the phase function is ",
      this->Used->GetName(),
      this->Type == Medium::OBJECT ? ", an object with its own parameters: set them there."
                                   : ", which has none. Choose HenyeyGreenstein, Schlick or "
                                     "CornetteShanks.");
  }
  std::string problem = this->Used->FindProblem();
  if (this->Type == Medium::TABULATED && !this->Table)
  {
    problem = "its table is missing: call SetPhaseTable()";
  }
  if (!problem.empty())
  {
    text += Text(text.empty() ? "" : " ", "The phase function is ", this->Used->GetName(), " and ",
      problem, ". Scattering is isotropic until it is fixed.");
  }
  return text;
}

//------------------------------------------------------------------------------
std::shared_ptr<const PhaseShape> MediumPhase::GetShape(std::string& error)
{
  const vtkMTimeType time = this->Used->GetMTime();
  if (!this->Shape || this->ShapeTime != time)
  {
    error = this->FindProblem();
    this->Shape = this->Used->GetShape(this->Tolerance);
    this->ShapeTime = time;
  }
  return this->Shape;
}

//------------------------------------------------------------------------------
double MediumPhase::Evaluate(double cosTheta, std::string& error)
{
  if (!this->Used->FindProblem().empty())
  {
    this->GetShape(error);
  }
  return this->Used->EvaluateHalfAngle(vtkPhaseFunction::GetHalfAngleTangent(cosTheta));
}

//------------------------------------------------------------------------------
void MediumPhase::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "PhaseFunction: " << this->Used->GetName() << "\n";
  os << indent << "PhaseFunctionObject: " << this->Given.Get() << "\n";
  if (this->Given)
  {
    this->Given->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "PhaseTable: " << this->Table.Get() << "\n";
  os << indent << "PhaseTolerance: " << this->Tolerance << "\n";
  os << indent << "PhaseErrorBound: ";
  if (this->Shape)
  {
    os << this->Shape->Fit.ErrorBound << " (" << this->Shape->Fit.Poles.size() << " poles)\n";
  }
  else
  {
    os << "(not fitted yet)\n";
  }
}
}
