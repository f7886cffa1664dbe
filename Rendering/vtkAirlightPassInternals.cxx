// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightPassInternals.h"

#include "AirlightOpenGL.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

using namespace airlight;

namespace
{
ShadowMethod GetMethod(int technique)
{
  switch (technique)
  {
    case vtkAirlightPass::SHADOW_PLANES:
      return ShadowMethod::Planes;
    case vtkAirlightPass::SHADOW_MAP:
      return ShadowMethod::Map;
    case vtkAirlightPass::RAY_MARCH:
      return ShadowMethod::March;
    default:
      return ShadowMethod::None;
  }
}
}

//------------------------------------------------------------------------------
vtkAirlightPass::Internals::Internals(vtkAirlightPass* self)
  : Self(self)
{
  this->Context->SetRelease([this](vtkWindow* window) {
    this->CurrentFrame.Release(window);
    this->ScenePass->ReleaseGraphicsResources(window);
  });
}

vtkAirlightPass::Internals::~Internals() { this->Context->SetContext(nullptr); }

//------------------------------------------------------------------------------
vtkRenderPass* vtkAirlightPass::Internals::GetDelegate(bool opaqueOnly)
{
  if (this->Self->DelegatePass)
  {
    return this->Self->DelegatePass;
  }
  this->ScenePass->SetOpaqueOnly(opaqueOnly);
  this->CameraPass->SetDelegatePass(this->ScenePass);
  return this->CameraPass;
}

