// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightSubpixelMean.h"

#include "AirlightAddFS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
glm::dvec2 SubpixelMean::GetOffset(int number, int count)
{
  const double goldenRatio = 0.5 * (1.0 + std::sqrt(5.0));
  const double x = 0.5 + static_cast<double>(number) / count;
  const double y = 0.5 + number / goldenRatio;
  return { x - std::floor(x) - 0.5, y - std::floor(y) - 0.5 };
}

//------------------------------------------------------------------------------
bool SubpixelMean::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool SubpixelMean::Begin(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Window = window;
  if (!this->Textures.Prepare(window, width, height, {}) ||
    !this->Textures.Bind({ this->Textures.Scattered }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Textures.Clear(0.0f);
  return true;
}

//------------------------------------------------------------------------------
bool SubpixelMean::BindFrame()
{
  if (!this->Textures.Bind({ this->Textures.Scene }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Textures.Clear(0.0f);
  this->Textures.ClearDepth();
  return true;
}

//------------------------------------------------------------------------------
bool SubpixelMean::AddFrame(float weight)
{
  vtkShaderProgram* program =
    this->AddQuad.GetOrCompile(this->Window, std::string("#version 330\n") + AirlightAddFS);
  if (!program)
  {
    return this->Fail(std::string("the shader that adds frames") + ProgramMaker::GetReason());
  }
  if (!this->Textures.Bind({ this->Textures.Scattered }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_CONSTANT_ALPHA, GL_ONE, GL_CONSTANT_ALPHA);
  glBlendColor(0.0f, 0.0f, 0.0f, 1.0f - weight);
  program->SetUniformf("weight", weight);
  this->AddQuad.Draw({ { "addedFrame", this->Textures.Scene } });
  glBlendColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

//------------------------------------------------------------------------------
bool SubpixelMean::DrawIntoViewport(
  const glm::ivec4& viewport, const DisplayStage& display, bool blend)
{
  // The mean has the caller's pixels.
  const MeanPicture::Mean mean{ this->Textures.Scattered, this->Textures.Depth, { 0, 0 } };
  return this->Picture.DrawIntoViewport(this->Window, mean, viewport, display, blend) ||
    this->Fail(MeanPicture::GetError());
}

//------------------------------------------------------------------------------
void SubpixelMean::Release(vtkWindow* window)
{
  this->AddQuad.Release();
  this->Picture.Release();
  this->Textures.Release(window);
}
}
