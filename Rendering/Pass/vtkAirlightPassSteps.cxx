// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightPass draws of the scene between the steps of a frame, and which props in which.

#include "Pass/vtkAirlightPassInternals.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <iterator>

using namespace airlight;

namespace
{
// As assemblies draw their parts: in their place, with the assembly's keys, which name the passes.
void RenderOther(const NonPolygonalCaster& caster, vtkRenderer* renderer)
{
  vtkActor* actor = caster.Actor;
  if (!caster.Place)
  {
    actor->RenderOpaqueGeometry(renderer);
    return;
  }
  const vtkSmartPointer<vtkInformation> keys = actor->GetPropertyKeys();
  actor->SetPropertyKeys(caster.Owner->GetPropertyKeys());
  actor->PokeMatrix(caster.Place);
  actor->RenderOpaqueGeometry(renderer);
  actor->PokeMatrix(nullptr);
  actor->SetPropertyKeys(keys);
}
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::IsDrawnLater(vtkProp* prop)
{
  if (!this->CurrentFrame.HasTranslucent() || this->DrawsMap ||
    this->Stage == SurfaceStage::Translucent || this->Stage == SurfaceStage::Collect ||
    !(AirlightScenePass::IsPointGaussians(prop) ||
      (this->Self->DelegatePass && prop->IsRenderingTranslucentPolygonalGeometry())) ||
    std::find(this->FrameProps.begin(), this->FrameProps.end(), prop) == this->FrameProps.end())
  {
    return false;
  }
  this->Hidden.insert(prop);
  return true;
}

//------------------------------------------------------------------------------
// The steps inside the pass's own framebuffer.
bool vtkAirlightPass::Internals::RenderSteps(const vtkRenderState* s)
{
  vtkRenderState inner(s->GetRenderer());
  inner.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
  inner.SetFrameBuffer(this->CurrentFrame.GetFramebuffer());

  this->FrameProps.assign(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  this->CheckOutside(s);
  this->Self->PreRender(s);
  const bool once = this->CurrentFrame.IsOnce();
  bool ok = once ? this->DrawColours(inner) : this->DrawDistances(inner);
  ok = ok && this->CollectCasters() &&
    (!this->CurrentFrame.HasTranslucentFragments() || this->CollectTranslucent(inner)) &&
    this->CurrentFrame.ScatterLights();
  ok = ok && (once || this->DrawColours(inner));
  const bool layers = this->CurrentFrame.HasTranslucent();
  ok = ok && (!(layers || this->Self->RecordBuffers) || this->CurrentFrame.CompositeTranslucent());
  if (ok && layers)
  {
    this->NotedVolumes.clear();
    this->RenderStage(SurfaceStage::Translucent, [&] { this->RenderTranslucent(inner); });
    this->CheckVolumes(s);
  }
  this->Shown.Clear();
  this->Self->PostRender(s);
  return ok && (!this->Self->RecordBuffers || this->CurrentFrame.Record());
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::DrawDistances(const vtkRenderState& inner)
{
  if (!this->CurrentFrame.BindDistances())
  {
    return false;
  }
  this->RenderStage(SurfaceStage::Distance, [&] { this->RenderDistances(inner); });
  return this->CurrentFrame.FinishDistances();
}

//------------------------------------------------------------------------------
// Where the scene is drawn once, with distances.
bool vtkAirlightPass::Internals::DrawColours(const vtkRenderState& inner)
{
  if (!(this->CurrentFrame.IsOnce() ? this->CurrentFrame.BindOnce()
                                    : this->CurrentFrame.BindScene()))
  {
    return false;
  }
  this->RenderStage(SurfaceStage::Colour, [&] { this->RenderColours(inner); });
  return true;
}

//------------------------------------------------------------------------------
// Of what the stage of colours draws: hidden lines are neither drawn nor fogged there.
void vtkAirlightPass::Internals::RenderDistances(const vtkRenderState& inner)
{
  if (inner.GetRenderer()->GetUseHiddenLineRemoval() && !HasOpaquePass(this->Self->DelegatePass) &&
    vtkHiddenLineRemovalPass::WireframePropsExist(inner.GetPropArray(), inner.GetPropArrayCount()))
  {
    this->HiddenLinePass->Render(&inner);
  }
  else
  {
    this->OpaquePass->Render(&inner);
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::RenderColours(const vtkRenderState& inner)
{
  this->Hidden.clear();
  vtkRenderPass* delegate = this->GetDelegate(true);
  if (this->Self->DelegatePass)
  {
    vtkRenderState shown(inner.GetRenderer());
    shown.SetFrameBuffer(inner.GetFrameBuffer());
    this->Shown.Show(&inner, shown);
    delegate->Render(&shown);
  }
  else
  {
    delegate->Render(&inner);
  }
  this->Self->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
// What a delegate draws of the renderer's own list, volumes and what blends in assemblies, is there
// already.
void vtkAirlightPass::Internals::RenderTranslucent(const vtkRenderState& inner)
{
  if (!this->Self->DelegatePass || this->Shown.WereDrawn())
  {
    this->ScenePass->RenderTransparent(&inner, FindTranslucentPass(this->Self->DelegatePass));
    return;
  }
  std::vector<vtkProp*> hidden;
  std::copy_if(this->FrameProps.begin(), this->FrameProps.end(), std::back_inserter(hidden),
    [this](vtkProp* prop) { return this->Hidden.count(prop) > 0; });
  if (hidden.empty())
  {
    return;
  }
  vtkRenderState state(inner.GetRenderer());
  state.SetFrameBuffer(inner.GetFrameBuffer());
  state.SetPropArrayAndCount(hidden.data(), static_cast<int>(hidden.size()));
  this->ScenePass->RenderTransparentOf(&state);
}

//------------------------------------------------------------------------------
// What a caster that lets light through asks of the mappers' shaders stays, as with translucency.
bool vtkAirlightPass::Internals::CollectCasters()
{
  if (!this->CurrentFrame.PrepareCasters())
  {
    return false;
  }
  this->CheckCasters();
  if (this->CurrentFrame.HasShadowTransmittance() && !this->ShaderOptions.TransmitsShadows)
  {
    this->ShaderOptions.TransmitsShadows = true;
    this->ShaderTime.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
// Makes the records of translucent fragments.
bool vtkAirlightPass::Internals::CollectTranslucent(const vtkRenderState& inner)
{
  TranslucentFragments::Outcome outcome = TranslucentFragments::Outcome::Again;
  while (outcome == TranslucentFragments::Outcome::Again)
  {
    if (!this->CurrentFrame.BindCollect())
    {
      return false;
    }
    this->RenderStage(SurfaceStage::Collect, [&] { AirlightScenePass::RenderFragments(&inner); });
    outcome = this->CurrentFrame.CheckCollected();
  }
  return outcome == TranslucentFragments::Outcome::Done;
}

//------------------------------------------------------------------------------
// Props outside the view are not among those that the pass has taken hold of.
void vtkAirlightPass::Internals::DrawInMap(const vtkRenderState* s,
  const std::vector<NonPolygonalCaster>& casters, vtkCamera* camera, int x, int y, int side)
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** seen = s->GetPropArray();
  std::vector<vtkProp*> unseen;
  for (const NonPolygonalCaster& caster : casters)
  {
    vtkProp** end = seen + s->GetPropArrayCount();
    if (std::find(seen, end, caster.Owner) == end &&
      std::find(unseen.begin(), unseen.end(), caster.Owner) == unseen.end())
    {
      unseen.push_back(caster.Owner);
    }
  }
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(unseen.data(), static_cast<int>(unseen.size()));
  this->Self->PreRender(&state);
  const vtkSmartPointer<vtkCamera> own = renderer->GetActiveCamera();
  renderer->SetActiveCamera(camera);
  const CameraUniforms view(renderer, side, side);
  if (view.IsValid())
  {
    this->CurrentFrame.SetMapRays(&view, x, y);
    this->DrawsMap = true;
    this->RenderStage(SurfaceStage::Distance, [&] {
      for (const NonPolygonalCaster& caster : casters)
      {
        RenderOther(caster, renderer);
      }
    });
    this->DrawsMap = false;
    this->CurrentFrame.SetMapRays(nullptr, 0, 0);
  }
  // VTK takes lights in the coordinates of a camera changed before for those of its own.
  for (vtkShaderProgram* program : this->MapPrograms)
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::CameraGroup, 0);
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  }
  this->MapPrograms.clear();
  renderer->SetActiveCamera(own);
  this->Self->PostRender(&state);
}

//------------------------------------------------------------------------------
// Draws with the mappers' shaders in this stage and the textures that they read.
void vtkAirlightPass::Internals::RenderStage(
  SurfaceStage stage, const std::function<void()>& render)
{
  this->Stage = stage;
  const SurfaceUniforms values = this->CurrentFrame.GetSurfaceUniforms(stage);
  for (vtkTextureObject* texture : values.GetTextures())
  {
    texture->Activate();
  }
  render();
  this->DepthPrePass.StopObserving();
  for (vtkTextureObject* texture : values.GetTextures())
  {
    texture->Deactivate();
  }
}
