// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightShadowLists.h"

#include "AirlightBoundaries.h"
#include "AirlightOpenGL.h"
#include "AirlightOutlineFS.h"
#include "AirlightPlanesFS.h"
#include "AirlightPlanesVS.h"
#include "AirlightSortFS.h"
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
constexpr std::uint64_t PlainNodeWords = 3;
constexpr std::uint64_t DimmedNodeWords = 6;
// Room for a few boundaries on each pixel of a usual window.
constexpr std::uint64_t InitialCapacity = 1u << 21;
// Lists up to this length are sorted where they are read.
constexpr std::uint32_t ShortList = 64;
// Boundaries of a longer list that one draw reads.
constexpr std::uint32_t Chunk = 128;
// The heads begin with the counter of boundaries and the longest list's length.
constexpr int HeadOffset = 2;

// Bindings of the shaders' buffers.
constexpr GLuint EdgeBinding = 0;
constexpr GLuint NodeBinding = 1;
constexpr GLuint HeadBinding = 2;
constexpr GLuint LayerBinding = 6;

std::string DefineLengths()
{
  return "#define AIRLIGHT_SHORT_LIST " + std::to_string(ShortList) + "\n#define AIRLIGHT_CHUNK " +
    std::to_string(Chunk) + "\n";
}
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
std::uint64_t ShadowLists::GetNodeSize() const
{
  return 4 * (this->Dimmed ? DimmedNodeWords : PlainNodeWords);
}

//------------------------------------------------------------------------------
std::string ShadowLists::DefineNodes(bool dimmed)
{
  return "#define AIRLIGHT_DIMMED " + std::to_string(dimmed) + "\n#define AIRLIGHT_NODE_WORDS " +
    std::to_string(dimmed ? DimmedNodeWords : PlainNodeWords) + "u\n";
}

//------------------------------------------------------------------------------
// The buffer keeps its bytes.
void ShadowLists::SetDimmed(bool dimmed)
{
  const std::uint64_t bytes = this->Capacity * this->GetNodeSize();
  this->Dimmed = dimmed;
  this->Capacity = static_cast<std::uint32_t>(bytes / this->GetNodeSize());
}

//------------------------------------------------------------------------------
std::string ShadowLists::GetBoundariesSource(bool sorted) const
{
  return DefineLengths() + (sorted ? "#define AIRLIGHT_SORTED\n" : "") + AirlightBoundaries;
}

//------------------------------------------------------------------------------
bool ShadowLists::Reserve(std::uint64_t boundaries)
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Nodes);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(boundaries * this->GetNodeSize()),
    nullptr, GL_DYNAMIC_COPY);
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
  vtkOpenGLRenderWindow* window, int width, int height, std::uint64_t memoryLimit, bool budgeted)
{
  this->Window = window;
  this->Width = width;
  this->Height = height;
  this->MemoryLimit = memoryLimit;
  this->Budgeted = budgeted;
  this->OverBudget = false;
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(1, &this->Nodes);
    glGenBuffers(1, &this->Heads);
  }
  const int heads = width * height + HeadOffset;
  if (this->HeadCount != heads)
  {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
    glBufferData(
      GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(heads) * 4, nullptr, GL_DYNAMIC_COPY);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    this->HeadCount = heads;
  }
  const bool fits = this->Capacity > 0 && this->Capacity * this->GetNodeSize() <= memoryLimit;
  return fits || this->Reserve(std::min(InitialCapacity, memoryLimit / this->GetNodeSize()));
}

//------------------------------------------------------------------------------
void ShadowLists::Upload(Buffer& buffer, const void* data, size_t count, size_t size)
{
  if (buffer.Handle == 0)
  {
    glGenBuffers(1, &buffer.Handle);
  }
  buffer.Count = static_cast<int>(count);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.Handle);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(std::max<size_t>(count, 1) * size),
    count > 0 ? data : nullptr, GL_STATIC_DRAW);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void ShadowLists::UploadLayers(Buffer& buffer, const std::vector<ShadowLayer>& layers)
{
  std::vector<glm::ivec4> values;
  for (const ShadowLayer& layer : layers)
  {
    const int channels = layer.Blocks.r + 2 * layer.Blocks.g + 4 * layer.Blocks.b;
    values.emplace_back(layer.Thickness, channels);
  }
  this->Upload(buffer, values.data(), values.size(), sizeof(glm::ivec4));
}

