// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Point lights in one medium, uniform or fog that falls with height, whose airlight is integrated
 * by equiangular or by Gaussian quadrature in one loop: the shaders' text, and the numbers of
 * lights and medium that are the same for all pixels.
 */

#ifndef AirlightEquiangularLights_h
#define AirlightEquiangularLights_h

#include "Scene/AirlightFrameScene.h"

#include <string>
#include <vector>

class vtkShaderProgram;

namespace airlight
{
// Whether a light has the closed form, or would have it but for a power in the medium's phase
// function, a photometric table or density that falls with height, and an integrand that is as
// smooth as these make it.
bool IsEquiangular(const FrameScene& scene, int light);
bool AreEquiangular(const FrameScene& scene, const std::vector<int>& lights);

// The quadrature and what it takes. The media are a global variable: AIRLIGHT_OWN_MEDIA must be
// defined before GetScatteringSource().
std::string GetEquiangularSource(const FrameScene& scene);

// Whether the lights for which IsEquiangular() is true are in fog that falls with height. Of other
// lights it says nothing.
bool IsHeightFog(const FrameScene& scene);

// As glsl/AirlightConstants.glsl takes them.
void SetEquiangularConstants(
  vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights);
}

#endif
