// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSceneStages.h"

#include "Frame/AirlightFrame.h"
#include "MapperShaders/AirlightVolumeShader.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Pass/AirlightMapperHooks.h"
#include "Pass/AirlightPassMessages.h"
#include "Pass/AirlightSceneSupport.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkOpenGLFramebufferObject.h"
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
  this->ScenePass->SetAroundOpaque(
    [this] { this->CurrentFrame.BeginSurfaces(); }, [this] { this->CurrentFrame.EndSurfaces(); });
}

//------------------------------------------------------------------------------
vtkRenderPass* SceneStages::GetScenePass(bool opaqueOnly)
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
void SceneStages::Begin(const vtkRenderState* s, const SceneSupport& support)
{
  this->State = s;
  this->Support = &support;
  this->Props.assign(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  this->Messages.CheckSupport(support);
  this->Hooks.PreRender(s);
}

void SceneStages::End()
{
  this->ProxyProps.Clear();
  this->Hooks.PostRender(this->State);
  this->State = nullptr;
  this->Support = nullptr;
}

//------------------------------------------------------------------------------
void SceneStages::DrawPlain(const vtkRenderState* s)
{
  vtkRenderPass* delegate = this->GetScenePass(false);
  delegate->Render(s);
  this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void SceneStages::DrawOverFrame(const vtkRenderState* s, bool annotations)
{
  if (this->MayAntialias(s))
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
bool SceneStages::MayAntialias(const vtkRenderState* s)
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
  this->Messages.ReportAntialiasing(given, type == GL_FLOAT);
  return false;
}

//------------------------------------------------------------------------------
// Of what DrawColours() draws: hidden lines are neither drawn nor fogged there.
void SceneStages::DrawDistances()
{
  this->DrawStage(SurfaceStage::Distance, [this] {
    const bool hidesLines = this->Support->HidesLines && !HasOpaquePass(this->Delegate);
    hidesLines ? this->HiddenLinePass->Render(this->State) : this->OpaquePass->Render(this->State);
  });
}

//------------------------------------------------------------------------------
void SceneStages::DrawColours()
{
  this->DrawStage(SurfaceStage::Colour, [this] {
    this->Hidden.clear();
    vtkRenderPass* delegate = this->GetScenePass(true);
    if (this->Delegate)
    {
      vtkRenderState shown(this->State->GetRenderer());
      shown.SetFrameBuffer(this->State->GetFrameBuffer());
      this->ProxyProps.Show(this->State, shown);
      delegate->Render(&shown);
    }
    else
    {
      delegate->Render(this->State);
    }
    this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
  });
}

//------------------------------------------------------------------------------
void SceneStages::UpdateCasters()
{
  this->Messages.CheckCasters(this->CurrentFrame.GetCasters(), this->CurrentFrame.GetPlan());
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
  this->DrawStage(SurfaceStage::Translucent, [this] { this->DrawTranslucentProps(); });
  this->CheckVolumes();
}

//------------------------------------------------------------------------------
// A delegate that draws the renderer's own list has drawn volumes, and what blends in assemblies,
// already.
void SceneStages::DrawTranslucentProps()
{
  if (!this->Delegate || this->ProxyProps.WereDrawn())
  {
    this->ScenePass->RenderTransparent(this->State, FindTranslucentPass(this->Delegate));
    return;
  }
  std::vector<vtkProp*> hidden;
  std::copy_if(this->Props.begin(), this->Props.end(), std::back_inserter(hidden),
    [this](vtkProp* prop) { return this->Hidden.count(prop) > 0; });
  if (hidden.empty())
  {
    return;
  }
  vtkRenderState state(this->State->GetRenderer());
  state.SetFrameBuffer(this->State->GetFrameBuffer());
  state.SetPropArrayAndCount(hidden.data(), static_cast<int>(hidden.size()));
  this->ScenePass->RenderTransparentOf(&state);
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
    if (std::find(this->Props.begin(), this->Props.end(), caster.Owner) == this->Props.end() &&
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
  const CameraUniforms view(renderer, side, side);
  if (view.IsValid())
  {
    this->CurrentFrame.SetMapRays(&view, x, y);
    this->DrawsMap = true;
    this->DrawStage(SurfaceStage::Distance, [&] {
      for (const NonPolygonalCaster& caster : casters)
      {
        DrawCaster(caster, renderer);
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
  this->DepthPrePass.StopObserving();
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
  if (!this->CurrentFrame.GetPlan().Translucent || this->DrawsMap ||
    this->Stage == SurfaceStage::Translucent || this->Stage == SurfaceStage::Collect ||
    !(AirlightScenePass::IsPointGaussians(prop) ||
      (this->Delegate && prop->IsRenderingTranslucentPolygonalGeometry())) ||
    std::find(this->Props.begin(), this->Props.end(), prop) == this->Props.end())
  {
    return false;
  }
  this->Hidden.insert(prop);
  return true;
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
  if (this->Delegate && this->Stage == SurfaceStage::Colour)
  {
    this->CurrentFrame.FitToTarget(values);
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
  if (this->DrawsMap)
  {
    this->MapPrograms.insert(program);
  }
  if (this->Stage == SurfaceStage::Distance)
  {
    this->DepthPrePass.Observe(this->CurrentFrame.GetWindow(), mapper);
  }
}

//------------------------------------------------------------------------------
void SceneStages::SetVolumeUniforms(
  vtkShaderProgram* program, vtkVolume* volume, const SurfaceUniforms& values)
{
  this->VolumesSeen.insert(volume);
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
    if (this->VolumesSeen.count(volume) == 0 && bounds && vtkMath::AreBoundsInitialized(bounds))
    {
      this->Messages.ReportVolumeMapper(volume);
    }
  }
}

//------------------------------------------------------------------------------
void SceneStages::Release(vtkWindow* window)
{
  this->ScenePass->ReleaseGraphicsResources(window);
  this->DepthPrePass.Release();
}
}
