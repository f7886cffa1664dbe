// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightProgram.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Calls between attempts: less than two to the power of this.
constexpr int MostDoublings = 16;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ProgramMaker::Ready(vtkOpenGLRenderWindow* window, const std::string& vertex,
  std::string& fragment, const std::string& geometry)
{
  if (this->Waits > 0 && this->Failed == fragment)
  {
    --this->Waits;
    return nullptr;
  }
  const std::string text = fragment;
  if (this->Failures > 0)
  {
    fragment += "\n// attempt " + std::to_string(this->Failures + 1) + "\n";
  }
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), fragment.c_str(), geometry.c_str());
  if (program && program->GetCompiled())
  {
    return program;
  }
  this->Failed = text;
  this->Waits = (1 << std::min(this->Failures, MostDoublings)) - 1;
  ++this->Failures;
  return nullptr;
}
}
