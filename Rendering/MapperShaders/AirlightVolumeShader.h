// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the pass adds to the shaders of VTK's volume ray casting: each sample lit by what arrives of
 * the lights, and put behind the medium before it, before it is blended.
 */

#ifndef AirlightVolumeShader_h
#define AirlightVolumeShader_h

#include "MapperShaders/AirlightSurfaceUniforms.h"

#include "vtkAirlightModule.h" // for export macro

#include <cstdint>
#include <string>

class vtkShaderProgram;
class vtkVolume;

namespace airlight
{
// Records that a ray through a volume makes, at most (glsl/AirlightVolume.glsl).
constexpr int MinimumVolumeNodes = 2;
constexpr int MaximumVolumeNodes = 16;

// Marks places in the template of a volume's fragment shader, before VTK fills it in.
VTKAIRLIGHT_EXPORT void MarkVolumeShader(std::string& fragmentShader);

// Rewrites the shader that VTK has made of it. It is left alone where samples are not blended one
// by one over each other (projections: maximum, minimum, average, sum), and where it is not VTK's.
VTKAIRLIGHT_EXPORT void InjectVolumeShader(
  std::string& fragmentShader, const SurfaceShaderOptions& options);

// Whether a program has been rewritten so.
bool IsVolumeProgram(vtkShaderProgram* program);

// After SetSurfaceUniforms().
void SetVolumeUniforms(vtkShaderProgram* program, vtkVolume* volume, const SurfaceUniforms& values);

// How many nodes a ray gets, so that the records of this many volumes over all pixels fit into the
// memory limit; the fewest if there are none.
int GetVolumeNodeCount(size_t volumes, int width, int height, std::uint64_t memoryLimit);
}

#endif
