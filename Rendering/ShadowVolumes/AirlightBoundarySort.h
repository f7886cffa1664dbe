// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How boundaries are read in order: slots, lists that the reader sorts, and lists sorted
 * beforehand.
 */

#ifndef AirlightBoundarySort_h
#define AirlightBoundarySort_h

#include "OpenGL/AirlightQuad.h"
#include "ShadowVolumes/AirlightBoundaryBuffer.h"

#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace airlight
{
class BoundarySort
{
public:
  // Rows of the framebuffer whose lists are changed; others have none.
  struct Rows
  {
    vtkOpenGLRenderWindow* Window = nullptr;
    int Width = 0;
    int First = 0;
    int Count = 0;
  };

  // The boundaries have to live as long as this.
  explicit BoundarySort(BoundaryBuffer& store);

  // As ShadowLists' method of this name.
  std::string GetBoundarySource(bool sorted, bool counted) const;

  // How many draws read the lists that the first draw leaves out, the longest of which has this
  // length; 0 where it leaves out none.
  static int CountLongDraws(std::uint32_t longest);

  // Where a pixel has more boundaries than slots, those in the slots join the others in its list.
  // Like Sort(), draws nothing into the bound framebuffer, and returns false with a reason in
  // GetError() where the shader does not compile.
  bool MergeOverflow(const Rows& rows);

  // Sorts the long lists.
  bool Sort(const Rows& rows, std::uint32_t longest);

  const std::string& GetError() const { return this->Error; }

  void Release();

private:
  vtkShaderProgram* GetProgram(const Rows& rows, Quad& quad, const std::string& fragment);

  BoundaryBuffer& Store;
  Quad SortQuad;
  Quad OverflowQuad;
  std::string Error;
};
}

#endif
