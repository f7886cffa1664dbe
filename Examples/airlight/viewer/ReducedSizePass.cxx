// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/ReducedSizePass.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

namespace airlight
{

vtkStandardNewMacro(ReducedSizePass);

//------------------------------------------------------------------------------
void ReducedSizePass::Render(const vtkRenderState* s)
{
  if (this->PixelSize <= 1)
  {
    this->DelegatePass->Render(s);
    this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
    return;
  }
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  const int* size = renderer->GetSize();
  const int width = (size[0] + this->PixelSize - 1) / this->PixelSize;
  const int height = (size[1] + this->PixelSize - 1) / this->PixelSize;
  this->RenderSmall(s, window, width, height);
  this->Enlarge(renderer, window);
  this->Overlay->Render(s);
  this->NumberOfRenderedProps =
    this->DelegatePass->GetNumberOfRenderedProps() + this->Overlay->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void ReducedSizePass::Resize(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (!this->Framebuffer)
  {
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Color = vtkSmartPointer<vtkTextureObject>::New();
    this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Framebuffer->SetContext(window);
  this->Color->SetContext(window);
  this->Depth->SetContext(window);
  if (!this->Color->GetHandle())
  {
    const auto w = static_cast<unsigned int>(width);
    const auto h = static_cast<unsigned int>(height);
    this->Color->Create2D(w, h, 4, VTK_UNSIGNED_CHAR, false);
    this->Color->SetMinificationFilter(vtkTextureObject::Linear);
    this->Color->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Color->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Color->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Depth->AllocateDepth(w, h, vtkTextureObject::Float32);
  }
  this->Color->Resize(static_cast<unsigned int>(width), static_cast<unsigned int>(height));
  this->Depth->Resize(static_cast<unsigned int>(width), static_cast<unsigned int>(height));
}

//------------------------------------------------------------------------------
void ReducedSizePass::RenderSmall(
  const vtkRenderState* s, vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Resize(window, width, height);
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->StartNonOrtho(width, height);
  vtkRenderState small(s->GetRenderer());
  small.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
  small.SetFrameBuffer(this->Framebuffer);
  this->DelegatePass->Render(&small);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void ReducedSizePass::Enlarge(vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable blending(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglViewport(left, bottom, width, height);
  this->Color->CopyToFrameBuffer(nullptr, nullptr);
}

//------------------------------------------------------------------------------
void ReducedSizePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Overlay->ReleaseGraphicsResources(window);
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Color->ReleaseGraphicsResources(window);
    this->Depth->ReleaseGraphicsResources(window);
  }
}

}
