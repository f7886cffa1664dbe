// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The medium before the scene: airlight + transmittance * scene. Into textures, where something is
 * drawn over the medium or buffers are recorded, or at once into the caller's framebuffer.
 */

#ifndef AirlightCompositePass_h
#define AirlightCompositePass_h

#include "Composite/AirlightDisplayStage.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightFrameScene.h"
#include "Scene/AirlightSunDiscs.h"

#include <string>
#include <utility>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;

namespace airlight
{
class CompositePass
{
public:
  struct Options
  {
    bool Unshadowed = false;  // the lights have no shadows in the medium and are integrated here
    bool Equiangular = false; // and by equiangular quadrature where they can be
    // The light without which the scene was drawn, too, -1 if there is none, and how many lights
    // have their bits in one channel.
    int ShadowingLight = -1;
    int LightsPerChannel = 24;
    int DebugView = 0; // vtkAirlightPass::DebugViewType
    bool Record = false;
    bool Several = false;      // record what is scattered more than once
    float DiffuseError = 0.0f; // of what is not scattered once, relative; recorded
    bool EncodedInput = false;
    std::vector<SunDisc> Suns; // that are seen where there is nothing else
    DisplayStage Display;      // into viewports only
    bool Chosen = false;       // pixels of depth 0 are left out, see PixelChoice
    bool Masked = false;       // the depth that is bound is a mask (Quad::MaskedDraw) and stays
  };

  // What earlier steps drew; null where they drew none.
  struct Inputs
  {
    vtkTextureObject* Distances = nullptr;
    vtkTextureObject* Depth = nullptr;
    vtkTextureObject* Scene = nullptr;
    vtkTextureObject* SceneWithoutLight = nullptr;
    vtkTextureObject* Scattered = nullptr; // the airlight of all lights, and bits of the first
    vtkTextureObject* MoreLit = nullptr;   // bits of the others
    vtkTextureObject* Counts = nullptr;    // where they are recorded
    vtkTextureObject* SeveralOfLights = nullptr; // likewise
  };

  // Into the textures that are bound: radiance, and where they are recorded airlight, surface,
  // transmittance and what is scattered more than once. False with a reason in GetError() where a
  // shader does not compile, here and below.
  bool DrawIntoTextures(const FrameScene& scene, const Options& options, const Inputs& inputs);

  // Into the framebuffer that is bound, with the viewport at x, y; `blend`: over what it holds.
  bool DrawIntoViewport(const FrameScene& scene, const Options& options, const Inputs& inputs,
    int x, int y, bool blend);

  // The same of a radiance that DrawIntoTextures() has made.
  bool CopyIntoViewport(const FrameScene& scene, const Options& options, const Inputs& inputs,
    vtkTextureObject* radiance, int x, int y, bool blend);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  using NamedTextures = std::vector<std::pair<const char*, vtkTextureObject*>>;

  bool Fail(const std::string& reason);
  vtkShaderProgram* GetProgram(
    Quad& quad, const FrameScene& scene, const Options& options, bool intoTextures, int x, int y);
  static NamedTextures GetTextures(
    const FrameScene& scene, const Options& options, const Inputs& inputs);

  Quad TextureQuad;
  Quad ViewportQuad;
  Quad CopyQuad;
  Quad MaskedQuad;
  Quad MaskedCopyQuad;
  std::string Error;
};
}

#endif
