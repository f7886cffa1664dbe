// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/SceneLevels.h"

#include <vtkCamera.h>
#include <vtkParticipatingMedium.h>
#include <vtkPhaseFunction.h>

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace airlight
{

namespace
{
constexpr double VisibilityRange = 30.0; // the factor up and down
constexpr double ExposureStops = 6.0;    // up and down

std::string GetNumberText(const char* name, double value, int digits)
{
  std::ostringstream text;
  text << name << " " << std::setprecision(digits) << value;
  return text.str();
}

// The medium's function as an object, but for isotropic media Henyey and Greenstein's. Null for
// those that the medium knows by number and that have no parameter.
vtkSmartPointer<vtkPhaseFunction> FindPhaseFunction(vtkParticipatingMedium* medium)
{
  static const std::map<int, const char*> names = { { vtkParticipatingMedium::ISOTROPIC,
                                                      "HenyeyGreenstein" },
    { vtkParticipatingMedium::HENYEY_GREENSTEIN, "HenyeyGreenstein" },
    { vtkParticipatingMedium::SCHLICK, "Schlick" },
    { vtkParticipatingMedium::CORNETTE_SHANKS, "CornetteShanks" } };
  int type = medium->GetPhaseFunction();
  vtkPhaseFunction* object = medium->GetPhaseFunctionObject();
  if (type == vtkParticipatingMedium::OBJECT && object)
  {
    if (!object->IsA("vtkIsotropicPhaseFunction"))
    {
      return object;
    }
    type = vtkParticipatingMedium::ISOTROPIC;
  }
  const auto name = names.find(type);
  if (name == names.end())
  {
    return nullptr;
  }
  auto function =
    vtkSmartPointer<vtkPhaseFunction>::Take(vtkPhaseFunction::NewByName(name->second));
  function->SetParameter(function->GetParameterName(0), medium->GetAnisotropy());
  return function;
}

// Which of a function's parameters is its anisotropy, or -1.
int FindAnisotropy(vtkPhaseFunction* function)
{
  for (int i = 0; i < function->GetNumberOfParameters(); ++i)
  {
    const std::string name = function->GetParameterName(i);
    if (name == "g" || name == "k")
    {
      return i;
    }
  }
  return -1;
}
}

//------------------------------------------------------------------------------
SceneLevels::SceneLevels(const RenderedScene& rendered, vtkAirlightPass* pass)
  : Pass(pass)
  , Brightness(rendered.Brightness)
{
  if (rendered.Pass)
  {
    this->Medium = rendered.Pass->GetMedium(0);
    this->AddVisibility(rendered.Renderer->GetActiveCamera()->GetDistance());
    this->AddAnisotropy();
  }
  if (pass)
  {
    this->AddExposure();
  }
}

//------------------------------------------------------------------------------
void SceneLevels::AddVisibility(double distance)
{
  const double visibility = this->Medium->GetVisibility();
  const bool clear = !std::isfinite(visibility);
  const double middle = std::log10(clear ? VisibilityRange * distance : visibility);
  Level level;
  level.Minimum = middle - std::log10(VisibilityRange);
  level.Maximum = middle + std::log10(VisibilityRange);
  level.Get = [this] { return std::log10(this->Medium->GetVisibility()); };
  level.Set = [this, end = clear ? level.Maximum : VTK_DOUBLE_MAX](double value) {
    if (value < end)
    {
      this->Medium->SetVisibility(std::pow(10.0, value));
      return;
    }
    this->Medium->SetScattering(0.0, 0.0, 0.0);
    this->Medium->SetAbsorption(0.0, 0.0, 0.0);
  };
  level.GetText = [this](int digits) {
    return GetNumberText("visibility", this->Medium->GetVisibility(), digits);
  };
  this->Levels.push_back(level);
}

//------------------------------------------------------------------------------
void SceneLevels::AddAnisotropy()
{
  const vtkSmartPointer<vtkPhaseFunction> function = FindPhaseFunction(this->Medium);
  const int index = function ? FindAnisotropy(function) : -1;
  if (index < 0)
  {
    return;
  }
  const std::string name = function->GetParameterName(index);
  double range[2];
  function->GetParameterRange(index, range);
  Level level;
  level.Minimum = range[0];
  level.Maximum = range[1];
  level.Get = [function, name] { return function->GetParameter(name); };
  level.Set = [this, function, name](double value) {
    function->SetParameter(name, value);
    this->Medium->SetPhaseFunction(function);
  };
  level.GetText = [function, name](int digits) {
    return GetNumberText("anisotropy", function->GetParameter(name), digits);
  };
  this->Levels.push_back(level);
}

//------------------------------------------------------------------------------
void SceneLevels::AddExposure()
{
  this->BaseExposure = this->Pass->GetExposure();
  Level level;
  level.Minimum = -ExposureStops;
  level.Maximum = ExposureStops;
  level.Get = [this] {
    return this->Pass->GetAutomaticExposure()
      ? 0.0
      : std::log2(this->Pass->GetExposure() / this->BaseExposure);
  };
  level.Set = [this](double value) { this->SetExposure(value); };
  level.GetText = [this](int digits) {
    return this->Pass->GetAutomaticExposure()
      ? GetNumberText("exposure", this->Pass->GetEffectiveExposure(), digits) + " auto"
      : GetNumberText("exposure", this->Pass->GetExposure(), digits);
  };
  this->Levels.push_back(level);
}

//------------------------------------------------------------------------------
void SceneLevels::SetExposure(double stops)
{
  if (this->Pass->GetAutomaticExposure())
  {
    this->BaseExposure = this->Pass->GetEffectiveExposure();
    this->Pass->AutomaticExposureOff();
  }
  this->Pass->SetExposure(this->BaseExposure * std::exp2(stops));
}

//------------------------------------------------------------------------------
bool SceneLevels::ResetExposure()
{
  if (!this->Pass)
  {
    return false;
  }
  this->Pass->SetExposure(this->Brightness);
  this->Pass->AutomaticExposureOn();
  return true;
}

//------------------------------------------------------------------------------
std::string SceneLevels::GetText() const
{
  std::string text;
  for (const Level& level : this->Levels)
  {
    text += (text.empty() ? "" : "\n") + level.GetText(6);
  }
  return text;
}

}
