// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Composite/AirlightCompositePass.h"

#include "AirlightCameraShader.h"
#include "AirlightCompositeFS.h"
#include "AirlightCopyFS.h"
#include "AirlightDecode.h"
#include "AirlightLightPixel.h"
#include "AirlightShadowingLight.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightShaderLibrary.h"
#include "Scene/AirlightEquiangularLights.h"
#include "Scene/AirlightUnshadowedLights.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Ambient light, emission. What was scattered more than once is a part of the lights' own, but for
// that of collisions.
bool HasDiffuse(const f64::AirlightMedia& media) { return Shines(media) || HasCollisions(media); }

// The shader's text. `lights`: those that it integrates.
std::string GetSource(const FrameScene& scene, const CompositePass::Options& options,
  const std::vector<int>& lights, bool equiangular, bool intoTextures)
{
  const int kind =
    lights.empty() || equiangular ? AIRLIGHT_POINT_CLOSED : scene.Lights[lights[0]].Values.kind;
  const bool cones = std::any_of(
    lights.begin(), lights.end(), [&](int k) { return scene.Lights[k].Values.cosCone > 0.0; });
  return GetShaderVersion(false) + (cones ? "" : "#define AIRLIGHT_NO_CONE\n") +
    Define("AIRLIGHT_EQUIANGULAR", equiangular) +
    (equiangular ? "#define AIRLIGHT_OWN_MEDIA\n" : "") +
    (intoTextures ? "#define AIRLIGHT_TRANSLUCENT\n" : "") +
    (intoTextures && options.Record ? "#define AIRLIGHT_RECORD\n" : "") +
    Define("AIRLIGHT_RECORD_SEVERAL", intoTextures && options.Several) +
    Define("AIRLIGHT_MASKED", options.Masked) +
    Define("AIRLIGHT_CHOSEN", options.Chosen && !intoTextures) +
    Define("AIRLIGHT_DEBUG_VIEW", intoTextures ? 0 : options.DebugView) +
    Define("AIRLIGHT_SHADOWING_LIGHT", options.ShadowingLight) +
    Define("AIRLIGHT_BITS", options.LightsPerChannel) +
    Define("AIRLIGHT_DIFFUSE", HasDiffuse(scene.Media)) +
    Define("AIRLIGHT_ENCODED_INPUT", options.EncodedInput) +
    Define("AIRLIGHT_PARALLEL", scene.Rays.IsParallel()) + "#define AIRLIGHT_FULL_SCREEN\n" +
    GetScatteringSource(scene.Media, kind, false) + AirlightCameraShader + AirlightLightPixel +
    (equiangular ? GetEquiangularSource(scene) : "") +
    (options.Unshadowed ? GetUnshadowedSource(scene, lights) : "") +
    (options.ShadowingLight >= 0 ? AirlightShadowingLight : "") + AirlightDecode +
    GetSunSource(options.Suns) + (intoTextures ? "" : options.Display.GetSource()) +
    AirlightCompositeFS;
}
}

//------------------------------------------------------------------------------
bool CompositePass::Fail(const std::string& reason)
{
  this->Error = reason + ProgramMaker::GetReason();
  return false;
}

//------------------------------------------------------------------------------
vtkShaderProgram* CompositePass::GetProgram(
  Quad& quad, const FrameScene& scene, const Options& options, bool intoTextures, int x, int y)
{
  const std::vector<int> lights =
    options.Unshadowed ? FindScattering(scene.Lights) : std::vector<int>();
  const bool equiangular = options.Equiangular && AreEquiangular(scene, lights);
  vtkShaderProgram* program =
    quad.GetOrCompile(scene.Window, GetSource(scene, options, lights, equiangular, intoTextures));
  if (!program)
  {
    this->Fail("the composite shader");
    return nullptr;
  }
  if (equiangular)
  {
    SetEquiangularConstants(program, scene, lights);
  }
  SetUnshadowedUniforms(program, scene, lights);
  SetSunUniforms(program, options.Suns);
  SetMediaUniforms(program, equiangular ? "givenMedia" : "airlightMedia", scene.Media,
    options.Unshadowed || HasDiffuse(scene.Media));
  // Where the target's viewport does not begin at 0, gl_FragCoord does not either.
  scene.Rays.SetUniforms(program, x, y);
  if (intoTextures && options.Record)
  {
    program->SetUniformf("error", options.DiffuseError);
  }
  return program;
}

