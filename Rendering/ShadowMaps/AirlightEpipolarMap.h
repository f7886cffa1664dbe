// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A shadow map drawn into the epipolar slices of a view. Needs OpenGL 3.2.
 *
 * Memory: 2 bytes a column and row, and 16 for each 64 of them.
 */

#ifndef AirlightEpipolarMap_h
#define AirlightEpipolarMap_h

#include "OpenGL/AirlightQuad.h"
#include "ShadowMaps/AirlightEpipolarSlices.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace airlight
{
class CameraUniforms;
class ShadowMap;

class EpipolarMap
{
public:
  // What all maps draw their slices by.
  struct Programs
  {
    Quad Columns;
    Quad Ranges;
    void Release()
    {
      this->Columns.Release();
      this->Ranges.Release();
    }
  };

  // Binds a framebuffer over a texture. Returns a reason where that fails, else an empty text.
  using BindTarget = std::function<std::string(vtkTextureObject*)>;

  // Draws the slices of a map for a view, with at least so many columns. False with a reason in
  // GetError() where OpenGL refuses.
  bool Draw(vtkOpenGLRenderWindow* window, ShadowMap& map, const CameraUniforms& view, int columns,
    Programs& programs, const BindTarget& bind);

  // Those of glsl/AirlightSliceLayout.glsl.
  void SetUniforms(vtkShaderProgram* program) const { this->Slices.SetUniforms(program); }

  // After Draw().
  vtkTextureObject* GetTexture() { return this->Texture; }
  vtkTextureObject* GetRanges() { return this->Ranges; }
  const std::string& GetError() const { return this->Error; }

  void Release(vtkWindow* window)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Ranges->ReleaseGraphicsResources(window);
  }

private:
  bool Fail(const std::string& reason);
  // As high as there are rows, at least one.
  struct Target
  {
    vtkTextureObject* Texture;
    int Width;
    bool IsInteger; // else of floats
  };
  bool Allocate(vtkOpenGLRenderWindow* window, const Target& target);
  bool Begin(vtkOpenGLRenderWindow* window, const Target& target, const BindTarget& bind);
  bool DrawColumns(vtkOpenGLRenderWindow* window, ShadowMap& map, const CameraUniforms& view,
    Quad& quad, const BindTarget& bind);
  bool DrawRanges(vtkOpenGLRenderWindow* window, Quad& quad, const BindTarget& bind);

  EpipolarSlices Slices;
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkTextureObject> Ranges; // glsl/AirlightSliceRangesFS.glsl
  std::string Error;
};
}

#endif
