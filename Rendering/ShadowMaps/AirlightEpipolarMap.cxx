// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AirlightEpipolarMap.h"

#include "AirlightEpipolarMapFS.h"
#include "AirlightMapLookup.h"
#include "AirlightSliceLayout.h"
#include "AirlightSliceRangesFS.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Scene/AirlightCameraUniforms.h"
#include "ShadowMaps/AirlightShadowMap.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr int MaximumRows = 4096;
}

//------------------------------------------------------------------------------
bool EpipolarMap::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool EpipolarMap::Allocate(vtkOpenGLRenderWindow* window, const Target& target)
{
  bool ok = true;
  vtkTextureObject* texture = target.Texture;
  const int width = target.Width;
  const int height = std::max(this->Slices.GetRows(), 1);
  ForgetErrors();
  if (texture->GetHandle() != 0)
  {
    texture->Resize(width, height);
  }
  else
  {
    texture->SetContext(window);
    texture->SetInternalFormat(target.IsInteger ? GL_RGBA32UI : GL_RGBA32F);
    texture->SetFormat(target.IsInteger ? GL_RGBA_INTEGER : GL_RGBA);
    texture->SetDataType(target.IsInteger ? GL_UNSIGNED_INT : GL_FLOAT);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    ok = texture->Allocate2D(width, height, 4, target.IsInteger ? VTK_UNSIGNED_INT : VTK_FLOAT);
  }
  return (ok && !IsOutOfMemory()) ||
    this->Fail("no memory on the graphics card for the slices of a shadow map of " +
      std::to_string(width) + " x " + std::to_string(height) + " texels: lower SetNumberOfSteps()");
}

//------------------------------------------------------------------------------
bool EpipolarMap::Begin(vtkOpenGLRenderWindow* window, const Target& target, const BindTarget& bind)
{
  if (!this->Allocate(window, target))
  {
    return false;
  }
  const std::string reason = bind(target.Texture);
  if (!reason.empty())
  {
    return this->Fail(reason);
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglViewport(0, 0, target.Width, this->Slices.GetRows());
  return true;
}

//------------------------------------------------------------------------------
bool EpipolarMap::Draw(vtkOpenGLRenderWindow* window, ShadowMap& map, const CameraUniforms& view,
  int columns, Programs& programs, const BindTarget& bind)
{
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  this->Slices = EpipolarSlices(map.GetProjection(), view, columns, std::min(MaximumRows, most));
  if (this->Slices.IsEmpty())
  {
    // Shaders have samplers of them, though they do not read them.
    return this->Allocate(window, { this->Texture, 1, true }) &&
      this->Allocate(window, { this->Ranges, 1, false });
  }
  return this->DrawColumns(window, map, view, programs.Columns, bind) &&
    this->DrawRanges(window, programs.Ranges, bind);
}

//------------------------------------------------------------------------------
bool EpipolarMap::DrawColumns(vtkOpenGLRenderWindow* window, ShadowMap& map,
  const CameraUniforms& view, Quad& quad, const BindTarget& bind)
{
  vtkShaderProgram* program = quad.GetOrCompile(window,
    GetShaderVersion(false) + AirlightMapLookup + AirlightSliceLayout + AirlightEpipolarMapFS);
  if (!program)
  {
    return this->Fail(
      std::string("the shader of a shadow map's slices") + ProgramMaker::GetReason());
  }
  const int width = this->Slices.GetColumns() / EpipolarSlices::ColumnsPerTexel;
  if (!this->Begin(window, { this->Texture, width, true }, bind))
  {
    return false;
  }
  map.GetProjection().SetUniforms(program, view);
  this->SetUniforms(program);
  quad.Draw({ { "shadowMap", map.GetTexture() } });
  return true;
}

//------------------------------------------------------------------------------
bool EpipolarMap::DrawRanges(vtkOpenGLRenderWindow* window, Quad& quad, const BindTarget& bind)
{
  vtkShaderProgram* program = quad.GetOrCompile(
    window, GetShaderVersion(false) + AirlightSliceLayout + AirlightSliceRangesFS);
  if (!program)
  {
    return this->Fail(
      std::string("the shader of the ranges of a shadow map's slices") + ProgramMaker::GetReason());
  }
  const int words = this->Slices.GetColumns() / EpipolarSlices::Word;
  if (!this->Begin(window, { this->Ranges, (words + 1) / 2, false }, bind))
  {
    return false;
  }
  this->SetUniforms(program);
  quad.Draw({ { "slices", this->Texture } });
  return true;
}
}
