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
void Quad::DrawIntoViewport(
  vtkOpenGLState* state, const Textures& textures, const glm::ivec4& viewport, bool blend)
{
  state->vtkglViewport(viewport.x, viewport.y, viewport.z, viewport.w);
  state->vtkglScissor(viewport.x, viewport.y, viewport.z, viewport.w);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  if (blend)
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
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

//------------------------------------------------------------------------------
void Quad::Release()
{
  DeleteVertexArray(this->VertexArray);
  this->Program = nullptr;
}
}
