// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightStagePasses.h"

#include "OpenGL/AirlightOpenGL.h"
#include "Pass/AirlightPassMessages.h"

#include "vtkFrameBufferObjectBase.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

namespace airlight
{
//------------------------------------------------------------------------------
vtkRenderPass* StagePasses::GetScenePass(bool opaqueOnly)
{
  if (this->Delegate)
  {
    return this->Delegate;
  }
  this->ScenePass->SetOpaqueOnly(opaqueOnly);
  this->CameraPass->SetDelegatePass(this->ScenePass);
  return this->CameraPass;
}

//------------------------------------------------------------------------------
void StagePasses::DrawAll(const vtkRenderState* s)
{
  vtkRenderPass* pass = this->GetScenePass(false);
  pass->Render(s);
  this->NumberOfRenderedProps = pass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void StagePasses::DrawDistances(const vtkRenderState* s, bool hidesLines)
{
  hidesLines && !HasOpaquePass(this->Delegate) ? this->HiddenLinePass->Render(s)
                                               : this->OpaquePass->Render(s);
}

//------------------------------------------------------------------------------
void StagePasses::DrawOpaque(const vtkRenderState* s)
{
  vtkRenderPass* pass = this->GetScenePass(true);
  if (this->Delegate)
  {
    vtkRenderState shown(s->GetRenderer());
    shown.SetFrameBuffer(s->GetFrameBuffer());
    this->ProxyProps.Show(s, shown);
    pass->Render(&shown);
  }
  else
  {
    pass->Render(s);
  }
  this->NumberOfRenderedProps = pass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
// A delegate that draws the renderer's own list has drawn volumes, and what blends in assemblies,
// already.
void StagePasses::DrawTranslucent(const vtkRenderState* s)
{
  if (!this->Delegate || this->ProxyProps.WereDrawn())
  {
    this->ScenePass->RenderTransparent(s, FindTranslucentPass(this->Delegate));
    return;
  }
  std::vector<vtkProp*> hidden = this->ProxyProps.GetHidden(s);
  if (hidden.empty())
  {
    return;
  }
  vtkRenderState state(s->GetRenderer());
  state.SetFrameBuffer(s->GetFrameBuffer());
  state.SetPropArrayAndCount(hidden.data(), static_cast<int>(hidden.size()));
  this->ScenePass->RenderTransparentOf(&state);
}

//------------------------------------------------------------------------------
void StagePasses::DrawOverFrame(const vtkRenderState* s, bool annotations, PassMessages& messages)
{
  if (this->MayAntialias(s, messages))
  {
    this->ScenePass->Antialias(s->GetRenderer());
  }
  if (annotations)
  {
    AirlightScenePass::RenderOverlay(s);
  }
}

//------------------------------------------------------------------------------
// VTK's FXAA takes the renderer's part of the window, in 8 bits. A delegate stands for a renderer
// with passes, which does without.
bool StagePasses::MayAntialias(const vtkRenderState* s, PassMessages& messages) const
{
  if (!s->GetRenderer()->GetUseFXAA() || this->Delegate)
  {
    return false;
  }
  vtkFrameBufferObjectBase* target = s->GetFrameBuffer();
  if (!target)
  {
    return true;
  }
  int given[2];
  int own[2];
  int origin[2];
  target->GetLastSize(given);
  s->GetRenderer()->GetTiledSizeAndOrigin(&own[0], &own[1], &origin[0], &origin[1]);
  GLint type = GL_NONE;
  glGetFramebufferAttachmentParameteriv(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  if (given[0] == own[0] && given[1] == own[1] && origin[0] == 0 && origin[1] == 0 &&
    type != GL_FLOAT)
  {
    return true;
  }
  messages.ReportAntialiasing(given, type == GL_FLOAT);
  return false;
}
}
