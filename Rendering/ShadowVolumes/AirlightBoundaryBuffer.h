// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The boundaries of a light's shadows on each pixel, in the memory of the graphics card.
 *
 * Most pixels have few. So each has 16 slots of 4 bytes, or 32 where there are many silhouette
 * edges; what finds no slot goes into a linked list of the pixel (glsl/AirlightKBuffer.glsl,
 * glsl/AirlightPlanesFS.glsl). Where casters let light through, boundaries take more than a slot
 * holds: there all are in lists. Bytes:
 *
 *   a pixel: 4 for each slot, 8 for the list's head and the number of boundaries
 *   a boundary beyond the slots: 12, or 24 where casters let light through
 *
 * Where the memory limit has no room for the slots of all rows of pixels, it is used again for one
 * band of rows after another.
 */

#ifndef AirlightBoundaryBuffer_h
#define AirlightBoundaryBuffer_h

#include <cstddef>
#include <cstdint>
#include <string>

class vtkShaderProgram;

namespace airlight
{
class BoundaryBuffer
{
public:
  // For a frame. `transmitsShadows`: whether boundaries tell how much light their casters let
  // through. `edges`: the most silhouette edges of a light, on which alone the number of slots
  // depends, so that a picture does not depend on those before it. `limit` in bytes. False with a
  // reason in GetError() if OpenGL refuses a buffer.
  bool Prepare(int width, int height, bool transmitsShadows, size_t edges, std::uint64_t limit);
  const std::string& GetError() const { return this->Error; }

  bool HasShadowTransmittance() const { return this->TransmitsShadows; }

  // Of each pixel; 0 where all boundaries are in lists.
  int GetKBufferSize() const { return this->KBufferRows == 0 ? 0 : this->KBufferSize; }

  // The most rows that have slots at once.
  int LimitRows(int rows) const;

  // Empties all for the rows from this one on.
  void Clear(int row);

  // What shaders that write or read boundaries begin with, after GetShaderVersion(true). The lists'
  // words alone for others that have the lists' kinds of light, not their boundaries.
  std::string GetSource() const;
  static std::string DefineNodes(bool transmitsShadows);

  // Binds all and sets the uniforms of that source.
  void Use(vtkShaderProgram* program);

  // After a draw: the boundaries in lists, also those for which there was no room, and the most of
  // a pixel whose list is to be sorted, as far as a draw has found that out.
  struct Counts
  {
    std::uint64_t Boundaries = 0;
    std::uint32_t Longest = 0;
  };
  Counts ReadCounts();

  // In boundaries of lists: what there is room for, and what the limit allows.
  std::uint64_t GetCapacity() const { return this->Capacity; }
  std::uint64_t GetMost() const;

  // False with a reason in GetError() where there is no such memory; the capacity may be 0 then.
  bool Reserve(std::uint64_t boundaries);
  bool ReserveSome();

  void Release();

private:
  std::uint64_t GetNodeSize() const;
  std::uint64_t GetKBufferRowBytes() const;
  bool ReserveKBuffer();
  bool Allocate(unsigned int buffer, std::uint64_t bytes, const std::string& what);

  int Width = 0;
  int Height = 0;
  std::uint64_t Limit = 0;
  std::uint64_t MostBytes = 0; // of a buffer
  std::uint32_t Capacity = 0;  // boundaries, the unused one at index 0 included
  unsigned int Nodes = 0;
  // In turn, a light each: one is cleared while what was drawn with the other is still going on.
  unsigned int ListHeads[2] = {};
  int Current = 0;
  unsigned int KBuffer = 0;
  int KBufferSize = 16;
  int KBufferRows = 0;
  int ListHeadRows = 0; // what a storage block of the driver holds
  int FirstRow = 0;     // of the heads and slots
  std::uint64_t ListHeadCount = 0;
  std::uint64_t KBufferBytes = 0; // bytes allocated
  bool TransmitsShadows = false;
  std::string Error;
};
}

#endif
