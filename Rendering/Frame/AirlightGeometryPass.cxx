// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightGeometryPass.h"

#include "AirlightCameraShader.h"
#include "AirlightDistancesFS.h"
#include "AirlightMaskFS.h"
#include "OpenGL/AirlightOpenGL.h"
#include "ShadowVolumes/AirlightShadowLists.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

namespace airlight
{
namespace
{
void BlendColours(vtkOpenGLState* state)
{
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}
}

//------------------------------------------------------------------------------
GeometryPass::GeometryPass(Targets& targets)
  : Textures(targets)
{
}

//------------------------------------------------------------------------------
bool GeometryPass::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool GeometryPass::BindDistances(const FrameScene& scene, const FramePlan& plan)
{
  const vtkNew<vtkTextureObject>& target =
    plan.AllShadersInjectable ? this->Textures.Distances : this->Textures.Drawn;
  if (!this->Textures.Bind({ target }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Textures.Clear(-1.0f);
  this->Textures.ClearDepth();
  vtkOpenGLState* state = scene.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  this->HideOthers(scene);
  return true;
}

//------------------------------------------------------------------------------
// What lies at the nearest depth hides whatever is drawn at the pixels that the mask leaves out.
// Without the shader they are drawn for nothing, which is slower. A copy takes a tenth of its time.
void GeometryPass::HideOthers(const FrameScene& scene)
{
  if (!this->Mask)
  {
    return;
  }
  const auto getFormat = [](vtkTextureObject* depth) {
    return depth->GetFormat(VTK_FLOAT, 1, false);
  };
  if (getFormat(this->Mask) == getFormat(this->Textures.Depth) &&
    ShadowLists::IsSupported(scene.Window))
  {
    glCopyImageSubData(this->Mask->GetHandle(), GL_TEXTURE_2D, 0, 0, 0, 0,
      this->Textures.Depth->GetHandle(), GL_TEXTURE_2D, 0, 0, 0, 0, scene.Width, scene.Height, 1);
  }
  else if (this->MaskQuad.GetOrCompile(
             scene.Window, std::string("#version 330\n") + AirlightMaskFS))
  {
    this->MaskQuad.DrawDepths(scene.Window->GetState(), { { "mask", this->Mask } });
  }
}

//------------------------------------------------------------------------------
bool GeometryPass::CompleteDistances(const FrameScene& scene, const FramePlan& plan)
{
  if (plan.AllShadersInjectable)
  {
    return true;
  }
  if (!this->Textures.Bind({ this->Textures.Distances }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  vtkShaderProgram* program = this->DistancesQuad.GetOrCompile(
    scene.Window, std::string("#version 330\n") + AirlightCameraShader + AirlightDistancesFS);
  if (!program)
  {
    return this->Fail(std::string("the shader of distances") + ProgramMaker::GetReason());
  }
  scene.Rays.SetUniforms(program, 0, 0);
  vtkOpenGLState* state = scene.Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  this->DistancesQuad.Draw(
    { { "drawn", this->Textures.Drawn }, { "sceneDepth", this->Textures.Depth } });
  return true;
}

//------------------------------------------------------------------------------
bool GeometryPass::BindColours(
  const FrameScene& scene, const FramePlan& plan, vtkRenderer* renderer)
{
  return plan.SingleGeometryPass ? this->BindSceneAndDistances(scene, plan, renderer)
                                 : this->BindScene(scene);
}

//------------------------------------------------------------------------------
bool GeometryPass::BindScene(const FrameScene& scene)
{
  if (!this->Textures.Bind({ this->Textures.Scene }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  // What a layer above others does not draw stays transparent.
  this->Textures.Clear(0.0f);
  BlendColours(scene.Window->GetState());
  return true;
}

//------------------------------------------------------------------------------
bool GeometryPass::BindSceneAndDistances(
  const FrameScene& scene, const FramePlan& plan, vtkRenderer* renderer)
{
  std::vector<vtkTextureObject*> targets = { this->Textures.Scene, this->Textures.Distances };
  if (plan.ShadowingLight >= 0)
  {
    targets.push_back(this->Textures.WithoutLight);
  }
  if (!this->Textures.Bind(targets, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  scene.Window->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float none[4] = { -1.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 1, none);
  this->Textures.DrawInto(1);
  // What the background does not clear.
  const bool erases = renderer->GetErase() && scene.Window->GetErase();
  if (!erases || renderer->Transparent())
  {
    this->Textures.Clear(0.0f);
  }
  if (!erases || renderer->GetPreserveDepthBuffer())
  {
    this->Textures.ClearDepth();
  }
  BlendColours(scene.Window->GetState());
  scene.Window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  return true;
}

//------------------------------------------------------------------------------
// What is in the picture without the light where no surface is nobody reads. To blend is more work,
// and may round what an opaque fragment writes.
void GeometryPass::BeginSurfaces(const FrameScene& scene, const FramePlan& plan)
{
  this->HideOthers(scene);
  if (plan.SingleGeometryPass)
  {
    this->Textures.DrawInto(plan.ShadowingLight >= 0 ? 3 : 2);
  }
  if (plan.AllOpaque)
  {
    scene.Window->GetState()->vtkglDisable(GL_BLEND);
  }
  else if (plan.SingleGeometryPass)
  {
    glDisablei(GL_BLEND, 1); // distances
  }
}

//------------------------------------------------------------------------------
void GeometryPass::EndSurfaces(const FrameScene& scene, const FramePlan& plan)
{
  if (plan.AllOpaque)
  {
    scene.Window->GetState()->vtkglEnable(GL_BLEND);
  }
  else if (plan.SingleGeometryPass)
  {
    glEnablei(GL_BLEND, 1); // as VTK's record has it
  }
}

//------------------------------------------------------------------------------
bool GeometryPass::BindDepth(const FrameScene& scene)
{
  if (!this->Textures.Bind({}, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  vtkOpenGLState* state = scene.Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  return true;
}

//------------------------------------------------------------------------------
bool GeometryPass::BindRadiance(const FrameScene& scene)
{
  if (!this->Textures.Bind({ this->Textures.Radiance }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  BlendColours(scene.Window->GetState());
  scene.Window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  return true;
}

//------------------------------------------------------------------------------
void GeometryPass::Release()
{
  this->DistancesQuad.Release();
  this->MaskQuad.Release();
}
}
