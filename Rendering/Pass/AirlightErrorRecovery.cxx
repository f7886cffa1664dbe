// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightErrorRecovery.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool CheckOpenGL(vtkOpenGLRenderWindow* window, std::string& error)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major > 3 || (major == 3 && minor >= 3))
  {
    return true;
  }
  error = "the pass needs OpenGL 3.3 and this window has " + std::to_string(major) + "." +
    std::to_string(minor) + ": update the graphics driver, or use software rendering with Mesa";
  return false;
}

//------------------------------------------------------------------------------
void RestoreState(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
}
}
