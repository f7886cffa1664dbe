// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSceneStages.h"

#include "Frame/AirlightFrame.h"
#include "MapperShaders/AirlightVolumeShader.h"
#include "Pass/AirlightMapperHooks.h"
#include "Pass/AirlightPassMessages.h"
#include "Pass/AirlightSceneSupport.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
namespace
{
// As assemblies draw their parts: with the assembly's matrix and keys, which name the passes.
void DrawCaster(const NonPolygonalCaster& caster, vtkRenderer* renderer)
{
  vtkActor* actor = caster.Actor;
  if (!caster.PartToWorld)
  {
    actor->RenderOpaqueGeometry(renderer);
    return;
  }
  const vtkSmartPointer<vtkInformation> keys = actor->GetPropertyKeys();
  actor->SetPropertyKeys(caster.Owner->GetPropertyKeys());
  actor->PokeMatrix(caster.PartToWorld);
  actor->RenderOpaqueGeometry(renderer);
  actor->PokeMatrix(nullptr);
  actor->SetPropertyKeys(keys);
}
}

//------------------------------------------------------------------------------
SceneStages::SceneStages(
  Frame& frame, MapperHooks& mappers, PassMessages& messages, const RenderHooks& hooks)
  : CurrentFrame(frame)
  , Mappers(mappers)
  , Messages(messages)
  , Hooks(hooks)
{
  this->Passes.SetAroundOpaque(
    [this] { this->CurrentFrame.BeginSurfaces(); }, [this] { this->CurrentFrame.EndSurfaces(); });
}

//------------------------------------------------------------------------------
void SceneStages::Begin(const vtkRenderState* s, const SceneSupport& support)
{
  this->State = s;
  this->Support = &support;
  this->Messages.CheckSupport(support);
  this->CallHook(this->Hooks.PreRender);
}

void SceneStages::End()
{
  this->Passes.EndFrame();
  this->CallHook(this->Hooks.PostRender);
  this->State = nullptr;
  this->Support = nullptr;
}

//------------------------------------------------------------------------------
void SceneStages::CallHook(const std::function<void(const vtkRenderState*)>& hook)
{
  std::vector<vtkProp*> props = this->Support->KeyHolders;
  vtkRenderState state(this->State->GetRenderer());
  state.SetFrameBuffer(this->State->GetFrameBuffer());
  state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  hook(&state);
}

//------------------------------------------------------------------------------
// Of what DrawColours() draws: hidden lines are neither drawn nor fogged there.
void SceneStages::DrawDistances()
{
  this->DrawStage(SurfaceStage::Distance, [this] {
    this->DrawOpaqueProps([this](const vtkRenderState* s) {
      this->Passes.DrawDistances(s, this->Support->HidesLines);
    });
  });
}

//------------------------------------------------------------------------------
void SceneStages::DrawColours()
{
  this->DrawStage(SurfaceStage::Colour, [this] {
    this->DrawOpaqueProps([this](const vtkRenderState* s) { this->Passes.DrawOpaque(s); });
  });
}

//------------------------------------------------------------------------------
// Without point Gaussians that blend over the medium later. A delegate draws a scene at once: there
// IsDrawnLater() leaves them out.
void SceneStages::DrawOpaqueProps(const std::function<void(const vtkRenderState*)>& draw)
{
  if (!this->Support->PointGaussians || !this->CurrentFrame.GetPlan().Translucent ||
    this->Passes.GetDelegate())
  {
    draw(this->State);
    return;
  }
  std::vector<vtkProp*> opaque;
  std::remove_copy_if(this->State->GetPropArray(),
    this->State->GetPropArray() + this->State->GetPropArrayCount(), std::back_inserter(opaque),
    AirlightScenePass::IsPointGaussians);
  vtkRenderState state(this->State->GetRenderer());
  state.SetFrameBuffer(this->State->GetFrameBuffer());
  state.SetPropArrayAndCount(opaque.data(), static_cast<int>(opaque.size()));
  draw(&state);
}

//------------------------------------------------------------------------------
void SceneStages::UpdateCasters()
{
  if (this->CurrentFrame.HasShadowTransmittance())
  {
    this->Mappers.AddShadowTransmittance();
  }
}

//------------------------------------------------------------------------------
void SceneStages::CollectFragments()
{
  this->DrawStage(SurfaceStage::Collect,
    [this] { AirlightScenePass::RenderFragments(this->State, this->Support->RayCast); });
}

//------------------------------------------------------------------------------
void SceneStages::DrawTranslucent()
{
  this->VolumesSeen.clear();
  this->DrawStage(SurfaceStage::Translucent, [this] { this->Passes.DrawTranslucent(this->State); });
  this->CheckVolumes();
}

