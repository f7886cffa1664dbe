// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the pass, and vtkAirlightPolyDataMapper without it, adds to the shaders of VTK's mappers:
 * the distance of each fragment, the attenuation and shadow of each light before the mapper's own
 * shading, and the medium before the fragment.
 */

#ifndef AirlightSurfaceShader_h
#define AirlightSurfaceShader_h

#include "MapperShaders/AirlightSpecialization.h"
#include "Scene/AirlightSceneLights.h"

#include "vtkAirlightModule.h" // for export macro

#include <string>
#include <vector>

namespace airlight
{
enum class SurfaceStage
{
  Distance = 0, // writes distances in place of colours
  Colour = 1,
  Translucent = 2, // as Colour, in front of the medium behind
  Collect = 3      // makes the records of what will be drawn so
};

// With which a shader of InjectSurfaceShader() is cut to a stage that does not shade. Shaders that
// cannot be, as they may discard fragments, do not have it.
inline std::string GetStageMacro(SurfaceStage stage)
{
  return stage == SurfaceStage::Collect ? "AIRLIGHT_COLLECT_PASS" : "AIRLIGHT_DEPTH_PRE_PASS";
}

// Lights whose shadows on surfaces can be kept apart: 24 bits in each of four channels of single
// precision.
constexpr int BitsPerChannel = 24;
constexpr int MaximumShadowingLights = 4 * BitsPerChannel;

// Lights whose scattered light lights surfaces: uniforms are few.
constexpr int MaximumScatteringLights = 32;

// The lights whose ways to opaque surfaces are known (AirlightLightWaysPass.h).
enum class KnownWays
{
  None = 0, // the shaders walk them
  Some = 1,
  All = 2
};

// What a mapper's shaders are rewritten for.
struct SurfaceShaderOptions
{
  int SceneLightCount = 4;                 // at most
  std::vector<LightSpecialization> Lights; // each light; empty where there are many
  int ScatteringLightCount = 0;            // at most; 0: surfaces get no scattered light
  bool MultipleScattering = false;         // surfaces get light that was scattered, however often
  bool Translucent = false;                // fragments may be put behind the medium before them
  bool TranslucentFragments = false;       // and have records (AirlightTranslucentFragments.h)
  bool Froxels = false;                    // or, as shadows do, read a grid (AirlightFroxels.h)
  bool Hides = false; // all fragments may be left out of a stage, as those of point Gaussians
  bool TransmitsShadows = false; // casters may let light through (AirlightShadowTransmittance.h)
  bool ReadsLit = true;          // on opaque surfaces, by bits of a texture
  KnownWays Ways = KnownWays::None;
  bool SingleGeometryPass = false; // colours and distances of opaque surfaces are drawn at once
  int ShadowingLight = -1;         // then: the light without which colours are drawn, too
  // The viewport is the target, and whether the projection is parallel is known when the shaders
  // are made.
  bool ViewportIsTarget = false;
  bool Parallel = false;
  bool InPass = true;          // there are the pass's stages and its shadows on surfaces
  bool AtVertices = false;     // the medium before fragments is interpolated between vertices
  bool UniformMedia = false;   // all media are unbounded and of one density
  bool CastingVolumes = false; // volumes take light away, too
  bool EncodedInput = false;   // the mappers' colours are encoded for display
  std::string
    Mathematics; // GetScatteringSource() and, for scattered light, GetScatteredIrradianceSource()
};

// Rewrites a mapper's fragment shader. Every mention of a light's colour in main() is multiplied by
// what arrives of the light, which leaves the mapper's shading model, whatever it is, as it was.
// Scattered light is added to the diffuse part of the models that VTK has. Shaders without main()
// are left alone. Where fragments are put behind the medium, that is the last thing before VTK's
// marker for the passes of translucent surfaces.
VTKAIRLIGHT_EXPORT void InjectSurfaceShader(
  std::string& fragmentShader, const SurfaceShaderOptions& text, bool pointGaussians = false);

// Gives the corners of point Gaussians back their depth in a geometry shader. From VTK 9.4 on it
// divides by w and goes on with w = 1, which leaves a fragment's place on the screen as it was, but
// not gl_FragCoord.w, of which the pass makes its distance.
void KeepSplatDepth(std::string& geometryShader);

// Rewrites a mapper's vertex shader for SurfaceShaderOptions::AtVertices.
void InjectVertexShader(std::string& vertexShader, const SurfaceShaderOptions& text);

// Brings the text up to date. It depends on the numbers of lights and media, and for scattered
// light and fragments behind the medium on the lights' kinds; numbers are uniforms. Whether it is
// another one now.
bool UpdateSurfaceShaderOptions(SurfaceShaderOptions& text, const f64::AirlightMedia& media,
  const std::vector<SceneLight>& sceneLights, bool scatteredLight, bool translucent);
}

#endif
