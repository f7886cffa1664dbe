// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the pass, and vtkAirlightPolyDataMapper without it, adds to the shaders of VTK's mappers:
 * the distance of each fragment, the attenuation and shadow of each light before the mapper's own
 * shading, and the medium before the fragment.
 */

#ifndef AirlightSurfaceShader_h
#define AirlightSurfaceShader_h

#include "MapperShaders/AirlightLightSpecialization.h"
#include "Scene/AirlightLamps.h"

#include <string>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;

namespace airlight
{
class ShadowTransmittance;
class TranslucentFragments;
class CameraUniforms;

enum class SurfaceStage
{
  Distance = 0, // writes distances in place of colours
  Colour = 1,
  Translucent = 2, // as Colour, in front of the medium behind
  Collect = 3      // makes the records of what will be drawn so
};

// Lights whose shadows on surfaces can be told apart: 24 bits in each of four channels of single
// precision.
constexpr int BitsPerChannel = 24;
constexpr int MaximumShadowingLights = 4 * BitsPerChannel;

// Lights whose scattered light lights surfaces: uniforms are few.
constexpr int MaximumGlowLights = 32;

// What a mapper's shaders are rewritten for.
struct SurfaceShaderOptions
{
  int LampCount = 4;                       // at most
  std::vector<LightSpecialization> Lights; // each lamp; empty where there are many
  int GlowLightCount = 0;                  // at most; 0: surfaces get no scattered light
  bool Translucent = false;                // fragments may be put behind the medium before them
  bool TranslucentFragments = false;       // and have records (AirlightTranslucentFragments.h)
  bool Hides = false; // all fragments may be left out of a stage, as those of point Gaussians
  bool TransmitsShadows = false; // casters may let light through (AirlightShadowTransmittance.h)
  bool ReadsLit = true;          // on opaque surfaces, by bits of a texture
  bool Once = false;             // colours and distances of opaque surfaces are drawn at once
  int Apart = -1;                // then: the light without which colours are drawn, too
  // The viewport is the target, and whether the projection is parallel is known when the shaders are
  // made.
  bool KnownView = false;
  bool Parallel = false;
  bool InPass = true;        // there are the pass's stages and its shadows on surfaces
  bool AtVertices = false;   // the medium before fragments is interpolated between vertices
  bool UniformMedia = false; // all media are unbounded and of one density
  std::string Mathematics;   // GetScatteringSource() and, for scattered light, GetGlowSource()
};

// Rewrites a mapper's fragment shader. Every mention of a light's colour in main() is multiplied by
// what arrives of the light, which leaves the mapper's shading model, whatever it is, as it was.
// Scattered light is added to the diffuse part of the models that VTK has. Shaders without main()
// are left alone. Where fragments are put behind the medium, that is the last thing before VTK's
// marker for the passes of translucent surfaces.
void InjectSurfaceShader(
  std::string& fragmentShader, const SurfaceShaderOptions& text, bool pointGaussians = false);

// The declarations for a volume's fragment shader that come before `volume`, and that.
std::string GetVolumeDeclarations(const SurfaceShaderOptions& text, const std::string& volume);

// Asks for what the text needs, and for what it uses where there is such a thing.
void AddExtensions(std::string& shader, const SurfaceShaderOptions& text);

// Rewrites a mapper's vertex shader for SurfaceShaderOptions::AtVertices.
void InjectVertexShader(std::string& vertexShader, const SurfaceShaderOptions& text);

// Brings the text up to date. It depends on the numbers of lights and media, and for scattered
// light and fragments behind the medium on the lights' kinds; numbers are uniforms. Whether it is
// another one now.
bool UpdateSurfaceShaderOptions(SurfaceShaderOptions& text, const f64::AirlightMedia& media,
  const std::vector<Lamp>& lamps, bool glows, bool translucent);

// The state that the added text reads.
struct SurfaceUniforms
{
  SurfaceStage Stage = SurfaceStage::Distance;
  const CameraUniforms* Rays = nullptr;
  int ViewportX = 0; // lower left corner of the viewport in the target
  int ViewportY = 0;
  glm::vec4 Pixels{ 1.0f, 1.0f, 0.0f, 0.0f }; // of the target (CameraUniforms::SetUniforms())
  const f64::AirlightMedia* Media = nullptr;
  const std::vector<Lamp>* Lamps = nullptr;
  vtkTextureObject* Lit = nullptr;     // in the pass, an active texture in any case
  vtkTextureObject* MoreLit = nullptr; // likewise; the same where there are few lights
  vtkTextureObject* Data = nullptr;    // an active texture, or null where the shaders read none
  const TranslucentFragments* Records = nullptr; // null: there are none
  const ShadowTransmittance* Transmittances =
    nullptr;                 // what casters leave of lights on opaque surfaces
  bool EncodedInput = false; // the mappers' colours are encoded for display
  bool UseLit = false;       // false: all surfaces are lit
  bool Glow = false;         // the shaders were rewritten for scattered light
  bool Hides = false;        // the shader was rewritten to draw nothing on demand
  bool Hidden = false;       // now it does
  int Width = 0;             // of the viewport
  int Height = 0;
  int VolumeNodes = 2;   // on the rays through volumes
  bool Additive = false; // adds to what is behind, and the medium has done so already

  // Those that the shaders read: active while surfaces are drawn.
  std::vector<vtkTextureObject*> GetTextures() const;
};

void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values);
}

#endif
