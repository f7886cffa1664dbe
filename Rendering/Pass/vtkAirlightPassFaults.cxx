// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightPass does where OpenGL is too old, or refuses shaders or memory.

#include "Pass/vtkAirlightPassInternals.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkAbstractMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

using namespace airlight;

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::CheckOpenGL(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major > 3 || (major == 3 && minor >= 3))
  {
    return true;
  }
  this->Error = "the pass needs OpenGL 3.3 and this window has " + std::to_string(major) + "." +
    std::to_string(minor) + ": update the graphics driver, or use software rendering with Mesa";
  return false;
}

//------------------------------------------------------------------------------
// VTK's mappers do not survive a shader that does not compile. So it is compiled before they do it,
// which find it compiled in the window's cache.
void vtkAirlightPass::Internals::AddToShader(const std::string& vertex, const std::string& geometry,
  std::string& fragment, vtkAbstractMapper* mapper, vtkProp* prop, const ShaderChange& change)
{
  if (!this->NotCompiled.empty())
  {
    return;
  }
  std::string changed = fragment;
  change(changed);
  vtkOpenGLRenderWindow* window = this->Context->GetContext();
  if (window && IsLastToChange(this->Self, prop) &&
    !this->MapperPrograms.Ready(window, vertex, changed, geometry))
  {
    this->NotCompiled = mapper->GetClassName();
    return;
  }
  fragment = changed;
}

//------------------------------------------------------------------------------
// The next frame shall ask for the shaders again.
bool vtkAirlightPass::Internals::CheckShaders()
{
  if (this->NotCompiled.empty())
  {
    return true;
  }
  this->ShaderTime.Modified();
  this->Error =
    "the shader of a " + this->NotCompiled + " with the medium" + ProgramMaker::GetReason();
  return false;
}

//------------------------------------------------------------------------------
// A frame may end with any step's state; VTK expects its own. Where there are only too many boundaries,
// nothing is broken. A frame that is none has no buffers.
void vtkAirlightPass::Internals::Recover()
{
  this->CurrentFrame.ForgetBuffers();
  if (vtkOpenGLRenderWindow* window = this->Context->GetContext())
  {
    vtkOpenGLState* state = window->GetState();
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_LEQUAL);
    if (!this->CurrentFrame.IsOverBudget())
    {
      this->CurrentFrame.ReleaseObjects(window);
    }
  }
}
