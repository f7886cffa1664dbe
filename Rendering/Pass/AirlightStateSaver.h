// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The state of OpenGL that a frame changes.
 */

#ifndef AirlightStateSaver_h
#define AirlightStateSaver_h

#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightStorageBinding.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace airlight
{
// Restores it when it goes out of scope. `storage`: with the bindings of storage buffers.
class StateSaver
{
public:
  StateSaver(vtkOpenGLRenderWindow* window, bool storage)
    : State(window->GetState())
    , Storage(storage)
  {
    this->State->PushFramebufferBindings();
  }
  ~StateSaver() { this->PopFramebuffer(); }
  StateSaver(const StateSaver&) = delete;
  void operator=(const StateSaver&) = delete;

  // Back to the caller's framebuffer, into which the frame goes in the end.
  void PopFramebuffer()
  {
    if (this->State)
    {
      this->State->PopFramebufferBindings();
      this->State = nullptr;
    }
  }

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglViewport Viewport{ State };
  vtkOpenGLState::ScopedglScissor Scissor{ State };
  vtkOpenGLState::ScopedglEnableDisable ScissorTest{ State, GL_SCISSOR_TEST };
  vtkOpenGLState::ScopedglEnableDisable Blend{ State, GL_BLEND };
  vtkOpenGLState::ScopedglEnableDisable DepthTest{ State, GL_DEPTH_TEST };
  vtkOpenGLState::ScopedglEnableDisable CullFace{ State, GL_CULL_FACE };
  vtkOpenGLState::ScopedglDepthFunc DepthFunction{ State };
  vtkOpenGLState::ScopedglDepthMask DepthMask{ State };
  vtkOpenGLState::ScopedglColorMask ColorMask{ State };
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunction{ State };
  ScopedStorageBindings Storage;
};
}

#endif
