// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the pass adds to the shaders of VTK's mappers: the distance of each fragment, and the
 * attenuation and shadow of each light before the mapper's own shading.
 */

#ifndef AirlightSurfaceShader_h
#define AirlightSurfaceShader_h

#include "AirlightLamps.h"

#include <string>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;

namespace airlight
{
class View;

enum class SurfaceStage
{
  Distance = 0, // writes distances in place of colours
  Colour = 1
};

// Lights whose shadows on surfaces can be told apart: 24 bits in each of four channels of single
// precision.
constexpr int BitsPerChannel = 24;
constexpr int MaximumShadowingLights = 4 * BitsPerChannel;

// Rewrites a mapper's fragment shader for up to `lampCount` lights; `mathematics` is the text of
// GetScatteringSource(). Every mention of a light's
// colour in main() is multiplied by what arrives of the light, which leaves the mapper's shading
// model, whatever it is, as it was. Shaders without main() are left alone.
void InjectSurfaceShader(
  std::string& fragmentShader, int lampCount, const std::string& mathematics);

// The state that the added text reads.
struct SurfaceUniforms
{
  SurfaceStage Stage = SurfaceStage::Distance;
  const View* Rays = nullptr;
  const f64::AirlightMedia* Media = nullptr;
  const std::vector<Lamp>* Lamps = nullptr;
  vtkTextureObject* Lit = nullptr;  // an active texture in any case
  vtkTextureObject* Data = nullptr; // an active texture, or null where the shaders read none
  bool UseLit = false;              // false: all surfaces are lit
};

void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values);
}

#endif
