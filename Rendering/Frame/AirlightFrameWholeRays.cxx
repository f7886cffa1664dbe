// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Airlight of lights without shadows, which is found where the picture is put together.

#include "Frame/AirlightFrame.h"

#include "AirlightWholeRays.h"
#include "Integration/AirlightIntegrate.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
std::vector<int> FindScattering(const std::vector<Lamp>& lamps)
{
  std::vector<int> found;
  for (size_t k = 0; k < lamps.size(); ++k)
  {
    if (lamps[k].Scatters())
    {
      found.push_back(static_cast<int>(k));
    }
  }
  return found;
}

//------------------------------------------------------------------------------
std::string Frame::GetWholeRaysSource(const std::vector<int>& lights) const
{
  if (!this->Plan.UnshadowedInComposite)
  {
    return "";
  }
  std::string lines;
  for (size_t i = 0; i < lights.size(); ++i)
  {
    lines +=
      " sum += airlightWholeRay(" + std::to_string(i) + ", p, origin, direction, unit, end);";
  }
  return "#define AIRLIGHT_WHOLE_LIGHTS " + std::to_string(std::max<size_t>(lights.size(), 1)) +
    "\n#define AIRLIGHT_EACH_LIGHT" + lines + "\n" + AirlightWholeRays;
}

//------------------------------------------------------------------------------
void Frame::SetWholeRaysUniforms(vtkShaderProgram* program, const std::vector<int>& lights)
{
  if (this->AreTurned(lights))
  {
    this->SetTurnedConstants(program, lights);
  }
  for (size_t i = 0; i < lights.size(); ++i)
  {
    const std::string index = "[" + std::to_string(i) + "]";
    const f64::AirlightLight& light = this->Lamps[lights[i]].Values;
    SetLightUniforms(program, "lights" + index, light);
    if (f64::airlightIsDirectional(light))
    {
      program->SetUniformi(("own" + index + ".HasPixel").c_str(), 0);
    }
    else
    {
      this->Rays->SetFootUniforms(program, light.position, "own" + index + ".");
    }
  }
}
}
