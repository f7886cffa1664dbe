// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightQuad.h"

#include "AirlightFullScreenVS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace airlight
{
//------------------------------------------------------------------------------
vtkShaderProgram* Quad::GetOrCompile(
  vtkOpenGLRenderWindow* window, const std::string& fragmentSource)
{
  if (this->Program && this->Source == fragmentSource)
  {
    this->Program = window->GetShaderCache()->ReadyShaderProgram(this->Program);
  }
  else
  {
    this->Source = fragmentSource;
    std::string text = fragmentSource;
    this->Program = this->Programs.GetOrCompile(window, AirlightFullScreenVS, text);
  }
  return this->Program;
}

//------------------------------------------------------------------------------
void Quad::Draw(
  const Textures& textures, const std::vector<PixelArea>& areas, vtkOpenGLState* state)
{
  for (const auto& texture : textures)
  {
    if (!texture.second)
    {
      continue;
    }
    texture.second->Activate();
    this->Program->SetUniformi(texture.first, texture.second->GetTextureUnit());
  }
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  for (const PixelArea& area : areas)
  {
    state->vtkglScissor(area.X, area.Y, area.Width, area.Height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  if (!state)
  {
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glBindVertexArray(0);
  for (const auto& texture : textures)
  {
    if (texture.second)
    {
      texture.second->Deactivate();
    }
  }
}

//------------------------------------------------------------------------------
void Quad::DrawIntoViewport(vtkOpenGLState* state, const Textures& textures,
  const glm::ivec4& viewport, bool blend, bool masked)
{
  state->vtkglViewport(viewport.x, viewport.y, viewport.z, viewport.w);
  state->vtkglScissor(viewport.x, viewport.y, viewport.z, viewport.w);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(masked ? GL_LESS : GL_ALWAYS);
  state->vtkglDepthMask(masked ? GL_FALSE : GL_TRUE);
  if (masked)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_CONSTANT_ALPHA,
      GL_ONE_MINUS_CONSTANT_ALPHA);
  }
  else if (blend)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
  {
    state->vtkglDisable(GL_BLEND);
  }
  this->Draw(textures);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

//------------------------------------------------------------------------------
void Quad::DrawDepths(vtkOpenGLState* state, const Textures& textures)
{
  const vtkOpenGLState::ScopedglColorMask colorMask(state);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglEnable(GL_DEPTH_TEST);
  this->Draw(textures);
}

//------------------------------------------------------------------------------
// A quad's own depth becomes 0.
Quad::MaskedDraw::MaskedDraw(vtkOpenGLState* state, bool masked)
  : State(state)
  , Masked(masked)
{
  if (!masked)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
    return;
  }
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_FALSE);
  glGetFloatv(GL_DEPTH_RANGE, this->DepthRange);
  glDepthRange(0.0, 0.0);
}

Quad::MaskedDraw::~MaskedDraw()
{
  if (this->Masked)
  {
    this->State->vtkglDepthFunc(GL_LEQUAL);
    this->State->vtkglDepthMask(GL_TRUE);
    glDepthRange(this->DepthRange[0], this->DepthRange[1]);
  }
}

//------------------------------------------------------------------------------
void Quad::Release()
{
  DeleteVertexArray(this->VertexArray);
  this->Program = nullptr;
}
}
