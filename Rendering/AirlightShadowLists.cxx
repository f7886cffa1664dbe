// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightShadowLists.h"

#include "AirlightBoundaries.h"
#include "AirlightOpenGL.h"
#include "AirlightPlanesFS.h"
#include "AirlightPlanesVS.h"
#include "AirlightView.h"
#include "AirlightViewShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr std::uint64_t NodeSize = 12;
// Room for a few boundaries on each pixel of a usual window.
std::uint32_t InitialCapacity = 1u << 21;

// Bindings of the shaders' buffers.
constexpr GLuint EdgeBinding = 0;
constexpr GLuint NodeBinding = 1;
constexpr GLuint HeadBinding = 2;
}

//------------------------------------------------------------------------------
ShadowLists::~ShadowLists() = default;

void ShadowLists::SetInitialCapacity(std::uint32_t capacity)
{
  InitialCapacity = std::max(capacity, 2u);
}

//------------------------------------------------------------------------------
bool ShadowLists::IsSupported(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  GLint vertexBlocks = 0;
  if (major > 4 || (major == 4 && minor >= 3))
  {
    glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &vertexBlocks);
  }
  return vertexBlocks > 0;
}

//------------------------------------------------------------------------------
std::string ShadowLists::GetBoundariesSource() { return AirlightBoundaries; }

//------------------------------------------------------------------------------
bool ShadowLists::Reserve(std::uint64_t boundaries)
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Nodes);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(boundaries * NodeSize), nullptr,
    GL_DYNAMIC_COPY);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  if (glGetError() != GL_NO_ERROR)
  {
    this->Capacity = 0;
    this->Error = "no memory for the lists of " + std::to_string(boundaries) + " boundaries";
    return false;
  }
  this->Capacity = static_cast<std::uint32_t>(boundaries);
  return true;
}

//------------------------------------------------------------------------------
bool ShadowLists::Prepare(
  vtkOpenGLRenderWindow* window, int width, int height, std::uint64_t memoryLimit)
{
  this->Window = window;
  this->Width = width;
  this->Height = height;
  this->MemoryLimit = memoryLimit;
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(1, &this->Nodes);
    glGenBuffers(1, &this->Heads);
  }
  const int heads = width * height + 1;
  if (this->HeadCount != heads)
  {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
    glBufferData(
      GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(heads) * 4, nullptr, GL_DYNAMIC_COPY);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    this->HeadCount = heads;
  }
  return this->Capacity > 0 ||
    this->Reserve(std::min<std::uint64_t>(InitialCapacity, memoryLimit / NodeSize));
}

//------------------------------------------------------------------------------
void ShadowLists::SetEdges(int slot, const std::vector<ShadowEdge>& edges)
{
  if (static_cast<size_t>(slot) >= this->Edges.size())
  {
    this->Edges.resize(slot + 1);
  }
  EdgeBuffer& buffer = this->Edges[slot];
  if (buffer.Handle == 0)
  {
    glGenBuffers(1, &buffer.Handle);
  }
  buffer.Count = static_cast<int>(edges.size());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.Handle);
  glBufferData(GL_SHADER_STORAGE_BUFFER,
    static_cast<GLsizeiptr>(std::max<size_t>(edges.size(), 1) * sizeof(ShadowEdge)),
    edges.empty() ? nullptr : edges.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
vtkShaderProgram* ShadowLists::ReadyProgram()
{
  const std::string fragment =
    std::string("#version 430\n") + AirlightViewShader + AirlightPlanesFS;
  vtkShaderProgram* program =
    this->Window->GetShaderCache()->ReadyShaderProgram(AirlightPlanesVS, fragment.c_str(), "");
  if (!program || !program->GetCompiled())
  {
    this->Error = program ? program->GetError() : "the shader cache returned no program";
    return nullptr;
  }
  return program;
}

//------------------------------------------------------------------------------
// Draws all planes, clipped to some rows, and returns how many boundaries there were.
std::uint32_t ShadowLists::DrawOnce(vtkShaderProgram* program, int edgeCount, int row, int rows)
{
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  this->Window->GetState()->vtkglScissor(0, row, this->Width, rows);
  // The program takes the capacity as an unsigned integer, which vtkShaderProgram cannot set.
  glUniform1ui(glGetUniformLocation(program->GetHandle(), "capacity"), this->Capacity);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, NodeBinding, this->Nodes);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, HeadBinding, this->Heads);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 6 * edgeCount);
  glBindVertexArray(0);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  GLuint count = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(count), &count);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return count;
}

//------------------------------------------------------------------------------
int ShadowLists::Fill(int slot, const ShadowVolumes& volumes, const glm::dvec4& light,
  const View& view, vtkTextureObject* distances, int row, int rows)
{
  vtkShaderProgram* program = this->ReadyProgram();
  if (!program)
  {
    return 0;
  }
  view.SetUniforms(program, 0, 0);
  glm::mat4 clip = view.GetClipMatrix(volumes.GetAnchor());
  const glm::vec3 anchor(volumes.GetAnchor() - view.GetEye());
  const glm::vec4 fromLight =
    light.w != 0.0 ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : glm::vec4(-glm::vec3(light), 0.0f);
  program->SetUniformMatrix4x4("anchorToClip", &clip[0][0]);
  program->SetUniform3f("anchor", &anchor.x);
  program->SetUniform4f("fromLight", &fromLight.x);
  program->SetUniformi("width", this->Width);
  distances->Activate();
  program->SetUniformi("distances", distances->GetTextureUnit());

  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_CLAMP);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2.0f, -8.0f);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EdgeBinding, this->Edges[slot].Handle);

  const std::uint64_t most =
    std::min<std::uint64_t>(this->MemoryLimit / NodeSize, 0x7fffffffu / 3u);
  while (rows > 0)
  {
    const std::uint64_t needed =
      static_cast<std::uint64_t>(this->DrawOnce(program, this->Edges[slot].Count, row, rows)) + 1;
    if (needed <= this->Capacity)
    {
      break;
    }
    // A quarter more than asked for, so that a scene in motion does not grow it each frame.
    if (needed <= most && this->Reserve(std::min(needed + needed / 4, most)))
    {
      continue;
    }
    if (this->Capacity == 0)
    {
      this->Reserve(std::min<std::uint64_t>(InitialCapacity, most));
    }
    this->Error = "one row of pixels crosses more shadow boundaries than the memory limit allows";
    rows = this->Capacity > 0 ? rows / 2 : 0;
  }

  glPolygonOffset(0.0f, 0.0f);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EdgeBinding, 0);
  state->vtkglDepthMask(GL_TRUE);
  distances->Deactivate();
  return rows;
}

//------------------------------------------------------------------------------
void ShadowLists::Use(vtkShaderProgram* program)
{
  program->SetUniformi("width", this->Width);
  glUniform1ui(glGetUniformLocation(program->GetHandle(), "capacity"), this->Capacity);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, NodeBinding, this->Nodes);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, HeadBinding, this->Heads);
}

//------------------------------------------------------------------------------
void ShadowLists::Release()
{
  if (this->VertexArray == 0)
  {
    return;
  }
  glDeleteVertexArrays(1, &this->VertexArray);
  glDeleteBuffers(1, &this->Nodes);
  glDeleteBuffers(1, &this->Heads);
  for (EdgeBuffer& buffer : this->Edges)
  {
    glDeleteBuffers(1, &buffer.Handle);
  }
  this->Edges.clear();
  this->VertexArray = this->Nodes = this->Heads = 0;
  this->Capacity = 0;
  this->HeadCount = 0;
}
}