//------------------------------------------------------------------------------
void ShadowLists::SetVolumes(int slot, const ShadowVolumes& volumes)
{
  if (static_cast<size_t>(slot) >= this->Edges.size())
  {
    this->Edges.resize(slot + 1);
    this->NearEdges.resize(slot + 1);
    this->Caps.resize(slot + 1);
    this->Layers.resize(slot + 1);
  }
  const auto upload = [this](Buffer& buffer, const auto& records) {
    this->Upload(buffer, records.data(), records.size(), sizeof(records[0]));
  };
  upload(this->Edges[slot], volumes.GetEdges());
  upload(this->NearEdges[slot], volumes.GetNearEdges());
  upload(this->Caps[slot], volumes.GetCaps());
  this->UploadLayers(this->Layers[slot], volumes.GetLayers());
}

//------------------------------------------------------------------------------
vtkShaderProgram* ShadowLists::ReadyPlanes(const std::string& fragment,
  const ShadowVolumes& volumes, const glm::dvec4& light, const View& view)
{
  const std::string source = "#version 430\n" + fragment;
  vtkShaderProgram* program =
    this->Window->GetShaderCache()->ReadyShaderProgram(AirlightPlanesVS, source.c_str(), "");
  if (!program || !program->GetCompiled())
  {
    this->Error = program ? program->GetError() : "the shader cache returned no program";
    return nullptr;
  }
  view.SetUniforms(program, 0, 0);
  glm::mat4 clip = view.GetClipMatrix(volumes.GetAnchor());
  const glm::vec3 anchor(volumes.GetAnchor() - view.GetEye());
  const glm::vec4 fromLight =
    light.w != 0.0 ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : glm::vec4(-glm::vec3(light), 0.0f);
  program->SetUniformMatrix4x4("anchorToClip", &clip[0][0]);
  program->SetUniform3f("anchor", &anchor.x);
  program->SetUniform4f("fromLight", &fromLight.x);
  return program;
}

//------------------------------------------------------------------------------
std::uint32_t ShadowLists::ReadHead(int index)
{
  GLuint value = 0;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glGetBufferSubData(
    GL_SHADER_STORAGE_BUFFER, index * static_cast<GLintptr>(sizeof(value)), sizeof(value), &value);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return value;
}

//------------------------------------------------------------------------------
// Draws all planes and caps, clipped to some rows, and returns how many boundaries there were, the
// unused one included.
std::uint64_t ShadowLists::DrawOnce(vtkShaderProgram* program, int slot, int row, int rows)
{
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  this->Window->GetState()->vtkglScissor(0, row, this->Width, rows);
  this->Use(program);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, LayerBinding, this->Layers[slot].Handle);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glBindVertexArray(this->VertexArray);
  const auto draw = [program](const Buffer& buffer, int kind, float nearer, int vertices) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EdgeBinding, buffer.Handle);
    program->SetUniformi("kind", kind);
    program->SetUniformf("nearer", nearer);
    glDrawArrays(GL_TRIANGLES, 0, vertices * buffer.Count);
  };
  draw(this->Edges[slot], 0, 1.0f, 6);
  // The surface that the ray ends on is none that it goes through.
  draw(this->Caps[slot], 1, 1.0f - 1e-5f, 3);
  draw(this->NearEdges[slot], 2, 1.0f, 3);
  glBindVertexArray(0);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return static_cast<std::uint64_t>(this->ReadHead(0)) + 1;
}

//------------------------------------------------------------------------------
int ShadowLists::DrawRows(vtkShaderProgram* program, int slot, int row, int rows)
{
  const std::uint64_t most = std::min<std::uint64_t>(
    this->MemoryLimit / this->GetNodeSize(), 0x7fffffffu / (this->GetNodeSize() / 4));
  while (rows > 0)
  {
    const std::uint64_t needed = this->DrawOnce(program, slot, row, rows);
    if (needed <= this->Capacity)
    {
      return rows;
    }
    if (this->Budgeted && needed > MostBands * most)
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
      this->Reserve(std::min(InitialCapacity, most));
    }
    rows = this->Capacity > 0 ? rows / 2 : 0;
  }
  this->OverBudget = true;
  this->Error = "one row of pixels crosses more shadow boundaries than the memory limit allows";
  return 0;
}

