// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Several lights without shadows in the medium, integrated along whole rays by one shader. If all
 * lights of a frame are such, the composite does it, without a picture of their airlight, which
 * makes the frame a fifth shorter; else groups of them have one step in place of one each.
 */

#ifndef AirlightUnshadowedLights_h
#define AirlightUnshadowedLights_h

#include "Scene/AirlightFrameScene.h"

#include <string>
#include <vector>

class vtkShaderProgram;

namespace airlight
{
// More take a shader longer to compile than they save.
constexpr size_t MaximumUnshadowedLights = 4;

// The shaders' text for these lights, which are of one kind.
std::string GetUnshadowedSource(const FrameScene& scene, const std::vector<int>& lights);

void SetUnshadowedUniforms(
  vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights);
}

#endif