//------------------------------------------------------------------------------
// Props outside the view are not among those that the pass has taken hold of.
void SceneStages::DrawInMap(
  const std::vector<NonPolygonalCaster>& casters, vtkCamera* camera, int x, int y, int side)
{
  vtkRenderer* renderer = this->State->GetRenderer();
  std::vector<vtkProp*> unseen;
  for (const NonPolygonalCaster& caster : casters)
  {
    if (!this->IsDrawn(caster.Owner) &&
      std::find(unseen.begin(), unseen.end(), caster.Owner) == unseen.end())
    {
      unseen.push_back(caster.Owner);
    }
  }
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(unseen.data(), static_cast<int>(unseen.size()));
  this->Hooks.PreRender(&state);
  const vtkSmartPointer<vtkCamera> own = renderer->GetActiveCamera();
  renderer->SetActiveCamera(camera);
  MapFace face{ CameraUniforms(renderer, side, side), x, y, {} };
  if (face.Rays.IsValid())
  {
    this->Face = &face;
    this->DrawStage(SurfaceStage::Distance, [&] {
      for (const NonPolygonalCaster& caster : casters)
      {
        DrawCaster(caster, renderer);
      }
    });
    this->Face = nullptr;
  }
  // VTK takes lights in the coordinates of a camera changed before for those of its own.
  for (vtkShaderProgram* program : face.Programs)
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::CameraGroup, 0);
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  }
  renderer->SetActiveCamera(own);
  this->Hooks.PostRender(&state);
}

//------------------------------------------------------------------------------
// Draws with the mappers' shaders in this stage and the textures that they read.
void SceneStages::DrawStage(SurfaceStage stage, const std::function<void()>& draw)
{
  this->Stage = stage;
  const SurfaceUniforms values = this->CurrentFrame.GetSurfaceUniforms(stage);
  for (vtkTextureObject* texture : values.GetTextures())
  {
    texture->Activate();
  }
  draw();
  this->Variants.StopObserving();
  for (vtkTextureObject* texture : values.GetTextures())
  {
    texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
// Whether what a prop draws in the opaque stages, or in a delegate's own, is left for the one that
// blends over the medium. Parts of assemblies are not.
bool SceneStages::IsDrawnLater(vtkProp* prop)
{
  if (!this->CurrentFrame.GetPlan().Translucent || this->Face ||
    this->Stage == SurfaceStage::Translucent || this->Stage == SurfaceStage::Collect ||
    !(AirlightScenePass::IsPointGaussians(prop) ||
      (this->Passes.GetDelegate() && prop->IsRenderingTranslucentPolygonalGeometry())) ||
    !this->IsDrawn(prop))
  {
    return false;
  }
  this->Passes.Hide(prop);
  return true;
}

//------------------------------------------------------------------------------
bool SceneStages::IsDrawn(vtkProp* prop) const
{
  vtkProp** end = this->State->GetPropArray() + this->State->GetPropArrayCount();
  return std::find(this->State->GetPropArray(), end, prop) != end;
}

//------------------------------------------------------------------------------
void SceneStages::SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop)
{
  SurfaceUniforms values = this->CurrentFrame.GetSurfaceUniforms(this->Stage);
  if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    this->SetVolumeUniforms(program, volume, values);
    return;
  }
  if (this->Face)
  {
    values.Rays = &this->Face->Rays;
    values.ViewportX = this->Face->X;
    values.ViewportY = this->Face->Y;
    this->Face->Programs.insert(program);
  }
  if (this->Passes.GetDelegate() && this->Stage == SurfaceStage::Colour)
  {
    FitToTarget(values, this->State->GetRenderer());
  }
  // A delegate may draw translucent surfaces with the opaque ones, whose bits are not theirs.
  values.UseLit = values.UseLit &&
    !(this->Stage == SurfaceStage::Colour && prop->IsRenderingTranslucentPolygonalGeometry());
  values.Hides = program->IsUniformUsed("airlightHidden");
  values.Hidden = values.Hides && this->IsDrawnLater(prop);
  values.Additive = AirlightScenePass::IsEmissive(prop);
  SetSurfaceUniforms(program, values);
  // VTK leaves the lights of another renderer in a program that both use and that is newer than
  // they.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  if (this->Stage == SurfaceStage::Distance || this->Stage == SurfaceStage::Collect)
  {
    this->Variants.Observe(this->CurrentFrame.GetWindow(), mapper, this->Stage);
  }
}

//------------------------------------------------------------------------------
void SceneStages::SetVolumeUniforms(
  vtkShaderProgram* program, vtkVolume* volume, const SurfaceUniforms& values)
{
  this->VolumesSeen.insert(volume->GetPropertyKeys());
  if (IsVolumeProgram(program))
  {
    SetSurfaceUniforms(program, values);
    airlight::SetVolumeUniforms(program, volume, values);
  }
  else if (this->Stage == SurfaceStage::Translucent && !this->CurrentFrame.IsClear())
  {
    this->Messages.ReportVolumeShader(volume);
  }
}

//------------------------------------------------------------------------------
// Volumes whose mappers requested no uniforms are drawn without the medium before them.
void SceneStages::CheckVolumes()
{
  if (this->CurrentFrame.IsClear())
  {
    return;
  }
  for (vtkVolume* volume : this->Support->Volumes)
  {
    const double* bounds = volume->GetBounds();
    if (this->VolumesSeen.count(volume->GetPropertyKeys()) == 0 && bounds &&
      vtkMath::AreBoundsInitialized(bounds))
    {
      this->Messages.ReportVolumeMapper(volume);
    }
  }
}

//------------------------------------------------------------------------------
void SceneStages::Release(vtkWindow* window)
{
  this->Passes.Release(window);
  this->Variants.Release();
}
}
