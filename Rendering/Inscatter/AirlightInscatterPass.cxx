// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightInscatterPass.h"

#include "Inscatter/AirlightLightShadows.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool InscatterPass::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
// Records of translucent fragments take the closed form. What is behind them does not, so that it
// is the same to the last bit with and without them.
bool InscatterPass::Draw(const FrameScene& scene, const InscatterOptions& options,
  const InscatterTargets& targets, LightShadows& shadows, int light)
{
  LightShadow& shadow = shadows.Get(scene, light);
  const InscatterShader shader(scene, options, shadows, shadow, light);
  const bool records = options.Records != nullptr;
  const bool counted = shader.IsEquiangular();
  bool failed = false;
  const auto draw = [&](const InscatterDraw& pixels) {
    const bool rest = pixels.Pixels == BoundaryPixels::LongRest;
    const bool done =
      ((counted && rest) || this->DrawPixels(scene, targets, shader, shadow, pixels, false)) &&
      (!records || !counted || this->DrawPixels(scene, targets, shader, shadow, pixels, true));
    failed = failed || !done;
    return done;
  };
  const bool ok = shadow.ForEachDraw(scene, light, targets, counted && !records, draw);
  return ok || (!failed && this->Fail(shadow.GetError()));
}

//------------------------------------------------------------------------------
Quad& InscatterPass::GetQuad(
  const LightShadow& shadow, const InscatterDraw& draw, bool fragmentsOnly)
{
  if (fragmentsOnly)
  {
    return this->Quads[4];
  }
  if (draw.Pixels == BoundaryPixels::All)
  {
    return this->Quads[shadow.HasShadow() ? 3 : 0];
  }
  return this->Quads[draw.Pixels == BoundaryPixels::Short ? 1 : 2];
}

//------------------------------------------------------------------------------
bool InscatterPass::DrawPixels(const FrameScene& scene, const InscatterTargets& targets,
  const InscatterShader& shader, LightShadow& shadow, const InscatterDraw& draw, bool fragmentsOnly)
{
  Quad& quad = this->GetQuad(shadow, draw, fragmentsOnly);
  vtkShaderProgram* program =
    quad.GetOrCompile(scene.Window, shader.GetSource(draw, fragmentsOnly));
  if (!program)
  {
    return this->Fail(std::string("the airlight shader") + ProgramMaker::GetReason());
  }
  const std::string reason = targets.Bind(targets.Scattered, nullptr);
  if (!reason.empty())
  {
    return this->Fail(reason);
  }
  shader.SetUniforms(program, draw, fragmentsOnly);

  vtkOpenGLState* state = scene.Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  if (fragmentsOnly)
  {
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, draw.Row, scene.Width, draw.Rows);
  LightShadow::Textures textures{ { "distances", targets.Distances },
    { "airlightData", scene.Data } };
  for (const auto& texture : shadow.GetTextures())
  {
    textures.emplace_back(texture.first, texture.second ? texture.second : targets.Distances);
  }
  quad.Draw(textures);
  state->vtkglScissor(0, 0, scene.Width, scene.Height);
  return true;
}

//------------------------------------------------------------------------------
void InscatterPass::Release()
{
  for (Quad& quad : this->Quads)
  {
    quad.Release();
  }
}
}
