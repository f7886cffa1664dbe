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
  Colour = 1,
  Layer = 2 // as Colour, in front of the medium behind
};

// Lights whose shadows on surfaces can be told apart: 24 bits in each of four channels of single
// precision.
constexpr int BitsPerChannel = 24;
constexpr int MaximumShadowingLights = 4 * BitsPerChannel;

// Lights whose scattered light lights surfaces: uniforms are few.
constexpr int MaximumGlowLights = 32;

// What a mapper's fragment shader is rewritten for.
struct SurfaceText
{
  int LampCount = 4;        // at most
  int GlowLightCount = 0;   // at most; 0: surfaces get no scattered light
  bool Translucent = false; // fragments may be put behind the medium before them
  std::string Mathematics;  // GetScatteringSource() and, for scattered light, GetGlowSource()
};

// Rewrites a mapper's fragment shader. Every mention of a light's colour in main() is multiplied by
// what arrives of the light, which leaves the mapper's shading model, whatever it is, as it was.
// Scattered light is added to the diffuse part of the models that VTK has. Shaders without main()
// are left alone. Where fragments are put behind the medium, that is the last thing before VTK's
// marker for the passes of translucent surfaces.
void InjectSurfaceShader(std::string& fragmentShader, const SurfaceText& text);

// The state that the added text reads.
struct SurfaceUniforms
{
  SurfaceStage Stage = SurfaceStage::Distance;
  const View* Rays = nullptr;
  int X = 0; // lower left corner of the viewport in the target
  int Y = 0;
  const f64::AirlightMedia* Media = nullptr;
  const std::vector<Lamp>* Lamps = nullptr;
  vtkTextureObject* Lit = nullptr;  // an active texture in any case
  vtkTextureObject* Data = nullptr; // an active texture, or null where the shaders read none
  bool UseLit = false;              // false: all surfaces are lit
  bool Glow = false;                // the shaders were rewritten for scattered light
};

void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values);
}

#endif
