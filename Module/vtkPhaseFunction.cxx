// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPhaseFunction.h"

#include "AirlightPhaseFunctionClasses.h" // made from the list of classes
#include "Phase/AirlightPhaseShape.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
using Factory = vtkPhaseFunction* (*)();

template <typename Class>
vtkPhaseFunction* MakeNew()
{
  return Class::New();
}

// "HenyeyGreenstein" of vtkHenyeyGreensteinPhaseFunction.
std::string ShortName(const std::string& className)
{
  const std::string prefix = "vtk";
  const std::string suffix = "PhaseFunction";
  std::string name = className;
  if (name.rfind(prefix, 0) == 0)
  {
    name.erase(0, prefix.size());
  }
  const size_t end = name.rfind(suffix);
  return end != std::string::npos && end > 0 ? name.substr(0, end) : name;
}

struct ClassEntry
{
  const char* Name;
  Factory New;
};

#define AirlightClassEntry(Class) { #Class, &MakeNew<Class> },
const ClassEntry Classes[] = { AIRLIGHT_PHASE_CLASSES(AirlightClassEntry) };
#undef AirlightClassEntry
}

//------------------------------------------------------------------------------
vtkPhaseFunction::vtkPhaseFunction() = default;

vtkPhaseFunction::~vtkPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkPhaseFunction::Evaluate(double cosTheta)
{
  if (std::isnan(cosTheta))
  {
    vtkErrorMacro("The cosine of the scattering angle is not a number.");
    return 0.0;
  }
  if (this->ProblemTime != this->GetMTime())
  {
    this->ProblemTime = this->GetMTime();
    const std::string problem = this->FindProblem();
    if (!problem.empty())
    {
      vtkErrorMacro(<< "The phase function is isotropic: " << problem << ".");
    }
  }
  return this->EvaluateHalfAngle(GetHalfAngleTangent(cosTheta));
}

double vtkPhaseFunction::GetHalfAngleTangent(double cosTheta)
{
  const double mu = std::clamp(cosTheta, -1.0, 1.0);
  return mu > -1.0 ? std::sqrt((1.0 - mu) / (1.0 + mu)) : 1e150;
}

//------------------------------------------------------------------------------
std::string vtkPhaseFunction::GetName() { return ShortName(this->GetClassName()); }

//------------------------------------------------------------------------------
void vtkPhaseFunction::AddParameter(const char* name, double minimum, double maximum, double value)
{
  this->Parameters.push_back({ name, { minimum, maximum }, value });
}

//------------------------------------------------------------------------------
int vtkPhaseFunction::GetNumberOfParameters() { return static_cast<int>(this->Parameters.size()); }

bool vtkPhaseFunction::HasParameterAt(int index)
{
  if (index < 0 || index >= this->GetNumberOfParameters())
  {
    vtkErrorMacro(<< "Parameter " << index << " does not exist: there are "
                  << this->GetNumberOfParameters() << ".");
    return false;
  }
  return true;
}

std::string vtkPhaseFunction::GetParameterName(int index)
{
  return this->HasParameterAt(index) ? this->Parameters[index].Name : "";
}

void vtkPhaseFunction::GetParameterRange(int index, double range[2])
{
  range[0] = 0.0;
  range[1] = 0.0;
  if (this->HasParameterAt(index))
  {
    std::copy_n(this->Parameters[index].Range, 2, range);
  }
}

//------------------------------------------------------------------------------
vtkPhaseFunction::Parameter* vtkPhaseFunction::FindParameter(const std::string& name)
{
  std::string names;
  for (Parameter& parameter : this->Parameters)
  {
    if (name == parameter.Name)
    {
      return &parameter;
    }
    names += (names.empty() ? "" : ", ") + parameter.Name;
  }
  vtkErrorMacro(<< "Parameter \"" << name << "\" does not exist: "
                << (names.empty() ? "there are none." : "use one of " + names + "."));
  return nullptr;
}

void vtkPhaseFunction::SetParameter(const std::string& name, double value)
{
  if (const Parameter* parameter = this->FindParameter(name))
  {
    this->SetParameterAt(parameter - this->Parameters.data(), name.c_str(), value);
  }
}

double vtkPhaseFunction::GetParameter(const std::string& name)
{
  const Parameter* parameter = this->FindParameter(name);
  return parameter ? parameter->Value : 0.0;
}

//------------------------------------------------------------------------------
void vtkPhaseFunction::SetParameterAt(size_t index, const char* property, double value)
{
  Parameter& parameter = this->Parameters[index];
  if (!(value >= parameter.Range[0] && value <= parameter.Range[1]))
  {
    vtkErrorMacro(<< property << " " << value << " must lie in [" << parameter.Range[0] << ", "
                  << parameter.Range[1] << "]; it stays " << parameter.Value << ".");
    return;
  }
  if (parameter.Value != value)
  {
    parameter.Value = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkPhaseFunction::GetNumberOfClasses() { return static_cast<int>(std::size(Classes)); }

std::string vtkPhaseFunction::GetNameOfClass(int index)
{
  if (index < 0 || index >= GetNumberOfClasses())
  {
    vtkGenericWarningMacro(<< "Phase function " << index << " does not exist: there are "
                           << GetNumberOfClasses() << ".");
    return "";
  }
  return ShortName(Classes[index].Name);
}

vtkPhaseFunction* vtkPhaseFunction::NewByName(const std::string& name)
{
  std::string names;
  for (const ClassEntry& entry : Classes)
  {
    if (name == ShortName(entry.Name))
    {
      return entry.New();
    }
    names += (names.empty() ? "" : ", ") + ShortName(entry.Name);
  }
  vtkGenericWarningMacro(<< "There is no phase function \"" << name << "\": use one of " << names
                         << ".");
  return nullptr;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkPhaseFunction::GetShape(double tolerance)
{
  const vtkMTimeType time = this->GetMTime();
  if (!this->Shape || this->ShapeTime != time || this->ShapeTolerance != tolerance)
  {
    this->Shape = this->MakeShape(tolerance);
    this->ShapeTime = time;
    this->ShapeTolerance = tolerance;
  }
  return this->Shape;
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkPhaseFunction::MakeShape(double tolerance)
{
  const airlight::PhaseFunction function = [this](double s) { return this->EvaluateHalfAngle(s); };
  return airlight::MakePhaseShape(
    airlight::FitFunction(function, tolerance, AIRLIGHT_MAX_POLES), function, tolerance);
}

//------------------------------------------------------------------------------
void vtkPhaseFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetName() << "\n";
  for (const Parameter& parameter : this->Parameters)
  {
    os << indent << parameter.Name << ": " << parameter.Value << "\n";
  }
}
