// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AirlightEpipolarMap.h"

#include "AirlightEpipolarMapFS.h"
#include "AirlightMapLookup.h"
#include "AirlightSliceLayout.h"
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
bool EpipolarMap::Allocate(vtkOpenGLRenderWindow* window)
{
  bool ok = true;
  // Four columns a texel.
  const int width = this->Slices.GetColumns() / 4;
  const int height = this->Slices.GetRows();
  ForgetErrors();
  if (this->Texture->GetHandle() != 0)
  {
    this->Texture->Resize(width, height);
  }
  else
  {
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(GL_RGBA32F);
    this->Texture->SetDataType(GL_FLOAT);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    ok = this->Texture->Allocate2D(width, height, 4, VTK_FLOAT);
  }
  return (ok && !IsOutOfMemory()) ||
    this->Fail("no memory on the graphics card for the slices of a shadow map of " +
      std::to_string(width) + " x " + std::to_string(height) + " texels: lower SetNumberOfSteps()");
}

//------------------------------------------------------------------------------
bool EpipolarMap::Draw(vtkOpenGLRenderWindow* window, ShadowMap& map, const CameraUniforms& view,
  int columns, Quad& quad, const BindTarget& bind)
{
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  this->Slices = EpipolarSlices(map.GetProjection(), view, columns, std::min(MaximumRows, most));
  if (this->Slices.IsEmpty())
  {
    return true;
  }
  vtkShaderProgram* program = quad.GetOrCompile(window,
    GetShaderVersion(false) + AirlightMapLookup + AirlightSliceLayout + AirlightEpipolarMapFS);
  if (!program)
  {
    return this->Fail(
      std::string("the shader of a shadow map's slices") + ProgramMaker::GetReason());
  }
  if (!this->Allocate(window))
  {
    return false;
  }
  const std::string reason = bind(this->Texture);
  if (!reason.empty())
  {
    return this->Fail(reason);
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglViewport(0, 0, this->Slices.GetColumns() / 4, this->Slices.GetRows());
  map.GetProjection().SetUniforms(program, view);
  this->SetUniforms(program);
  quad.Draw({ { "shadowMap", map.GetTexture() } });
  return true;
}
}
