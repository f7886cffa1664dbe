// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a light's shadow planes and collects, for each pixel, the boundaries that its ray crosses
 * before the surface (AirlightBoundaryBuffer.h). None is left out: where they do not fit, the
 * buffer grows; where it may not grow, fewer rows are drawn at a time.
 */

#ifndef AirlightShadowLists_h
#define AirlightShadowLists_h

#include "OpenGL/AirlightPixelArea.h"
#include "OpenGL/AirlightProgram.h"
#include "ShadowVolumes/AirlightBoundaryBuffer.h"
#include "ShadowVolumes/AirlightBoundarySort.h"
#include "ShadowVolumes/AirlightShadowPlaneBuffers.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
class CameraUniforms;
class FroxelNodes;
class Targets;

class ShadowLists
{
public:
  static constexpr std::uint64_t MostBands = 16;

  // Whether the window's OpenGL has what this needs: 4.3.
  static bool IsSupported(vtkOpenGLRenderWindow* window);

  // Source that reads the boundaries (Inscatter/glsl/AirlightBoundaryReader.glsl), after a
  // GetShaderVersion(true) and BoundaryBuffer::DefineNodes(). A first draw does the pixels with
  // few. If GetLongDraws() is above 0 afterwards, there are others: Sort() puts them in order, and
  // the source for sorted lists reads them. It takes one draw if `counted`, which needs a k-buffer,
  // otherwise GetLongDraws(), all but the first with the uniform "resume" set.
  std::string GetBoundarySource(bool sorted, bool counted) const;

  // As BoundaryBuffer::Prepare(); with `budgeted`, Fill() gives up where the rows that have slots
  // at once need more than MostBands times the memory of lists.
  bool Prepare(vtkOpenGLRenderWindow* window, int width, int height, bool transmitsShadows,
    size_t edges, std::uint64_t memoryLimit, bool budgeted);
  const std::string& GetError() const { return this->Error; }

  // Uploads a light's edges and caps; `light` is the light's number. False with a reason in
  // GetError() where there is no memory for them.
  bool SetVolumes(int light, const ShadowVolumes& volumes);

  // What a light's planes are drawn from.
  struct Source
  {
    int LightNumber;
    const ShadowVolumes& Volumes;
    const glm::dvec4& Light;
    const CameraUniforms& Rays;
    vtkTextureObject* Distances;
    std::vector<glm::vec4> TruncationPlanes; // of planes, FindTruncationPlanes()
  };

  // Fills the lists of the pixels of an area in the rows [row, row + rows) into the bound
  // framebuffer, which has the scene's depth; the others' are empty. Returns the number of rows
  // done, fewer where the memory limit asks for it; 0 with a reason in GetError() where nothing
  // could be drawn.
  int Fill(const Source& source, const PixelArea& area, int row, int rows);

  // In place of lists: adds the boundaries of a light's planes to the nodes of a froxel grid, whose
  // framebuffer is bound, without Prepare(). False with a reason in GetError() where a shader does
  // not compile.
  bool FillNodes(vtkOpenGLRenderWindow* window, const Source& source, const FroxelNodes& nodes);

  // Draws the outlines of a light's planes into the bound framebuffer, where nothing hides them;
  // red where the view enters a shadow through a plane, blue where it leaves it. False with a
  // reason in GetError() where the shader does not compile.
  bool DrawWireframe(const Source& source);

  // Whether Fill() failed since there are too many boundaries.
  bool IsOverBudget() const { return this->OverBudget; }

  // For a program with the source above: binds the boundaries and sets its uniforms.
  void Use(vtkShaderProgram* program) { this->Store.Use(program); }

  // Whether boundaries have slots.
  bool HasKBuffer() const { return this->Store.GetKBufferSize() > 0; }

  // Number of draws for the lists that the first draw left out; 0 where it left out none.
  int GetLongDraws();

  // Sorts the long lists. Draws nothing into the bound framebuffer. False with a reason in
  // GetError() where the shader does not compile.
  bool Sort();

  void Release();

private:
  vtkShaderProgram* GetPlanesProgram(
    PlaneKind kind, const std::string& fragment, const Source& source);
  bool SetTruncationPlanes(const Source& source);
  std::string GetPlanesSource(const CameraUniforms& view) const;
  bool DrawFragments(const Source& source, PlaneKind kind, int row, int rows);
  bool TryDraw(const Source& source, int row, int rows, BoundaryBuffer::Counts& counts);
  int DrawRows(const Source& source, int row, int rows);

  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
  bool Budgeted = false;
  bool OverBudget = false;
  PixelArea Area{ 0, 0, 0, 0 };
  std::uint32_t Longest = 0; // list
  BoundarySort::Rows Filled; // that the lists are of
  ShadowPlaneBuffers Planes;
  BoundaryBuffer Store;
  BoundarySort Sorting{ this->Store };
  ProgramMaker PlanePrograms;
  std::string Error;
};
}

#endif
