// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A full-screen step of the pass: its program, put together from shader texts, and what it reads.
 */

#ifndef AirlightQuad_h
#define AirlightQuad_h

#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

namespace airlight
{
namespace f64
{
struct AirlightLight;
struct AirlightMedium;
}

// The texts of the mathematics in the order in which they need one another, compiled for a phase
// function of this many poles.
std::string GetScatteringSource(int poleCount);

void SetMediumUniforms(vtkShaderProgram* program, const f64::AirlightMedium& medium);
void SetLightUniforms(vtkShaderProgram* program, const f64::AirlightLight& light);

class Quad
{
public:
  // Compiles the fragment shader if it differs from the last one. Null where that fails; the
  // reason is then in GetError().
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& fragmentSource);
  const std::string& GetError() const { return this->Error; }

  // Draws with these textures bound to these names.
  void Draw(const std::vector<std::pair<const char*, vtkTextureObject*>>& textures);

  void Release();

private:
  vtkShaderProgram* Program = nullptr; // the shader cache's
  unsigned int VertexArray = 0;
  std::string Source;
  std::string Error;
};
}

#endif
