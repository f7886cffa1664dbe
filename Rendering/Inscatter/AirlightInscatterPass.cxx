// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightInscatterPass.h"

#include "Inscatter/AirlightLightShadows.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace airlight
{
namespace
{
void DrawAdded(const FrameScene& scene, bool masked, Quad& quad,
  const LightShadow::Textures& textures, const std::vector<PixelArea>& areas)
{
  vtkOpenGLState* state = scene.Window->GetState();
  const Quad::MaskedDraw mask(state, masked);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  quad.Draw(textures, areas, state);
  state->vtkglScissor(0, 0, scene.Width, scene.Height);
}
}

//------------------------------------------------------------------------------
bool InscatterPass::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
// Records of translucent fragments take the closed form, or quadrature. If what is behind them
// takes equiangular quadrature, they have a draw of their own, so that it is the same to the last
// bit with and without them; else one draw does both.
bool InscatterPass::Draw(const FrameScene& scene, const InscatterOptions& options,
  const InscatterTargets& targets, LightShadows& shadows, int light)
{
  LightShadow& shadow = shadows.Get(scene, light);
  const InscatterShader shader(scene, options, shadows, shadow, light);
  const bool counted = shader.IsEquiangular();
  const std::vector<PixelArea> all{ { 0, 0, scene.Width, scene.Height } };
  const std::vector<PixelArea> none;
  const std::vector<PixelArea>& fragments =
    options.Records ? options.Records->GetAreas().Marked : none;
  const std::vector<PixelArea>& others =
    options.Records && !counted ? options.Records->GetAreas().Others : all;
  bool failed = false;
  const auto draw = [&](const InscatterDraw& pixels) {
    const bool rest = pixels.Pixels == BoundaryPixels::LongRest;
    const auto drawPart = [&](RayPart part, const std::vector<PixelArea>& areas) {
      return this->DrawPixels(
        scene, targets, shader, shadow, pixels, part, CutRows(areas, pixels.Row, pixels.Rows));
    };
    const bool done = ((counted && rest) || drawPart(RayPart::Surface, others)) &&
      drawPart(counted ? RayPart::Fragments : RayPart::Both, fragments);
    failed = failed || !done;
    return done;
  };
  const bool ok = shadow.ForEachDraw(scene, light, targets, counted && !options.Records, draw);
  return ok || (!failed && this->Fail(shadow.GetError()));
}

//------------------------------------------------------------------------------
Quad& InscatterPass::GetQuad(const LightShadow& shadow, const InscatterDraw& draw, RayPart part)
{
  const int pixels = draw.Pixels == BoundaryPixels::All ? (shadow.HasShadow() ? 3 : 0)
    : draw.Pixels == BoundaryPixels::Short              ? 1
                                                        : 2;
  return this->Quads[4 * static_cast<int>(part) + pixels];
}

//------------------------------------------------------------------------------
vtkShaderProgram* InscatterPass::Begin(
  const FrameScene& scene, const InscatterTargets& targets, Quad& quad, const std::string& source)
{
  vtkShaderProgram* program = quad.GetOrCompile(scene.Window, source);
  const std::string reason = program
    ? targets.Bind(targets.Scattered, targets.Mask)
    : std::string("the airlight shader") + ProgramMaker::GetReason();
  if (!reason.empty())
  {
    this->Fail(reason);
    return nullptr;
  }
  return program;
}

//------------------------------------------------------------------------------
bool InscatterPass::DrawPixels(const FrameScene& scene, const InscatterTargets& targets,
  const InscatterShader& shader, LightShadow& shadow, const InscatterDraw& draw, RayPart part,
  const std::vector<PixelArea>& areas)
{
  if (areas.empty())
  {
    return true;
  }
  Quad& quad = this->GetQuad(shadow, draw, part);
  vtkShaderProgram* program = this->Begin(scene, targets, quad, shader.GetSource(draw, part));
  if (!program)
  {
    return false;
  }
  shader.SetUniforms(program, draw, part);
  LightShadow::Textures textures{ { "distances", targets.Distances },
    { "airlightData", scene.Data }, { "airlightSamples", scene.Samples } };
  for (const auto& texture : shadow.GetTextures())
  {
    textures.emplace_back(texture.first, texture.second ? texture.second : targets.Distances);
  }
  vtkOpenGLState* state = scene.Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  if (part == RayPart::Fragments)
  {
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  DrawAdded(scene, targets.Mask != nullptr, quad, textures, areas);
  return true;
}

//------------------------------------------------------------------------------
bool InscatterPass::DrawUnshadowed(
  const FrameScene& scene, const InscatterTargets& targets, const std::vector<int>& lights)
{
  Quad& quad = this->Unshadowed[lights.size() - 1];
  vtkShaderProgram* program =
    this->Begin(scene, targets, quad, InscatterShader::GetUnshadowedSource(scene, lights));
  if (!program)
  {
    return false;
  }
  InscatterShader::SetUnshadowedUniforms(program, scene, lights);
  DrawAdded(scene, targets.Mask != nullptr, quad,
    { { "distances", targets.Distances }, { "airlightData", scene.Data },
      { "airlightSamples", scene.Samples } },
    { { 0, 0, scene.Width, scene.Height } });
  return true;
}

//------------------------------------------------------------------------------
void InscatterPass::Release()
{
  for (Quad& quad : this->Quads)
  {
    quad.Release();
  }
  for (Quad& quad : this->Unshadowed)
  {
    quad.Release();
  }
}
}
