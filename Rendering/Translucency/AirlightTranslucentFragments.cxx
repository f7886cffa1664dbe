// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Translucency/AirlightTranslucentFragments.h"

#include "AirlightSortTranslucentFS.h"
#include "AirlightTranslucentLists.h"
#include "AirlightTranslucentRecord.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightStorageBinding.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Numbers of bytes have to fit into an integer.
constexpr std::uint32_t MostBytes = 0x7fffffffu;

std::string NoMemory(const std::string& what)
{
  return "no memory on the graphics card for the records of " + what +
    ": make the window smaller, or fewer surfaces translucent";
}
}

//------------------------------------------------------------------------------
std::string TranslucentFragments::GetSource()
{
  return std::string(AirlightTranslucentRecord) + AirlightTranslucentLists;
}

//------------------------------------------------------------------------------
std::uint32_t TranslucentFragments::GetRecordBytes() const
{
  return sizeof(std::uint32_t) *
    (static_cast<std::uint32_t>(this->Words) + translucent_record::SortedWords);
}

//------------------------------------------------------------------------------
size_t TranslucentFragments::GetTileCount() const
{
  constexpr int side = translucent_record::AIRLIGHT_TRANSLUCENT_TILE;
  return static_cast<size_t>((this->Width - 1) / side + 1) * ((this->Height - 1) / side + 1);
}

//------------------------------------------------------------------------------
bool TranslucentFragments::Reserve(std::uint32_t records)
{
  const bool ok = AllocateStorageBlock(this->Records,
    static_cast<GLsizeiptr>(records) * this->GetRecordBytes(), nullptr, GL_DYNAMIC_COPY);
  this->Capacity = ok ? records : 0;
  this->Error = ok ? "" : NoMemory(std::to_string(records) + " translucent fragments");
  return ok;
}

//------------------------------------------------------------------------------
void TranslucentFragments::Clear()
{
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
bool TranslucentFragments::Prepare(int width, int height, bool transmitsShadows, int dimmedLights)
{
  using namespace translucent_record;
  this->TransmitsShadows = transmitsShadows;
  const int words = transmitsShadows
    ? AIRLIGHT_TRANSLUCENT_TRANSMITTANCE + AIRLIGHT_TRANSMITTANCE_WORDS * dimmedLights
    : AIRLIGHT_TRANSLUCENT_PLAIN_WORDS;
  if (this->Records == 0)
  {
    glGenBuffers(1, &this->Records);
    glGenBuffers(1, &this->Heads);
  }
  if (this->Width != width || this->Height != height)
  {
    this->Width = width;
    this->Height = height;
    const GLsizeiptr count = 2 * static_cast<GLsizeiptr>(width) * height + 2 +
      static_cast<GLsizeiptr>(this->GetTileCount());
    if (!AllocateStorageBlock(
          this->Heads, count * static_cast<GLsizeiptr>(sizeof(GLuint)), nullptr, GL_DYNAMIC_COPY))
    {
      this->Width = this->Height = 0;
      this->Error = NoMemory(
        "a viewport of " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
      return false;
    }
  }
  if (this->Words != words)
  {
    const std::uint64_t bytes = static_cast<std::uint64_t>(this->Capacity) * this->GetRecordBytes();
    this->Words = words;
    this->Capacity = static_cast<std::uint32_t>(bytes / this->GetRecordBytes());
  }
  // Room for one layer over a quarter of the pixels, at first.
  const bool ok =
    this->Capacity > 0 || this->Reserve(static_cast<std::uint32_t>(width * height / 4 + 64));
  this->Clear();
  return ok;
}

//------------------------------------------------------------------------------
void TranslucentFragments::Use(vtkShaderProgram* program) const
{
  program->SetUniformi("airlightTranslucentWidth", this->Width);
  program->SetUniformi("airlightTranslucentHeight", this->Height);
  program->SetUniformi("airlightTranslucentWords", this->Words);
  program->SetUniformi("airlightTranslucentCapacity", static_cast<int>(this->Capacity));
  BindStorage(StorageBinding::TranslucentFragments, this->Records);
  BindStorage(StorageBinding::TranslucentHeads, this->Heads);
}

//------------------------------------------------------------------------------
TranslucentFragments::Outcome TranslucentFragments::Check()
{
  GLuint count = 0;
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(count), &count);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  if (count < this->Capacity)
  {
    this->ReadTiles();
    return Outcome::Done;
  }
  const auto most = static_cast<std::uint32_t>(
    std::min<GLint64>(MostBytes, GetLargestStorageBlock()) / this->GetRecordBytes());
  if (count >= most)
  {
    this->Error = NoMemory(std::to_string(count) + " translucent fragments");
    this->Clear();
    return Outcome::TooMany;
  }
  if (!this->Reserve(std::min(count + count / 4 + 1, most)))
  {
    return Outcome::Failed;
  }
  this->Clear();
  return Outcome::Again;
}

//------------------------------------------------------------------------------
void TranslucentFragments::ReadTiles()
{
  std::vector<unsigned int> marks(this->GetTileCount());
  const GLintptr first = 2 * static_cast<GLintptr>(this->Width) * this->Height + 2;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Heads);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, first * static_cast<GLintptr>(sizeof(GLuint)),
    static_cast<GLsizeiptr>(marks.size() * sizeof(GLuint)), marks.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  this->Areas =
    CoverTiles(marks, translucent_record::AIRLIGHT_TRANSLUCENT_TILE, this->Width, this->Height);
}

//------------------------------------------------------------------------------
bool TranslucentFragments::Sort(vtkOpenGLRenderWindow* window)
{
  vtkShaderProgram* program = this->SortQuad.GetOrCompile(window,
    GetShaderVersion(true) + "#define AIRLIGHT_SHADOW_TRANSMITTANCE " +
      std::to_string(this->TransmitsShadows) + "\n" + GetSource() + AirlightSortTranslucentFS);
  if (!program)
  {
    this->Error =
      std::string("the shader that sorts translucent fragments") + ProgramMaker::GetReason();
    return false;
  }
  this->Use(program);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  vtkOpenGLState::ScopedglEnableDisable testSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  // No test fails without these, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  state->vtkglEnable(GL_SCISSOR_TEST);
  this->SortQuad.Draw({}, this->Areas.Marked, state);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return true;
}

//------------------------------------------------------------------------------
void TranslucentFragments::Release()
{
  this->SortQuad.Release();
  DeleteBuffer(this->Records);
  DeleteBuffer(this->Heads);
  this->Width = this->Height = 0;
  this->Capacity = 0;
}
}
