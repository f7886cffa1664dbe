// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a light's shadow planes and collects, for each pixel, the list of boundaries that its ray
 * crosses before the surface.
 *
 * Memory: 12 bytes a boundary and 4 a pixel. Lists are never cut short: where the boundaries do
 * not fit, the buffer grows; where it may not grow, fewer rows are drawn at a time.
 */

#ifndef AirlightShadowLists_h
#define AirlightShadowLists_h

#include "AirlightShadowVolumes.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
class Targets;
class View;

class ShadowLists
{
public:
  ~ShadowLists();

  // Whether the window's OpenGL has what this needs: 4.3.
  static bool IsSupported(vtkOpenGLRenderWindow* window);

  // Fragment source that reads the lists, after a "#version 430".
  static std::string GetBoundariesSource();

  // `memoryLimit` in bytes. False with a reason in GetError() where a buffer cannot be had.
  bool Prepare(vtkOpenGLRenderWindow* window, int width, int height, std::uint64_t memoryLimit);
  const std::string& GetError() const { return this->Error; }

  // Uploads a light's edges; `slot` is the light's number.
  void SetEdges(int slot, const std::vector<ShadowEdge>& edges);

  // Fills the lists of the rows [row, row + rows) into the bound framebuffer, which has the
  // scene's depth. Returns the number of rows done, fewer where the memory limit asks for it; 0
  // with a reason in GetError() where nothing could be drawn.
  int Fill(int slot, const ShadowVolumes& volumes, const glm::dvec4& light, const View& view,
    vtkTextureObject* distances, int row, int rows);

  // For a program with the source above: binds the lists and sets its uniforms.
  void Use(vtkShaderProgram* program);

  // Boundaries that fit before a buffer has to grow. For tests; the default serves all scenes.
  static void SetInitialCapacity(std::uint32_t capacity);

  void Release();

private:
  bool Reserve(std::uint64_t boundaries);
  std::uint32_t DrawOnce(vtkShaderProgram* program, int edgeCount, int row, int rows);
  vtkShaderProgram* ReadyProgram();

  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
  std::uint64_t MemoryLimit = 0;
  std::uint32_t Capacity = 0; // boundaries, the unused one at index 0 included
  unsigned int Nodes = 0;
  unsigned int Heads = 0;
  int HeadCount = 0;
  unsigned int VertexArray = 0;
  struct EdgeBuffer
  {
    unsigned int Handle = 0;
    int Count = 0;
  };
  std::vector<EdgeBuffer> Edges; // by slot
  std::string Error;
};
}

#endif
