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
  return "#version 150\n" + Define("SLOT_COUNT", SlotCount) +
    "uniform sampler2D slots[SLOT_COUNT];\n"
    "out vec4 colour;\n"
    "void main() { colour = " +
    sum + "; }\n";
}
}

//------------------------------------------------------------------------------
void SamplerSlots::Fill(vtkOpenGLRenderWindow* window, vtkTextureObject* texture)
{
  static const std::string source = GetSource();
  vtkShaderProgram* program = this->Program.GetOrCompile(window, source);
  if (!program)
  {
    return;
  }
  texture->Activate();
  const std::vector<int> units(SlotCount, texture->GetTextureUnit());
  program->SetUniform1iv("slots", SlotCount, units.data());
  glEnable(GL_RASTERIZER_DISCARD);
  this->Program.Draw({});
  glDisable(GL_RASTERIZER_DISCARD);
  texture->Deactivate();
}
}
