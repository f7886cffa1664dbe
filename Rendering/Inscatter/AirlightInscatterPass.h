// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The airlight of one light, with its shadow: adds the light that the medium scatters towards the
 * eye before the opaque surfaces, and to translucent fragments, into the targets.
 */

#ifndef AirlightInscatterPass_h
#define AirlightInscatterPass_h

#include "Inscatter/AirlightInscatterShader.h"
#include "Inscatter/AirlightLightShadow.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightFrameScene.h"
#include "Scene/AirlightUnshadowedLights.h"

#include <array>
#include <string>

namespace airlight
{
class LightShadows;

class InscatterPass
{
public:
  // False with a reason in GetError() where OpenGL refuses.
  bool Draw(const FrameScene& scene, const InscatterOptions& options,
    const InscatterTargets& targets, LightShadows& shadows, int light);

  // The airlight of some lights without shadows, at most MaximumUnshadowedLights, for which
  // AreEquiangular(). Neither records nor buffers get it.
  bool DrawUnshadowed(
    const FrameScene& scene, const InscatterTargets& targets, const std::vector<int>& lights);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  bool Fail(const std::string& reason);

  // The program of a quad that draws into the targets, which are bound; null where that fails.
  vtkShaderProgram* Begin(const FrameScene& scene, const InscatterTargets& targets, Quad& quad,
    const std::string& source);
  bool DrawPixels(const FrameScene& scene, const InscatterTargets& targets,
    const InscatterShader& shader, LightShadow& shadow, const InscatterDraw& draw, RayPart part,
    const std::vector<PixelArea>& areas);
  Quad& GetQuad(const LightShadow& shadow, const InscatterDraw& draw, RayPart part);

  // A program each, as they follow one another within a frame: without shadows, few and many
  // boundaries, from a map; for each part of rays.
  std::array<Quad, 12> Quads;
  std::array<Quad, MaximumUnshadowedLights> Unshadowed; // by the number of lights, less one
  std::string Error;
};
}

#endif
