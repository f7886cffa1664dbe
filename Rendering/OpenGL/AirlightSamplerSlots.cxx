// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightSamplerSlots.h"

#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightProgram.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

namespace airlight
{
namespace
{
constexpr int SlotCount = 16; // of OpenGL 3.2

// Before OpenGL 4.0 samplers have constant indices.
std::string GetSource()
{
  std::string sum = "vec4(0.0)";
  for (int i = 0; i < SlotCount; ++i)
  {
    sum += " + texelFetch(slots[" + std::to_string(i) + "], ivec2(0), 0)";
  }
  return GetShaderVersion(false) + Define("SLOT_COUNT", SlotCount) +
    "uniform sampler2D slots[SLOT_COUNT];\n"
    "layout(location = 0) out vec4 colour;\n"
    "void main() { colour = " +
    sum + "; }\n";
}
}

SamplerSlots::SamplerSlots() = default;
SamplerSlots::~SamplerSlots() = default;

//------------------------------------------------------------------------------
void SamplerSlots::Fill(vtkOpenGLRenderWindow* window)
{
  vtkShaderProgram* program = this->Program.GetOrCompile(window, GetSource());
  if (!program)
  {
    return;
  }
  if (this->Texture->GetHandle() == 0)
  {
    this->Texture->SetContext(window);
    this->Texture->Allocate2D(1, 1, 4, VTK_FLOAT);
  }
  this->Texture->Activate();
  const std::vector<int> units(SlotCount, this->Texture->GetTextureUnit());
  program->SetUniform1iv("slots", SlotCount, units.data());
  glEnable(GL_RASTERIZER_DISCARD);
  this->Program.Draw({});
  glDisable(GL_RASTERIZER_DISCARD);
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
void SamplerSlots::Release(vtkWindow* window)
{
  this->Program.Release();
  this->Texture->ReleaseGraphicsResources(window);
}
}
