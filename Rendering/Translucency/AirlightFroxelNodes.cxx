// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Translucency/AirlightFroxelNodes.h"

#include "AirlightFroxelAtlasFS.h"
#include "AirlightFroxelDepths.h"
#include "AirlightFroxelGrid.h"
#include "AirlightFroxelLookup.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightStorageBinding.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Numbers of a node, as AirlightFroxelGrid.glsl has them.
constexpr std::uint64_t LightNumbers = 7;
constexpr std::uint64_t LightSize = 4;
}

//------------------------------------------------------------------------------
FroxelNodes::FroxelNodes() = default;
FroxelNodes::~FroxelNodes() = default;

//------------------------------------------------------------------------------
std::string FroxelNodes::GetSource()
{
  return std::string(AirlightFroxelDepths) + AirlightFroxelGrid;
}

//------------------------------------------------------------------------------
std::string FroxelNodes::GetLookupSource()
{
  return std::string(AirlightFroxelDepths) + AirlightFroxelLookup;
}

//------------------------------------------------------------------------------
int FroxelNodes::Layout::GetLightCount() const
{
  return static_cast<int>(
    std::count_if(this->Lights.begin(), this->Lights.end(), [](int place) { return place >= 0; }));
}

//------------------------------------------------------------------------------
std::uint64_t FroxelNodes::GetBytes(const Layout& layout)
{
  return sizeof(float) * (LightNumbers + LightSize * layout.GetLightCount()) * layout.Columns *
    layout.Rows * layout.Nodes;
}

//------------------------------------------------------------------------------
bool FroxelNodes::IsPossible(
  vtkOpenGLRenderWindow* window, const Layout& layout, std::uint64_t memoryLimit)
{
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  // The texture takes about as much again.
  return GetBytes(layout) <= static_cast<std::uint64_t>(GetLargestStorageBlock()) &&
    2 * GetBytes(layout) <= memoryLimit && layout.Columns * (2 + layout.GetLightCount()) <= most &&
    layout.Rows * layout.Nodes <= most;
}

//------------------------------------------------------------------------------
bool FroxelNodes::Prepare(vtkOpenGLRenderWindow* window, const Layout& layout)
{
  this->Current = layout;
  const std::uint64_t bytes = GetBytes(layout);
  if (this->Buffer == 0)
  {
    glGenBuffers(1, &this->Buffer);
  }
  bool ok = this->Bytes == bytes ||
    AllocateStorageBlock(this->Buffer, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  this->Bytes = ok ? bytes : 0;
  const int width = layout.Columns * this->GetKindCount();
  const int height = layout.Rows * layout.Nodes;
  if (this->Texture->GetHandle() == 0)
  {
    this->Texture->SetContext(window);
    this->Texture->SetFormat(GL_RGBA);
    this->Texture->SetInternalFormat(GL_RGBA32F);
    this->Texture->SetDataType(GL_FLOAT);
    this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    ok = ok && this->Texture->Allocate2D(width, height, 4, VTK_FLOAT);
  }
  this->Texture->Resize(width, height);
  ok = ok && !IsOutOfMemory();
  if (!ok)
  {
    this->Error = "no memory on the graphics card for a coarse grid of the airlight: make the "
                  "window smaller, or call SetMaximumBoundariesPerPixel() with more";
    return false;
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Buffer);
  glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32I, GL_RED_INTEGER, GL_INT, nullptr);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return true;
}

//------------------------------------------------------------------------------
void FroxelNodes::SetDepths(vtkShaderProgram* program) const
{
  const float depths[2] = { static_cast<float>(this->Current.FirstDepth),
    static_cast<float>(this->Current.Step) };
  program->SetUniformi("airlightFroxelNodes", this->Current.Nodes);
  program->SetUniform2f("airlightFroxelDepths", depths);
}

//------------------------------------------------------------------------------
void FroxelNodes::Use(vtkShaderProgram* program, int light) const
{
  const Layout& layout = this->Current;
  this->SetDepths(program);
  program->SetUniformi("airlightFroxelColumns", layout.Columns);
  program->SetUniformi("airlightFroxelRows", layout.Rows);
  program->SetUniformi("airlightFroxelLight", light >= 0 ? layout.Lights[light] : -1);
  BindStorage(StorageBinding::FroxelNodes, this->Buffer);
}

//------------------------------------------------------------------------------
bool FroxelNodes::DrawTexture(vtkOpenGLRenderWindow* window, int firstKind, int kinds)
{
  vtkShaderProgram* program = this->TextureQuad.GetOrCompile(
    window, GetShaderVersion(true) + GetSource() + AirlightFroxelAtlasFS);
  if (!program)
  {
    this->Error = std::string("the shader of a coarse grid") + ProgramMaker::GetReason();
    return false;
  }
  this->Use(program);
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  const Layout& layout = this->Current;
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  this->TextureQuad.Draw({},
    { { firstKind * layout.Columns, 0, kinds * layout.Columns, layout.Rows * layout.Nodes } },
    state);
  return true;
}

//------------------------------------------------------------------------------
void FroxelNodes::UseTexture(vtkShaderProgram* program) const
{
  const Layout& layout = this->Current;
  const float tile[2] = { static_cast<float>(layout.Columns), static_cast<float>(layout.Rows) };
  const float texel[2] = { 1.0f / static_cast<float>(this->Texture->GetWidth()),
    1.0f / static_cast<float>(this->Texture->GetHeight()) };
  program->SetUniformi("airlightFroxels", this->Texture->GetTextureUnit());
  program->SetUniform2f("airlightFroxelTile", tile);
  program->SetUniform2f("airlightFroxelScale", &layout.PerPixel.x);
  program->SetUniform2f("airlightFroxelTexel", texel);
  this->SetDepths(program);
  if (program->IsUniformUsed("airlightFroxelLights"))
  {
    program->SetUniform1iv(
      "airlightFroxelLights", static_cast<int>(layout.Lights.size()), layout.Lights.data());
  }
}

//------------------------------------------------------------------------------
void FroxelNodes::Release(vtkWindow* window)
{
  this->TextureQuad.Release();
  DeleteBuffer(this->Buffer);
  this->Bytes = 0;
  this->Texture->ReleaseGraphicsResources(window);
}
}
