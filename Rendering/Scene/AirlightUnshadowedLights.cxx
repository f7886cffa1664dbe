// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightUnshadowedLights.h"

#include "AirlightUnshadowedRays.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightShaderLibrary.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
std::string GetUnshadowedSource(const FrameScene& scene, const std::vector<int>& lights)
{
  std::string lines;
  for (size_t i = 0; i < lights.size(); ++i)
  {
    lines +=
      " sum += airlightUnshadowedRay(" + std::to_string(i) + ", p, origin, direction, unit, end);";
    const int lamp = FindMultipleLamp(scene.Media, scene.Lights[lights[i]].Values);
    if (lamp >= 0)
    {
      lines += " sum += airlightMultipleAlong(media, " + std::to_string(lamp) +
        ", origin, direction, end).several;";
    }
  }
  return "#define AIRLIGHT_UNSHADOWED_LIGHTS " +
    std::to_string(std::max<size_t>(lights.size(), 1)) + "\n#define AIRLIGHT_EACH_LIGHT" + lines +
    "\n" + AirlightUnshadowedRays;
}

//------------------------------------------------------------------------------
void SetUnshadowedUniforms(
  vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights)
{
  for (size_t i = 0; i < lights.size(); ++i)
  {
    const std::string index = "[" + std::to_string(i) + "]";
    const f64::AirlightLight& light = scene.Lights[lights[i]].Values;
    SetLightUniforms(program, "lights" + index, light);
    SetLightPixelUniforms(program, "lightPixels" + index, scene.Rays, light);
  }
}
}