//------------------------------------------------------------------------------
CompositePass::NamedTextures CompositePass::GetTextures(
  const FrameScene& scene, const Options& options, const Inputs& inputs)
{
  NamedTextures textures = { { "distances", inputs.Distances }, { "scene", inputs.Scene },
    { "airlightData", scene.Data }, { "airlightSamples", scene.Samples } };
  if (!options.Unshadowed)
  {
    textures.emplace_back("scattered", inputs.Scattered);
  }
  if (options.ShadowingLight >= 0)
  {
    textures.emplace_back("withoutLight", inputs.SceneWithoutLight);
    if (options.ShadowingLight >= options.LightsPerChannel)
    {
      textures.emplace_back("lit", inputs.MoreLit);
    }
  }
  if (options.Record)
  {
    textures.emplace_back("counts", inputs.Counts);
  }
  if (options.Several)
  {
    textures.emplace_back("severalOfLights", inputs.SeveralOfLights);
  }
  return textures;
}

//------------------------------------------------------------------------------
bool CompositePass::DrawIntoTextures(
  const FrameScene& scene, const Options& options, const Inputs& inputs)
{
  vtkOpenGLState* state = scene.Window->GetState();
  state->vtkglDisable(GL_BLEND);
  const Quad::MaskedDraw mask(state, options.Masked);
  if (!this->GetProgram(this->TextureQuad, scene, options, true, 0, 0))
  {
    return false;
  }
  this->TextureQuad.Draw(GetTextures(scene, options, inputs));
  return true;
}

//------------------------------------------------------------------------------
bool CompositePass::DrawIntoViewport(
  const FrameScene& scene, const Options& options, const Inputs& inputs, int x, int y, bool blend)
{
  Quad& quad = options.Masked ? this->MaskedQuad : this->ViewportQuad;
  vtkShaderProgram* program = this->GetProgram(quad, scene, options, false, x, y);
  if (!program)
  {
    return false;
  }
  program->SetUniformi("blended", blend ? 1 : 0);
  options.Display.SetUniforms(program);
  NamedTextures textures = GetTextures(scene, options, inputs);
  textures.emplace_back("sceneDepth", inputs.Depth);
  quad.DrawIntoViewport(
    scene.Window->GetState(), textures, { x, y, scene.Width, scene.Height }, blend, options.Masked);
  return true;
}

//------------------------------------------------------------------------------
bool CompositePass::CopyIntoViewport(const FrameScene& scene, const Options& options,
  const Inputs& inputs, vtkTextureObject* radiance, int x, int y, bool blend)
{
  Quad& quad = options.Masked ? this->MaskedCopyQuad : this->CopyQuad;
  vtkShaderProgram* program = quad.GetOrCompile(scene.Window,
    "#version 330\n" + Define("AIRLIGHT_MASKED", options.Masked) + Define("AIRLIGHT_MEAN", false) +
      options.Display.GetSource() + AirlightCopyFS);
  if (!program)
  {
    return this->Fail("the shader of the last step");
  }
  const int corner[2] = { x, y };
  program->SetUniform2i("airlightViewport", corner);
  options.Display.SetUniforms(program);
  program->SetUniformi("blended", blend ? 1 : 0);
  quad.DrawIntoViewport(scene.Window->GetState(),
    { { "radiances", radiance }, { "sceneDepth", inputs.Depth }, { "scene", inputs.Scene } },
    { x, y, scene.Width, scene.Height }, blend, options.Masked);
  return true;
}

//------------------------------------------------------------------------------
void CompositePass::Release()
{
  this->MaskedQuad.Release();
  this->MaskedCopyQuad.Release();
  this->TextureQuad.Release();
  this->ViewportQuad.Release();
  this->CopyQuad.Release();
}
}
