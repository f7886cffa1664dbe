// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A full-screen step of the pass: its program, put together from shader texts, and what it reads.
 */

#ifndef AirlightQuad_h
#define AirlightQuad_h

#include "OpenGL/AirlightPixelArea.h"
#include "OpenGL/AirlightProgram.h"

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

  void Release();

private:
  vtkShaderProgram* Program = nullptr; // the shader cache's
  unsigned int VertexArray = 0;
  ProgramMaker Programs;
  std::string Source;
};
}

#endif
