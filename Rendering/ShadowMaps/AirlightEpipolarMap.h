// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A shadow map drawn into the epipolar slices of a view. Needs OpenGL 3.2.
 *
 * Memory: 4 bytes a column and row.
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
  // Binds a framebuffer over a texture. Returns a reason where that fails, else an empty text.
  using BindTarget = std::function<std::string(vtkTextureObject*)>;

  // Draws the slices of a map for a view, with at least so many columns. False with a reason in
  // GetError() where OpenGL refuses.
  bool Draw(vtkOpenGLRenderWindow* window, ShadowMap& map, const CameraUniforms& view, int columns,
    Quad& quad, const BindTarget& bind);

  // Those of glsl/AirlightSliceLayout.glsl.
  void SetUniforms(vtkShaderProgram* program) const { this->Slices.SetUniforms(program); }

  // Null before there were any slices.
  vtkTextureObject* GetTexture()
  {
    return this->Texture->GetHandle() != 0 ? this->Texture.Get() : nullptr;
  }
  const std::string& GetError() const { return this->Error; }

  void Release(vtkWindow* window) { this->Texture->ReleaseGraphicsResources(window); }

private:
  bool Fail(const std::string& reason);
  bool Allocate(vtkOpenGLRenderWindow* window);

  EpipolarSlices Slices;
  vtkNew<vtkTextureObject> Texture;
  std::string Error;
};
}

#endif
