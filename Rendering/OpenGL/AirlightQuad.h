// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A full-screen step of the pass: its program, put together from shader texts, and what it reads.
 */

#ifndef AirlightQuad_h
#define AirlightQuad_h

#include "OpenGL/AirlightPixelArea.h"
#include "OpenGL/AirlightProgram.h"

#include <glm/vec4.hpp>

#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;
class vtkTextureObject;

namespace airlight
{
class Quad
{
public:
  // Compiles the fragment shader if it differs from the last one. Null where that fails.
  vtkShaderProgram* GetOrCompile(vtkOpenGLRenderWindow* window, const std::string& fragmentSource);

  // Draws with these textures bound to these names, in all of the viewport or in some areas of it.
  using Textures = std::vector<std::pair<const char*, vtkTextureObject*>>;
  void Draw(const Textures& textures) { this->Draw(textures, {}, nullptr); }
  void Draw(const Textures& textures, const std::vector<PixelArea>& areas, vtkOpenGLState* state);

  // Draws a finished picture and its depth into a viewport (x, y, width, height) of the framebuffer
  // that is bound; `blend`: over what it holds, of colours times their opacity; `masked`: as a
  // MaskedDraw, without its depth, and into the mean of what it holds and this, whose share is the
  // alpha of OpenGL's blend colour.
  void DrawIntoViewport(vtkOpenGLState* state, const Textures& textures, const glm::ivec4& viewport,
    bool blend, bool masked = false);

  // Draws depths that the shader writes into all of the depth buffer that is bound.
  void DrawDepths(vtkOpenGLState* state, const Textures& textures);

  // Until this goes out of scope, the depth that is bound is a mask: quads are drawn where it is
  // above 0. If not `masked`, everywhere.
  class MaskedDraw
  {
  public:
    MaskedDraw(vtkOpenGLState* state, bool masked);
    ~MaskedDraw();
    MaskedDraw(const MaskedDraw&) = delete;
    void operator=(const MaskedDraw&) = delete;

  private:
    vtkOpenGLState* State;
    bool Masked;
    float DepthRange[2] = { 0.0f, 1.0f }; // before
  };

  void Release();

private:
  vtkShaderProgram* Program = nullptr; // the shader cache's
  unsigned int VertexArray = 0;
  ProgramMaker Programs;
  std::string Source;
};
}

#endif
