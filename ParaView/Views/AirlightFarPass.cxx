// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightFarPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for the OpenGL loader
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(AirlightFarPass);

namespace
{
// Four steps of a depth buffer of 24 bits before its end. The coordinate is there because VTK's
// quad wants to set it; it is never below 0.
const char* FragmentShader = "//VTK::System::Dec\n"
                             "//VTK::Output::Dec\n"
                             "in vec2 texCoord;\n"
                             "void main()\n"
                             "{\n"
                             "  gl_FragData[0] = vec4(texCoord, 0.0, 0.0);\n"
                             "  gl_FragDepth = texCoord.x < -1.0 ? 1.0 : 1.0 - exp2(-22.0);\n"
                             "}\n";
}

//------------------------------------------------------------------------------
AirlightFarPass::AirlightFarPass() = default;
AirlightFarPass::~AirlightFarPass() = default;

//------------------------------------------------------------------------------
void AirlightFarPass::SetDelegate(vtkRenderPass* delegate) { this->Delegate = delegate; }

//------------------------------------------------------------------------------
void AirlightFarPass::SetBackground(vtkRenderer* renderer)
{
  this->HasBackground = renderer != nullptr;
  if (renderer)
  {
    this->Kept = AirlightFarPass::GetBackground(renderer);
  }
}

//------------------------------------------------------------------------------
AirlightFarPass::Background AirlightFarPass::GetBackground(vtkRenderer* renderer)
{
  Background background;
  renderer->GetBackground(background.Colour);
  background.Gradient = renderer->GetGradientBackground();
  background.Textured = renderer->GetTexturedBackground();
  return background;
}

//------------------------------------------------------------------------------
void AirlightFarPass::PutBackground(vtkRenderer* renderer, const Background& background)
{
  renderer->SetBackground(background.Colour);
  renderer->SetGradientBackground(background.Gradient);
  renderer->SetTexturedBackground(background.Textured);
}

//------------------------------------------------------------------------------
void AirlightFarPass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  const bool selects = renderer->GetSelector() != nullptr;
  if (!this->Draws && !selects)
  {
    renderer->Clear();
    this->NumberOfRenderedProps = 0;
    return;
  }
  this->RenderScene(s);
  if (this->Rendered)
  {
    this->Rendered();
  }
  if (this->Moves && !selects)
  {
    this->MoveBackground(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  }
}

//------------------------------------------------------------------------------
void AirlightFarPass::RenderScene(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  const bool hasBackground = this->HasBackground && !renderer->GetSelector();
  const Background given = AirlightFarPass::GetBackground(renderer);
  if (hasBackground)
  {
    AirlightFarPass::PutBackground(renderer, this->Kept);
  }
  this->Delegate->Render(s);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
  if (hasBackground)
  {
    AirlightFarPass::PutBackground(renderer, given);
    vtkOpenGLState* state =
      vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())->GetState();
    vtkOpenGLState::ScopedglColorMask maskSaver(state);
    vtkOpenGLState::ScopedglClearColor clearSaver(state);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
}

//------------------------------------------------------------------------------
void AirlightFarPass::MoveBackground(vtkOpenGLRenderWindow* window)
{
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, FragmentShader, nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  if (!this->Quad->Program || !this->Quad->Program->GetCompiled())
  {
    vtkErrorMacro(<< "The shader of the background's depth did not compile: the medium before an "
                     "empty background is lost.");
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  vtkOpenGLState::ScopedglDepthMask depthMaskSaver(state);
  vtkOpenGLState::ScopedglDepthFunc depthFuncSaver(state);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  this->Quad->Render();
}

//------------------------------------------------------------------------------
void AirlightFarPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  if (this->Delegate)
  {
    this->Delegate->ReleaseGraphicsResources(window);
  }
}
