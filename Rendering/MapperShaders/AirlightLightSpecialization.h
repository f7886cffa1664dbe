// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the mappers' shaders know of the scene's lights when they are made, if these are few:
 * without it, software renderers run the code of every kind of light.
 */

#ifndef AirlightLightSpecialization_h
#define AirlightLightSpecialization_h

#include "Scene/AirlightSceneLights.h"

#include <cstddef>
#include <string>
#include <vector>

namespace airlight
{
// So many lights have lines of their own in the shaders; more share a loop.
constexpr size_t MaximumUnrolledLights = 4;

// Of so many the shaders know the types. Of sixteen, Mesa's compiler takes twice as long for what
// is then shorter.
constexpr size_t MaximumSpecializedLights = 8;

struct LightSpecialization
{
  bool Scatters = true;     // else as VTK shades it: without power, or refused
  bool Sun = false;         // at infinity, for the medium
  bool Goniometric = false; // shines by a photometric file
  // As VTK's shading has it.
  bool Positional = false;
  bool Spot = false;
  bool InverseSquare = false; // fades with the distance's square and nothing else
};
bool operator==(const LightSpecialization& a, const LightSpecialization& b);

// Each light; none where there are too many.
std::vector<LightSpecialization> SpecializeLights(const std::vector<SceneLight>& sceneLights);

// The macro with a line for each light, for AirlightSurface.glsl; empty if there is none.
// `shadowingLight`: SurfaceShaderOptions::ShadowingLight.
std::string DefineEachLight(const std::vector<LightSpecialization>& lights, int shadowingLight);

// VTK's lines that test uniforms for lights' types, with the lights' values in their place.
std::string SpecializeLightTypes(
  const std::string& body, const std::vector<LightSpecialization>& lights);
}

#endif
