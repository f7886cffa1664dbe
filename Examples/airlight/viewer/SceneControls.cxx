// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/SceneControls.h"

#include "commands/SceneOptions.h"
#include "viewer/LampMover.h"

#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace airlight
{

namespace
{
constexpr double VisibilityStep = 1.25;
constexpr double LampStep = 0.05; // of the picture's height
constexpr double PushStep = 1.1;

const std::array<int, 4> Techniques = { vtkAirlightPass::SHADOW_PLANES, vtkAirlightPass::SHADOW_MAP,
  vtkAirlightPass::RAY_MARCH, vtkAirlightPass::NONE };

const std::array<const char*, 4> ViewNames = { "picture", "airlight only", "boundary count",
  "outlines of shadows" }; // by vtkAirlightPass::DebugViewType

// Of an array, the value so many places behind this one, round and round.
template <typename Array>
int GetNext(const Array& values, int value, int step)
{
  const auto count = static_cast<int>(values.size());
  const auto place = std::find(values.begin(), values.end(), value) - values.begin();
  return values[static_cast<std::size_t>((place % count + step + count) % count)];
}
}

//------------------------------------------------------------------------------
SceneControls::SceneControls(const RenderedScene& rendered)
  : Rendered(rendered)
  , Levels(rendered, vtkAirlightPass::SafeDownCast(rendered.Renderer->GetPass()))
{
  this->StartCamera->DeepCopy(rendered.Renderer->GetActiveCamera());
}

//------------------------------------------------------------------------------
vtkLight* SceneControls::GetLamp() const
{
  return this->Rendered.Lights.empty() ? nullptr : this->Rendered.Lights[this->Lamp].Get();
}

//------------------------------------------------------------------------------
void SceneControls::ChooseLamp(int number)
{
  if (number >= 0 && static_cast<std::size_t>(number) < this->Rendered.Lights.size())
  {
    this->Lamp = static_cast<std::size_t>(number);
  }
}

//------------------------------------------------------------------------------
bool SceneControls::PressKey(const std::string& name)
{
  if (name == "r")
  {
    this->Rendered.Renderer->GetActiveCamera()->DeepCopy(this->StartCamera);
    return true;
  }
  if (name == "e")
  {
    return this->Levels.ResetExposure();
  }
  return this->ChangePass(name) || this->ChangeLamp(name);
}

//------------------------------------------------------------------------------
bool SceneControls::ChangePass(const std::string& name)
{
  if (!this->Rendered.Pass)
  {
    return false;
  }
  if (name == "t" || name == "T")
  {
    this->ChangeTechnique(name == "t" ? 1 : -1);
  }
  else if (name == "v" || name == "V")
  {
    this->ChangeView(name == "v" ? 1 : -1);
  }
  else if (name == "plus" || name == "minus")
  {
    this->ChangeVisibility(name == "plus" ? VisibilityStep : 1.0 / VisibilityStep);
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void SceneControls::NoteTechnique()
{
  if (this->Rendered.Pass)
  {
    this->Technique = this->Rendered.Pass->GetEffectiveShadowTechnique();
  }
}

//------------------------------------------------------------------------------
void SceneControls::ChangeTechnique(int step)
{
  this->Rendered.Pass->SetShadowTechnique(GetNext(Techniques, this->Technique, step));
}

//------------------------------------------------------------------------------
void SceneControls::ChangeView(int step)
{
  vtkAirlightPass* pass = this->Rendered.Pass;
  const int count = static_cast<int>(ViewNames.size());
  pass->SetDebugView((pass->GetDebugView() + step + count) % count);
}

//------------------------------------------------------------------------------
void SceneControls::ChangeVisibility(double factor)
{
  vtkParticipatingMedium* medium = this->Rendered.Pass->GetMedium(0);
  const double visibility = factor * medium->GetVisibility();
  if (visibility > 0.0 && std::isfinite(visibility)) // clear air stays clear
  {
    medium->SetVisibility(visibility);
  }
}

//------------------------------------------------------------------------------
bool SceneControls::ChangeLamp(const std::string& name)
{
  static const std::map<std::string, std::array<double, 2>> moves = { { "Left", { -1.0, 0.0 } },
    { "Right", { 1.0, 0.0 } }, { "Down", { 0.0, -1.0 } }, { "Up", { 0.0, 1.0 } } };
  vtkRenderer* renderer = this->Rendered.Renderer;
  vtkLight* lamp = this->GetLamp();
  if (!lamp)
  {
    return false;
  }
  const auto move = moves.find(name);
  if (move != moves.end())
  {
    MoveLamp(renderer, lamp, LampStep * move->second[0], LampStep * move->second[1]);
  }
  else if (name == "Prior" || name == "Next")
  {
    PushLamp(renderer, lamp, name == "Prior" ? PushStep : 1.0 / PushStep);
  }
  else if (name == "n")
  {
    this->Lamp = (this->Lamp + 1) % this->Rendered.Lights.size();
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void SceneControls::DragLamp(double right, double up)
{
  if (vtkLight* lamp = this->GetLamp())
  {
    const double height = this->Rendered.Renderer->GetSize()[1];
    MoveLamp(this->Rendered.Renderer, lamp, right / height, up / height);
  }
}

//------------------------------------------------------------------------------
std::string SceneControls::GetState() const
{
  std::ostringstream text;
  if (vtkAirlightPass* pass = this->Rendered.Pass)
  {
    text << "technique " << GetTechniqueName(this->Technique) << "\nview "
         << ViewNames[static_cast<std::size_t>(pass->GetDebugView())];
  }
  else
  {
    text << "no medium";
  }
  text << "\n" << this->GetLampText() << "\n" << this->Levels.GetText();
  return text.str();
}

//------------------------------------------------------------------------------
std::string SceneControls::GetLampText() const
{
  vtkLight* lamp = this->GetLamp();
  if (!lamp)
  {
    return "no lamp";
  }
  Vector3 place;
  std::copy_n(lamp->GetPosition(), 3, place.begin());
  if (!lamp->GetPositional()) // what counts is where it shines from
  {
    vtkMath::Subtract(place.data(), lamp->GetFocalPoint(), place.data());
  }
  std::ostringstream text;
  text << "lamp " << this->Lamp + 1 << " of " << this->Rendered.Lights.size()
       << (lamp->GetPositional() ? " at " : " from ") << place[0] << "," << place[1] << ","
       << place[2];
  return text.str();
}

}
