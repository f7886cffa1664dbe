// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/vtkAirlightPassInternals.h"

#include "Integration/AirlightIntegrate.h"
#include "MapperShaders/AirlightVolumeShader.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightStorageBinding.h"

#include "vtkCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdint>

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
    this->DepthPrePass.Release();
  });
  this->ScenePass->SetAroundOpaque(
    [this] { this->CurrentFrame.BeginSurfaces(); }, [this] { this->CurrentFrame.EndSurfaces(); });
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
bool vtkAirlightPass::Internals::IsGlowing(const f64::AirlightMedia& media) const
{
  return this->Self->ScatteredSurfaceLight && !HasGrid(media);
}

//------------------------------------------------------------------------------
// What was there once stays: surfaces that become translucent for a moment shall not make all
// shaders anew each time.
void vtkAirlightPass::Internals::UpdateSurfaceShader(const f64::AirlightMedia& media,
  const std::vector<Lamp>& lamps, const FrameSettings& settings, bool parallel)
{
  const bool translucent = settings.Translucent || this->ShaderOptions.Translucent;
  const bool hides = this->ShaderOptions.Hides || this->Self->DelegatePass;
  const bool reads =
    !settings.Once && settings.Shadows != ShadowMethod::None && settings.SurfaceShadows;
  // Shadow maps may be drawn with the same shaders.
  const bool known = settings.Once &&
    (settings.Shadows == ShadowMethod::None || settings.Shadows == ShadowMethod::Planes);
  const bool other = hides != this->ShaderOptions.Hides || reads != this->ShaderOptions.ReadsLit ||
    settings.Once != this->ShaderOptions.Once || settings.Apart != this->ShaderOptions.Apart ||
    known != this->ShaderOptions.KnownView || (known && parallel != this->ShaderOptions.Parallel);
  this->ShaderOptions.KnownView = known;
  this->ShaderOptions.Parallel = known && parallel;
  this->ShaderOptions.Hides = hides;
  this->ShaderOptions.ReadsLit = reads;
  this->ShaderOptions.Once = settings.Once;
  this->ShaderOptions.Apart = settings.Apart;
  if (UpdateSurfaceShaderOptions(
        this->ShaderOptions, media, lamps, this->IsGlowing(media), translucent) ||
    other)
  {
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::RenderFrame(
  const vtkRenderState* s, int x, int y, int width, int height)
{
  this->TooManyPlanes = false;
  bool ok = this->RenderOnce(s, x, y, width, height);
  if (!ok && this->CurrentFrame.IsOverBudget() && this->Self->ShadowTechnique == AUTOMATIC)
  {
    this->WarnOnce(this->WarnedBudget,
      "The shadow planes' boundaries need more than " + std::to_string(ShadowLists::MostBands) +
        " times the memory limit of " + std::to_string(this->Self->MemoryLimit) +
        " MiB, or those of one row of pixels more than that: shadows come from shadow maps, which "
        "are "
        "less exact. Raise SetMemoryLimit(), or call SetShadowTechniqueToShadowMap().");
    this->TooManyPlanes = true;
    ok = this->RenderOnce(s, x, y, width, height);
  }
  return ok;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::Internals::RenderOnce(
  const vtkRenderState* s, int x, int y, int width, int height)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Context->SetContext(window);
  this->ScenePass->PrepareLights(renderer);

  if (!this->CheckOpenGL(window))
  {
    return false;
  }
  const CameraUniforms view(renderer, width, height);
  if (!view.IsValid())
  {
    this->Error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  this->Error = this->Media.CheckImages();
  if (!this->Error.empty())
  {
    return false;
  }
  std::vector<vtkParticipatingMedium*> media = this->Media.GetAll();
  if (media.empty())
  {
    media.push_back(this->Vacuum);
  }
  f64::AirlightMedia converted = ConvertMedia(media, view.GetEye());
  std::vector<Lamp> lamps =
    CollectLamps(renderer, converted, view, this->Self->LightRadius, this->Switches, this->Lights);
  this->CheckLamps(lamps, HasScattering(converted));
  this->EffectiveTechnique = this->ChooseTechnique(renderer, lamps, IsClear(converted));
  if (this->ChangesNothing(lamps, IsClear(converted)))
  {
    this->CurrentFrame.ForgetBuffers();
    this->RenderPlain(s);
    return true;
  }
  const bool overMedium = this->Self->DebugView == SHADED && AirlightScenePass::HasTransparent(s);
  this->ShaderOptions.TranslucentFragments = ShadowLists::IsSupported(window);
  if (this->Self->ScatteredSurfaceLight && !this->IsGlowing(converted))
  {
    this->WarnOnce(this->WarnedGlowInImage,
      "ScatteredSurfaceLight has no effect: the medium's density comes from an image. Surfaces are "
      "lit directly only.");
  }

  FrameSettings settings;
  settings.Shadows = GetMethod(this->EffectiveTechnique);
  settings.MapResolution = this->Self->ShadowMapResolution;
  settings.Steps = this->Self->NumberOfSteps;
  settings.Draw = [this, s](const std::vector<NonPolygonalCaster>& casters, vtkCamera* camera,
                    int x, int y, int side) { this->DrawInMap(s, casters, camera, x, y, side); };
  settings.SurfaceShadows = this->Self->SurfaceShadows;
  settings.TranslucentShadows = this->Self->TranslucentShadows;
  settings.SurfaceGlow = this->IsGlowing(converted);
  settings.Translucent = overMedium;
  settings.TranslucentFragments = overMedium && this->ShaderOptions.TranslucentFragments;
  settings.KnowsAll = this->KnowsAll(s);
  settings.Solid = this->IsSolid(s);
  settings.Once = settings.KnowsAll && this->MayDrawOnce(settings.Solid, lamps, settings.Apart);
  settings.Solids = this->FindSolids(s);
  settings.VolumeNodes =
    GetVolumeNodeCount(GetVolumes(s->GetPropArray(), s->GetPropArrayCount()).size(), width, height,
      static_cast<std::uint64_t>(this->Self->MemoryLimit) << 20);
  settings.Record = this->Self->RecordBuffers || this->Self->DebugView == BOUNDARY_COUNT;
  settings.EncodedInput = !this->Self->LinearInput;
  settings.EncodedOutput = this->Self->EncodedOutput || settings.EncodedInput;
  settings.DebugView = this->Self->DebugView;
  settings.PlaneBudget = this->Self->ShadowTechnique == AUTOMATIC;
  for (vtkParticipatingMedium* medium : media)
  {
    settings.PhaseErrorBound = std::max(settings.PhaseErrorBound, medium->GetPhaseErrorBound());
  }
  settings.Whole = MayBeWhole(settings, converted, lamps);
  this->UpdateSurfaceShader(converted, lamps, settings, view.IsParallel());
  if (this->Materials.Update(s->GetPropArray(), s->GetPropArrayCount(), settings.KnowsAll))
  {
    this->ShaderTime.Modified();
  }
  settings.MemoryLimit = static_cast<std::uint64_t>(this->Self->MemoryLimit) << 20;

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullSaver(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthFunc depthFunctionSaver(state);
  vtkOpenGLState::ScopedglDepthMask depthMaskSaver(state);
  vtkOpenGLState::ScopedglColorMask colorMaskSaver(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunctionSaver(state);
  const ScopedStorageBindings storageSaver(ShadowLists::IsSupported(window));
  state->PushFramebufferBindings();
  this->NotCompiled.clear();
  const bool ok = this->CurrentFrame.Upload(window, media, converted, lamps) &&
    this->CurrentFrame.Begin(renderer, converted, lamps, view, settings, width, height) &&
    this->RenderSteps(s);
  state->PopFramebufferBindings();
  if (!this->CheckShaders())
  {
    return false;
  }
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
  if (this->MayAntialias(s))
  {
    this->ScenePass->Antialias(renderer);
  }
  if (this->Self->Annotations)
  {
    AirlightScenePass::RenderOverlay(s);
  }
  return true;
}
