// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightBoundarySort.h"

#include "AirlightCountedListReader.h"
#include "AirlightKBufferReader.h"
#include "AirlightOverflowFS.h"
#include "AirlightShortListReader.h"
#include "AirlightSortFS.h"
#include "AirlightSortedKBuffer.h"
#include "AirlightSortedListReader.h"
#include "AirlightStoredBoundaries.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Lists up to this length are sorted where they are read.
constexpr std::uint32_t ShortList = 64;
// Boundaries of a longer list that one draw reads.
constexpr std::uint32_t Chunk = 128;

std::string DefineLengths()
{
  return "#define AIRLIGHT_SHORT_LIST " + std::to_string(ShortList) + "\n#define AIRLIGHT_CHUNK " +
    std::to_string(Chunk) + "\n";
}
}

//------------------------------------------------------------------------------
BoundarySort::BoundarySort(BoundaryBuffer& store)
  : Store(store)
{
}

//------------------------------------------------------------------------------
std::string BoundarySort::GetBoundarySource(bool sorted, bool counted) const
{
  const std::string start = this->Store.GetSource() + DefineLengths() + AirlightStoredBoundaries;
  // Long lists are read from where Sort() has put them in order, slots or not.
  if (sorted)
  {
    return start + (counted ? AirlightCountedListReader : AirlightSortedListReader);
  }
  return start +
    (this->Store.GetKBufferSize() > 0 ? std::string(AirlightSortedKBuffer) + AirlightKBufferReader
                                      : AirlightShortListReader);
}

//------------------------------------------------------------------------------
// A program that changes lists; nothing is drawn into the framebuffer.
vtkShaderProgram* BoundarySort::GetProgram(
  const Rows& rows, Quad& quad, const std::string& fragment)
{
  vtkShaderProgram* program = quad.GetOrCompile(rows.Window,
    GetShaderVersion(true) + BoundaryBuffer::DefineNodes(this->Store.HasShadowTransmittance()) +
      this->Store.GetSource() + fragment);
  if (!program)
  {
    this->Error = std::string("the shader of long lists") + ProgramMaker::GetReason();
    return nullptr;
  }
  this->Store.Use(program);
  vtkOpenGLState* state = rows.Window->GetState();
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  return program;
}

//------------------------------------------------------------------------------
bool BoundarySort::MergeOverflow(const Rows& rows)
{
  vtkOpenGLState* state = rows.Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  if (!this->GetProgram(
        rows, this->OverflowQuad, std::string(AirlightSortedKBuffer) + AirlightOverflowFS))
  {
    return false;
  }
  state->vtkglScissor(0, rows.First, rows.Width, rows.Count);
  this->OverflowQuad.Draw({});
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return true;
}

//------------------------------------------------------------------------------
int BoundarySort::CountLongDraws(std::uint32_t longest)
{
  // One more, for lists whose length is a multiple of the chunk.
  return longest > 0 ? static_cast<int>(longest / Chunk) + 1 : 0;
}

//------------------------------------------------------------------------------
bool BoundarySort::Sort(const Rows& rows, std::uint32_t longest)
{
  vtkOpenGLState::ScopedglColorMask maskSaver(rows.Window->GetState());
  vtkShaderProgram* program = this->GetProgram(rows, this->SortQuad, AirlightSortFS);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = rows.Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, rows.First, rows.Width, rows.Count);
  // MergeOverflow() has put runs in order.
  for (std::uint64_t run = std::max(this->Store.GetKBufferSize(), 1); run < longest; run *= 2)
  {
    glUniform1ui(glGetUniformLocation(program->GetHandle(), "run"), static_cast<GLuint>(run));
    // No test fails without it, see AirlightOpenGL.h.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    this->SortQuad.Draw({});
  }
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return true;
}

//------------------------------------------------------------------------------
void BoundarySort::Release()
{
  this->SortQuad.Release();
  this->OverflowQuad.Release();
}
}