//------------------------------------------------------------------------------
// A renderer with a pass leaves that out, and a camera learns it from vtkCamera::Render() alone. That
// also clears the viewport, as every frame does.
void vtkAirlightPass::Internals::UpdateStereo(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkCamera* camera = renderer->GetActiveCamera(); // makes one where there is none
  if (camera->GetStereo() != window->GetStereoRender())
  {
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglViewport viewportSaver(state);
    vtkOpenGLState::ScopedglScissor scissorSaver(state);
    vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
    camera->Render(renderer);
    camera->Modified(); // or matrices that VTK keeps would stay
  }
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::RenderPlain(const vtkRenderState* s)
{
  vtkRenderPass* delegate = this->GetDelegate(false);
  delegate->Render(s);
  this->Self->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
// What was there once stays: surfaces that become translucent for a moment shall not make all
// shaders anew each time.
void vtkAirlightPass::Internals::UpdateSurfaceShader(
  const f64::AirlightMedia& media, const std::vector<Lamp>& lamps, bool translucent)
{
  translucent = translucent || this->MapperText.Translucent;
  if (UpdateSurfaceText(
        this->MapperText, media, lamps, this->Self->ScatteredSurfaceLight, translucent))
  {
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::RenderFrame(
  const vtkRenderState* s, int x, int y, int width, int height)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Context->SetContext(window);
  this->ScenePass->PrepareLights(renderer);

  const View view(renderer, width, height);
  if (!view.IsValid())
  {
    this->Error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  std::vector<vtkParticipatingMedium*> media = this->Media.GetAll();
  if (media.empty())
  {
    media.push_back(this->Vacuum);
  }
  f64::AirlightMedia converted = ConvertMedia(media, view.GetEye());
  std::vector<Lamp> lamps =
    CollectLamps(renderer, converted, view, this->Self->LightRadius, this->Lights);
  this->CheckLamps(lamps);
  // A delegate draws everything at once.
  const bool layers = !this->Self->DelegatePass && this->Self->DebugView == SHADED &&
    AirlightScenePass::HasTransparent(s);
  this->MapperText.LayerRecords = ShadowLists::IsSupported(window);
  this->UpdateSurfaceShader(converted, lamps, layers);

  this->EffectiveTechnique = this->ChooseTechnique(window);
  FrameSettings settings;
  settings.Shadows = GetMethod(this->EffectiveTechnique);
  settings.MapResolution = this->Self->ShadowMapResolution;
  settings.Steps = this->Self->NumberOfSteps;
  settings.Draw = [this, s](const std::vector<vtkActor*>& actors, vtkCamera* camera, int x, int y,
                    int side) { this->DrawInMap(s, actors, camera, x, y, side); };
  settings.SurfaceShadows = this->Self->SurfaceShadows;
  settings.TranslucentShadows = this->Self->TranslucentShadows;
  settings.SurfaceGlow = this->Self->ScatteredSurfaceLight;
  settings.Layers = layers;
  settings.LayerRecords = layers && this->MapperText.LayerRecords;
  settings.Record = this->Self->RecordBuffers || this->Self->DebugView == BOUNDARY_COUNT;
  settings.EncodedInput = !this->Self->LinearInput;
  settings.DebugView = this->Self->DebugView;
  for (vtkParticipatingMedium* medium : media)
  {
    settings.PhaseErrorBound = std::max(settings.PhaseErrorBound, medium->GetPhaseErrorBound());
  }
  settings.MemoryLimit = static_cast<std::uint64_t>(this->Self->MemoryLimit) << 20;

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullSaver(state, GL_CULL_FACE);
  state->PushFramebufferBindings();
  const bool ok = this->CurrentFrame.Upload(window, media, converted, lamps) &&
    this->CurrentFrame.Begin(renderer, converted, lamps, view, settings, width, height) &&
    this->RenderSteps(s);
  state->PopFramebufferBindings();
  if (!ok)
  {
    this->Error = this->CurrentFrame.GetError();
    return false;
  }
  if (!this->CurrentFrame.Composite(
        x, y, renderer->GetPreserveColorBuffer() || renderer->Transparent()) ||
    (settings.DebugView == OUTLINES && !this->CurrentFrame.DrawPlanes()))
  {
    this->Error = this->CurrentFrame.GetError();
    return false;
  }
  // A delegate has drawn annotations with the scene, fogged; drawn again they are not.
  this->ScenePass->RenderOverlay(s, !this->Self->DelegatePass);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::IsDrawnLater(vtkProp* prop)
{
  return this->CurrentFrame.HasLayers() && !this->DrawsMap && this->Stage != SurfaceStage::Layer &&
    this->Stage != SurfaceStage::Collect && AirlightScenePass::IsSplats(prop) &&
    std::find(this->FrameProps.begin(), this->FrameProps.end(), prop) != this->FrameProps.end();
}

//------------------------------------------------------------------------------
// The steps inside the pass's own framebuffer.
bool vtkAirlightPass::Internals::RenderSteps(const vtkRenderState* s)
{
  vtkRenderState inner(s->GetRenderer());
  inner.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
  inner.SetFrameBuffer(this->CurrentFrame.GetFramebuffer());

  this->FrameProps.assign(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  this->Self->PreRender(s);
  bool ok = this->CurrentFrame.BindDistances();
  if (ok)
  {
    this->RenderStage(SurfaceStage::Distance, [&] { this->OpaquePass->Render(&inner); });
  }
  ok = ok && this->CurrentFrame.FinishDistances() && this->CollectCasters() &&
    (!this->CurrentFrame.HasLayerRecords() || this->CollectLayers(inner)) &&
    this->CurrentFrame.ScatterLights() && this->CurrentFrame.BindScene();
  if (ok)
  {
    this->RenderStage(SurfaceStage::Colour, [&] {
      vtkRenderPass* delegate = this->GetDelegate(true);
      delegate->Render(&inner);
      this->Self->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
    });
  }
  const bool layers = this->CurrentFrame.HasLayers();
  ok = ok && (!(layers || this->Self->RecordBuffers) || this->CurrentFrame.CompositeLayers());
  if (ok && layers)
  {
    this->RenderStage(SurfaceStage::Layer, [&] { this->ScenePass->RenderTransparent(&inner); });
  }
  this->Self->PostRender(s);
  return ok && (!this->Self->RecordBuffers || this->CurrentFrame.Record());
}

//------------------------------------------------------------------------------
// What a caster that lets light through asks of the mappers' shaders stays, as with translucency.
bool vtkAirlightPass::Internals::CollectCasters()
{
  if (!this->CurrentFrame.CollectCasters())
  {
    return false;
  }
  this->CheckCasters();
  if (this->CurrentFrame.IsDimmed() && !this->MapperText.Dimmed)
  {
    this->MapperText.Dimmed = true;
    this->ShaderTime.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
// Makes the records of translucent fragments.
bool vtkAirlightPass::Internals::CollectLayers(const vtkRenderState& inner)
{
  LayerRecords::Outcome outcome = LayerRecords::Outcome::Again;
  while (outcome == LayerRecords::Outcome::Again)
  {
    if (!this->CurrentFrame.BindCollect())
    {
      return false;
    }
    this->RenderStage(SurfaceStage::Collect, [&] { AirlightScenePass::RenderFragments(&inner); });
    outcome = this->CurrentFrame.CheckCollected();
  }
  return outcome == LayerRecords::Outcome::Done;
}

//------------------------------------------------------------------------------
// Actors outside the view are not among those that the pass has taken hold of.
void vtkAirlightPass::Internals::DrawInMap(const vtkRenderState* s,
  const std::vector<vtkActor*>& actors, vtkCamera* camera, int x, int y, int side)
{
  vtkRenderer* renderer = s->GetRenderer();
  vtkProp** seen = s->GetPropArray();
  std::vector<vtkProp*> unseen;
  std::copy_if(actors.begin(), actors.end(), std::back_inserter(unseen), [&](vtkProp* prop) {
    return std::find(seen, seen + s->GetPropArrayCount(), prop) == seen + s->GetPropArrayCount();
  });
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(unseen.data(), static_cast<int>(unseen.size()));
  this->Self->PreRender(&state);
  const vtkSmartPointer<vtkCamera> own = renderer->GetActiveCamera();
  renderer->SetActiveCamera(camera);
  const View view(renderer, side, side);
  if (view.IsValid())
  {
    this->CurrentFrame.SetMapRays(&view, x, y);
    this->DrawsMap = true;
    this->RenderStage(SurfaceStage::Distance, [&] {
      for (vtkActor* actor : actors)
      {
        actor->RenderOpaqueGeometry(renderer);
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
  for (vtkTextureObject* texture : { values.Lit, values.Data })
  {
    if (texture)
    {
      texture->Activate();
    }
  }
  render();
  for (vtkTextureObject* texture : { values.Lit, values.Data })
  {
    if (texture)
    {
      texture->Deactivate();
    }
  }
}
