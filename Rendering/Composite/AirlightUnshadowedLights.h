// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lights without shadows in the medium, which the composite integrates along whole rays: no step of
 * their own, and no picture of their airlight, which makes such a frame a fifth shorter.
 */

#ifndef AirlightUnshadowedLights_h
#define AirlightUnshadowedLights_h

#include "Scene/AirlightFrameScene.h"

#include <string>
#include <vector>

class vtkShaderProgram;

namespace airlight
{
// The shaders' text for these lights, which are of one kind.
std::string GetUnshadowedSource(const std::vector<int>& lights);

void SetUnshadowedUniforms(
  vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights);
}

#endif
