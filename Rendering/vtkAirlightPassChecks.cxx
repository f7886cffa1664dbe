// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightPass knows of lights, and what it says of media, lights and graphics cards that it
// cannot do.

#include "vtkAirlightPassInternals.h"

#include <algorithm>

using namespace airlight;

//------------------------------------------------------------------------------
LightOptions& vtkAirlightPass::Internals::GetOptions(vtkLight* light)
{
  auto& lights = this->Lights;
  lights.erase(std::remove_if(lights.begin(), lights.end(),
                 [](const LightOptions& options) { return !options.Light; }),
    lights.end());
  const auto it = std::find_if(lights.begin(), lights.end(),
    [light](const LightOptions& options) { return options.Light == light; });
  if (it != lights.end())
  {
    return *it;
  }
  lights.emplace_back();
  lights.back().Light = light;
  return lights.back();
}

//------------------------------------------------------------------------------
const LightOptions* vtkAirlightPass::Internals::FindOptions(vtkLight* light) const
{
  const auto it = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const LightOptions& options) { return options.Light == light; });
  return light && it != this->Lights.end() ? &*it : nullptr;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::WarnOnce(bool& warned, const std::string& text)
{
  if (!warned)
  {
    warned = true;
    vtkWarningWithObjectMacro(this->Self, << text);
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckMedia()
{
  const std::string text = this->Media.Check();
  if (!text.empty() && !this->WarnedMedia)
  {
    this->WarnedMedia = true;
    vtkErrorWithObjectMacro(this->Self, << text);
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckLamps(const std::vector<Lamp>& lamps)
{
  for (const Lamp& lamp : lamps)
  {
    if (lamp.Support == LightSupport::Invalid)
    {
      this->WarnOnce(this->WarnedLights, InvalidLampText);
    }
  }
  for (const Lamp& lamp : lamps)
  {
    const LightOptions* options = this->FindOptions(lamp.Light);
    if (options && options->Table && lamp.Scatters() && !lamp.Table)
    {
      this->WarnOnce(this->WarnedPhotometry,
        "A light's photometric file " + options->PhotometryFile +
          " is not used: it needs a positional light whose focal point, at which it aims, is apart "
          "from its position.");
    }
  }
  if (static_cast<int>(lamps.size()) > MaximumShadowingLights)
  {
    this->WarnOnce(this->WarnedLightCount,
      "There are " + std::to_string(lamps.size()) + " lights; those after the first " +
        std::to_string(MaximumShadowingLights) + " cast no shadows on surfaces.");
  }
  const auto glowing =
    std::count_if(lamps.begin(), lamps.end(), [](const Lamp& lamp) { return lamp.Glows(); });
  if (this->Self->ScatteredSurfaceLight && glowing > MaximumGlowLights)
  {
    this->WarnOnce(this->WarnedGlowCount,
      "The medium scatters " + std::to_string(glowing) + " lights; those after the first " +
        std::to_string(MaximumGlowLights) + " light surfaces directly only.");
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::CheckCasters()
{
  const CasterCache& casters = this->CurrentFrame.GetCasters();
  const std::string& error = casters.GetError();
  if (error != this->ReportedCasterError)
  {
    this->ReportedCasterError = error;
    if (!error.empty())
    {
      vtkErrorWithObjectMacro(this->Self, << error << ".");
    }
  }
  if (casters.MetTranslucent() && this->Self->TranslucentShadows &&
    (this->EffectiveTechnique == SHADOW_MAP || this->EffectiveTechnique == RAY_MARCH))
  {
    this->WarnOnce(this->WarnedTranslucent,
      "Shadow maps know of light and dark only: what lets light through casts no shadow in them. "
      "Call SetShadowTechniqueToShadowPlanes(), or SetTranslucentShadows(false) to cast none "
      "anyway.");
  }
}

//------------------------------------------------------------------------------
int vtkAirlightPass::Internals::ChooseTechnique(vtkOpenGLRenderWindow* window)
{
  const int technique = this->Self->ShadowTechnique;
  if (technique != SHADOW_PLANES && technique != AUTOMATIC)
  {
    return technique;
  }
  if (ShadowLists::IsSupported(window))
  {
    return SHADOW_PLANES;
  }
  const std::string text = "Shadow planes need OpenGL 4.3 with storage buffers, which this window "
                           "lacks: shadows come from "
                           "shadow maps, which are less exact. Update the graphics driver, or call "
                           "SetShadowTechniqueToShadowMap().";
  if (technique == SHADOW_PLANES && !this->WarnedOpenGL)
  {
    this->WarnedOpenGL = true;
    vtkErrorWithObjectMacro(this->Self, << text);
  }
  this->WarnOnce(this->WarnedOpenGL, text);
  return SHADOW_MAP;
}
