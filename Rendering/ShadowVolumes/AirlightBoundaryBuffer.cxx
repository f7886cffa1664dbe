// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightBoundaryBuffer.h"

#include "AirlightBoundaryNodes.h"
#include "AirlightKBuffer.h"
#include "AirlightListHeads.h"
#include "OpenGL/AirlightStorageBinding.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr std::uint64_t PlainNodeWords = 3;
constexpr std::uint64_t TransmittingNodeWords = 6;
// For the few pixels whose slots do not suffice, and where there are none.
constexpr std::uint64_t InitialCapacity = 1u << 18;
// What AirlightListHeads.glsl begins with.
constexpr int ListHeadOffset = 2;
// More silhouette edges than these have pixels enough with more than 16 boundaries.
constexpr size_t ManyEdges = 8192;
}

//------------------------------------------------------------------------------
std::uint64_t BoundaryBuffer::GetNodeSize() const
{
  return 4 * (this->TransmitsShadows ? TransmittingNodeWords : PlainNodeWords);
}

//------------------------------------------------------------------------------
// Of one row of pixels.
std::uint64_t BoundaryBuffer::GetKBufferRowBytes() const
{
  return static_cast<std::uint64_t>(this->Width) * this->KBufferSize * 4;
}

//------------------------------------------------------------------------------
bool BoundaryBuffer::Allocate(unsigned int buffer, std::uint64_t bytes, const std::string& what)
{
  if (!AllocateStorageBlock(buffer, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY))
  {
    this->Error = "no memory on the graphics card for " + what +
      ": lower SetMemoryLimit(), make the window smaller or call SetShadowTechniqueToShadowMap()";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool BoundaryBuffer::Reserve(std::uint64_t boundaries)
{
  const bool ok = this->Allocate(this->Nodes, boundaries * this->GetNodeSize(),
    "the lists of " + std::to_string(boundaries) + " boundaries");
  this->Capacity = ok ? static_cast<std::uint32_t>(boundaries) : 0;
  return ok;
}

//------------------------------------------------------------------------------
bool BoundaryBuffer::ReserveSome()
{
  return this->Reserve(std::min(InitialCapacity, this->GetMost()));
}

//------------------------------------------------------------------------------
// A quarter of the limit is left to lists.
bool BoundaryBuffer::ReserveKBuffer()
{
  const std::uint64_t most = std::min(this->Limit - this->Limit / 4, this->MostBytes);
  const std::uint64_t row = std::max<std::uint64_t>(this->GetKBufferRowBytes(), 1);
  const auto height = static_cast<std::uint64_t>(this->Height);
  this->KBufferRows = this->TransmitsShadows ? 0 : static_cast<int>(std::min(height, most / row));
  const std::uint64_t bytes = this->KBufferRows * row;
  if (bytes == this->KBufferBytes)
  {
    return true;
  }
  this->KBufferBytes = bytes;
  return this->Allocate(this->KBuffer, bytes,
    "the boundaries of " + std::to_string(this->KBufferRows) + " rows of pixels");
}

//------------------------------------------------------------------------------
std::uint64_t BoundaryBuffer::GetMost() const
{
  const std::uint64_t left = this->Limit - std::min(this->KBufferBytes, this->Limit);
  return std::min(left, this->MostBytes) / this->GetNodeSize();
}

//------------------------------------------------------------------------------
bool BoundaryBuffer::Prepare(
  int width, int height, bool transmitsShadows, size_t edges, std::uint64_t limit)
{
  // The lists keep their bytes.
  const std::uint64_t listBytes = this->Capacity * this->GetNodeSize();
  this->TransmitsShadows = transmitsShadows;
  this->Capacity = static_cast<std::uint32_t>(listBytes / this->GetNodeSize());
  this->Width = width;
  this->Height = height;
  this->Limit = limit;
  this->KBufferSize = edges > ManyEdges ? 32 : 16;
  if (this->Nodes == 0)
  {
    glGenBuffers(1, &this->Nodes);
    glGenBuffers(2, this->ListHeads);
    glGenBuffers(1, &this->KBuffer);
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    // Indices of words are 32 bits wide.
    this->MostBytes = std::clamp<std::uint64_t>(most, 1u << 24, 0x7fffffff);
  }
  const std::uint64_t row = 2 * static_cast<std::uint64_t>(width);
  const std::uint64_t most = (this->MostBytes / 4 - ListHeadOffset) / row;
  this->ListHeadRows = static_cast<int>(std::min<std::uint64_t>(height, most));
  const std::uint64_t heads = row * this->ListHeadRows + ListHeadOffset;
  for (int i = 0; i < 2 && this->ListHeadCount != heads; ++i)
  {
    if (!this->Allocate(this->ListHeads[i], 4 * heads,
          "a viewport of " + std::to_string(width) + " x " + std::to_string(height) + " pixels"))
    {
      return false;
    }
  }
  this->ListHeadCount = heads;
  if (!this->ReserveKBuffer())
  {
    return false;
  }
  const bool fits = this->Capacity > 0 && this->Capacity <= this->GetMost();
  return fits || this->ReserveSome();
}

//------------------------------------------------------------------------------
int BoundaryBuffer::LimitRows(int rows) const
{
  rows = std::min(rows, this->ListHeadRows);
  return this->GetKBufferSize() > 0 ? std::min(rows, this->KBufferRows) : rows;
}

//------------------------------------------------------------------------------
void BoundaryBuffer::Clear(int row)
{
  this->FirstRow = row;
  this->Current = 1 - this->Current;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->ListHeads[this->Current]);
  glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
std::string BoundaryBuffer::DefineNodes(bool transmitsShadows)
{
  return "#define AIRLIGHT_SHADOW_TRANSMITTANCE " + std::to_string(transmitsShadows) +
    "\n#define AIRLIGHT_NODE_WORDS " +
    std::to_string(transmitsShadows ? TransmittingNodeWords : PlainNodeWords) + "u\n";
}

//------------------------------------------------------------------------------
std::string BoundaryBuffer::GetSource() const
{
  return "#define AIRLIGHT_K_BUFFER_SIZE " + std::to_string(this->GetKBufferSize()) + "\n" +
    AirlightListHeads + (this->GetKBufferSize() > 0 ? AirlightKBuffer : "") + AirlightBoundaryNodes;
}

//------------------------------------------------------------------------------
void BoundaryBuffer::Use(vtkShaderProgram* program)
{
  // Integers in vectors of three, which vtkShaderProgram cannot set.
  glUniform3i(glGetUniformLocation(program->GetHandle(), "givenListLayout"), this->FirstRow,
    this->Width, this->ListHeadRows);
  BindStorage(StorageBinding::Boundaries, this->Nodes);
  BindStorage(StorageBinding::ListHeads, this->ListHeads[this->Current]);
  BindStorage(StorageBinding::KBuffer, this->KBuffer);
}

//------------------------------------------------------------------------------
BoundaryBuffer::Counts BoundaryBuffer::ReadCounts()
{
  GLuint values[ListHeadOffset] = {};
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->ListHeads[this->Current]);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(values), values);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  Counts counts;
  counts.Boundaries = values[0];
  counts.Longest = values[1];
  return counts;
}

//------------------------------------------------------------------------------
void BoundaryBuffer::Release()
{
  DeleteBuffer(this->Nodes);
  DeleteBuffer(this->ListHeads[0]);
  DeleteBuffer(this->ListHeads[1]);
  DeleteBuffer(this->KBuffer);
  this->Capacity = 0;
  this->ListHeadCount = 0;
  this->KBufferBytes = 0;
  this->KBufferRows = 0;
}
}
