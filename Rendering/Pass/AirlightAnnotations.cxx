// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightAnnotations.h"

#include "OpenGL/AirlightOpenGL.h"
#include "Pass/AirlightScenePass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

namespace airlight
{
namespace
{
// Texts follow their strings in their opaque stage, which a picture without a new frame leaves out.
void UpdateAnnotations(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState::ScopedglColorMask colorMask(window->GetState());
  vtkOpenGLState::ScopedglDepthMask depthMask(window->GetState());
  window->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  window->GetState()->vtkglDepthMask(GL_FALSE);
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    if (s->GetPropArray()[i]->IsA("vtkActor2D"))
    {
      s->GetPropArray()[i]->RenderOpaqueGeometry(renderer);
    }
  }
}
}

//------------------------------------------------------------------------------
void DrawAnnotations(const vtkRenderState* s)
{
  UpdateAnnotations(s);
  AirlightScenePass::RenderOverlay(s);
}
}