//------------------------------------------------------------------------------
int ShadowLists::Fill(int slot, const ShadowVolumes& volumes, const glm::dvec4& light,
  const View& view, vtkTextureObject* distances, int row, int rows)
{
  distances->Activate();
  vtkShaderProgram* program = this->ReadyPlanes(
    DefineNodes(this->Dimmed) + AirlightViewShader + AirlightPlanesFS, volumes, light, view);
  int done = 0;
  if (program)
  {
    program->SetUniformi("distances", distances->GetTextureUnit());
    vtkOpenGLState* state = this->Window->GetState();
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglEnable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_CLAMP);
    // Lenient: what the depth buffer's rounding leaves open, the shader's own test decides.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-2.0f, -8.0f);
    done = this->DrawRows(program, slot, row, rows);
    glPolygonOffset(0.0f, 0.0f);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EdgeBinding, 0);
    state->vtkglDepthMask(GL_TRUE);
  }
  distances->Deactivate();
  return done;
}

//------------------------------------------------------------------------------
bool ShadowLists::DrawWireframe(
  int slot, const ShadowVolumes& volumes, const glm::dvec4& light, const View& view)
{
  vtkShaderProgram* program = this->ReadyPlanes(AirlightOutlineFS, volumes, light, view);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  glEnable(GL_DEPTH_CLAMP);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glBindVertexArray(this->VertexArray);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EdgeBinding, this->Edges[slot].Handle);
  program->SetUniformi("kind", 0);
  glDrawArrays(GL_TRIANGLES, 0, 6 * this->Edges[slot].Count);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, EdgeBinding, 0);
  glBindVertexArray(0);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_DEPTH_CLAMP);
  state->vtkglDepthMask(GL_TRUE);
  return true;
}

//------------------------------------------------------------------------------
void ShadowLists::Use(vtkShaderProgram* program)
{
  program->SetUniformi("width", this->Width);
  // An unsigned integer, which vtkShaderProgram cannot set.
  glUniform1ui(glGetUniformLocation(program->GetHandle(), "capacity"), this->Capacity);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, NodeBinding, this->Nodes);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, HeadBinding, this->Heads);
}

//------------------------------------------------------------------------------
int ShadowLists::GetLongDraws()
{
  // One more, for lists whose length is a multiple of the chunk.
  const std::uint32_t longest = this->ReadHead(1);
  return longest > 0 ? static_cast<int>(longest / Chunk) + 1 : 0;
}

//------------------------------------------------------------------------------
bool ShadowLists::Sort()
{
  const std::uint32_t longest = this->ReadHead(1);
  vtkShaderProgram* program = this->SortQuad.Ready(
    this->Window, "#version 430\n" + DefineNodes(this->Dimmed) + AirlightSortFS);
  if (!program)
  {
    this->Error = "the sort shader did not compile: " + this->SortQuad.GetError();
    return false;
  }
  this->Use(program);
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  for (std::uint64_t run = 1; run < longest; run *= 2)
  {
    glUniform1ui(glGetUniformLocation(program->GetHandle(), "run"), static_cast<GLuint>(run));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    this->SortQuad.Draw({});
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return true;
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
  for (size_t slot = 0; slot < this->Edges.size(); ++slot)
  {
    glDeleteBuffers(1, &this->Edges[slot].Handle);
    glDeleteBuffers(1, &this->NearEdges[slot].Handle);
    glDeleteBuffers(1, &this->Caps[slot].Handle);
    glDeleteBuffers(1, &this->Layers[slot].Handle);
  }
  this->Edges.clear();
  this->NearEdges.clear();
  this->Caps.clear();
  this->Layers.clear();
  this->SortQuad.Release();
  this->VertexArray = this->Nodes = this->Heads = 0;
  this->Capacity = 0;
  this->HeadCount = 0;
}
}
