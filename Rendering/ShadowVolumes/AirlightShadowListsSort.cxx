// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// How boundaries are read in order: slots, lists that the reader sorts, and lists sorted
// beforehand.

#include "ShadowVolumes/AirlightShadowLists.h"

#include "AirlightBoundaries.h"
#include "AirlightOverflowFS.h"
#include "AirlightSortFS.h"
#include "AirlightSortedKBuffer.h"
#include "AirlightSortedList.h"
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
std::string ShadowLists::GetPackedSource(bool sorted) const
{
  return this->Store.GetSource() + (sorted ? AirlightSortedList : AirlightSortedKBuffer);
}

//------------------------------------------------------------------------------
std::string ShadowLists::GetBoundariesSource(bool sorted) const
{
  // Long lists are read from where Sort() has put them in order, slots or not.
  const bool slots = !sorted && this->HasKBuffer();
  return (slots ? this->GetPackedSource(false) : this->Store.GetSource()) + DefineLengths() +
    (sorted ? "#define AIRLIGHT_SORTED\n" : "") + AirlightBoundaries;
}

//------------------------------------------------------------------------------
// A program that changes lists; nothing is drawn into the framebuffer.
vtkShaderProgram* ShadowLists::GetListsProgram(Quad& quad, const std::string& fragment)
{
  vtkShaderProgram* program = quad.GetOrCompile(this->Window,
    GetShaderVersion(true) + BoundaryBuffer::DefineNodes(this->Store.HasShadowTransmittance()) +
      this->Store.GetSource() + fragment);
  if (!program)
  {
    this->Error = std::string("the shader of long lists") + ProgramMaker::GetReason();
    return nullptr;
  }
  this->Store.Use(program);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_DEPTH_TEST);
  return program;
}

//------------------------------------------------------------------------------
// Where a pixel has more boundaries than slots, those in the slots join the others in its list.
bool ShadowLists::MergeOverflow(int row, int rows)
{
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  if (!this->GetListsProgram(
        this->OverflowQuad, std::string(AirlightSortedKBuffer) + AirlightOverflowFS))
  {
    return false;
  }
  state->vtkglScissor(0, row, this->Width, rows);
  this->OverflowQuad.Draw({});
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return true;
}

//------------------------------------------------------------------------------
int ShadowLists::GetLongDraws()
{
  if (!this->HasKBuffer())
  {
    this->Longest = this->Store.ReadCounts().Longest;
  }
  // One more, for lists whose length is a multiple of the chunk.
  return this->Longest > 0 ? static_cast<int>(this->Longest / Chunk) + 1 : 0;
}

//------------------------------------------------------------------------------
bool ShadowLists::Sort()
{
  vtkOpenGLState::ScopedglColorMask maskSaver(this->Window->GetState());
  vtkShaderProgram* program = this->GetListsProgram(this->SortQuad, AirlightSortFS);
  if (!program)
  {
    return false;
  }
  // Other rows have no heads.
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, this->FirstRow, this->Width, this->Rows);
  // MergeOverflow() has put runs in order.
  for (std::uint64_t run = std::max(this->Store.GetKBufferSize(), 1); run < this->Longest; run *= 2)
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
}
