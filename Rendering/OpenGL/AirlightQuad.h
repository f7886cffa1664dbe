// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A full-screen step of the pass: its program, put together from shader texts, and what it reads.
 */

#ifndef AirlightQuad_h
#define AirlightQuad_h

#include "OpenGL/AirlightProgram.h"

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
struct AirlightMedia;
struct AirlightPhotometry;
}

// The texts of the mathematics in the order in which they need one another, compiled for as many
// media, and where there is one for as many poles, as there are. `lightKind` is the kind of light
// that the text is to handle, below 0 for all; `photometry` tells whether lights may shine by
// tables.
std::string GetScatteringSource(const f64::AirlightMedia& media, int lightKind, bool photometry);

// What airlightScatteredIrradiance() needs beyond them.
std::string GetScatteredIrradianceSource();

// Sets a uniform AirlightMedia or AirlightLight of this name.
void SetMediaUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightMedia& media);
void SetPhotometryUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightPhotometry& photometry);
void SetLightUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightLight& light);

class Quad
{
public:
  // Compiles the fragment shader if it differs from the last one. Null where that fails.
  vtkShaderProgram* GetOrCompile(vtkOpenGLRenderWindow* window, const std::string& fragmentSource);

  // Draws with these textures bound to these names.
  void Draw(const std::vector<std::pair<const char*, vtkTextureObject*>>& textures);

  void Release();

private:
  vtkShaderProgram* Program = nullptr; // the shader cache's
  unsigned int VertexArray = 0;
  ProgramMaker Programs;
  std::string Source;
};
}

#endif
