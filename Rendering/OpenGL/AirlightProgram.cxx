// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightProgram.h"

#include "OpenGL/AirlightStorageBinding.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Calls between attempts: less than two to the power of this.
constexpr int MostDoublings = 16;
}

//------------------------------------------------------------------------------
std::string GetShaderVersion(bool storage)
{
  return storage ? "#version 430\n" + DefineStorageBindings()
                 : "#version 330\n#extension GL_ARB_gpu_shader5 : enable\n";
}

//------------------------------------------------------------------------------
std::string Define(const std::string& name, int value)
{
  return "#define " + name + " " + std::to_string(value) + "\n";
}

//------------------------------------------------------------------------------
bool IsLastToChange(const vtkObjectBase* pass, vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys && keys->Has(passes) ? keys->Length(passes) : 0;
  return (count > 0 ? keys->Get(passes, count - 1) : nullptr) == pass &&
    prop->GetShaderProperty()->GetNumberOfShaderReplacements() == 0;
}

//------------------------------------------------------------------------------
vtkShaderProgram* ProgramMaker::GetOrCompile(vtkOpenGLRenderWindow* window,
  const std::string& vertex, std::string& fragment, const std::string& geometry)
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
