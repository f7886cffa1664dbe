// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightFrame.h"

#include "Frame/AirlightSceneDrawer.h"

#include "MapperShaders/AirlightVolumeShader.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Scene/AirlightEquiangularLights.h"
#include "Scene/AirlightUnshadowedLights.h"

#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
bool IsClear(const f64::AirlightMedia& media)
{
  return std::all_of(media.item, media.item + media.count + media.volumes,
    [](const f64::AirlightMedium& medium) { return medium.sigmaT == glm::dvec3(0.0); });
}

//------------------------------------------------------------------------------
Frame::Frame()
  : Geometry(this->Textures)
{
}

//------------------------------------------------------------------------------
bool Frame::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool Frame::Upload(vtkOpenGLRenderWindow* window, const SceneSources& sources,
  f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights)
{
  this->TooMuch = Excess::None;
  return this->Arrays.Upload(window, sources, converted, sceneLights) ||
    this->Fail(this->Arrays.GetError());
}

//------------------------------------------------------------------------------
void Frame::SetMask(vtkTextureObject* mask, bool hides)
{
  this->Mask = mask;
  this->Geometry.SetMask(hides ? mask : nullptr);
}

//------------------------------------------------------------------------------
bool Frame::Begin(const Input& input)
{
  this->Current = input;
  this->Choice.Forget();
  Targets::Needs needs;
  needs.SceneLights = input.SceneLights.size();
  needs.Drawn = !this->Plan.AllShadersInjectable;
  needs.WithoutLight = this->Plan.ShadowingLight >= 0;
  needs.Record = this->Plan.Record;
  needs.Several = this->RecordsSeveral();
  needs.Radiance = this->HasRadiance();
  needs.LightLayers = this->Plan.LightLayers;
  if (!this->Textures.Prepare(
        this->GetWindow(), input.Rays.GetWidth(), input.Rays.GetHeight(), needs))
  {
    return this->Fail(this->Textures.GetError());
  }
  if (this->Arrays.GetTexture())
  {
    this->Slots.Fill(this->GetWindow(), this->Textures.Distances);
  }
  return this->BeginFroxels();
}

//------------------------------------------------------------------------------
bool Frame::Draw(SceneDrawer& scene)
{
  const bool single = this->Plan.SingleGeometryPass;
  if (!(single ? this->DrawColours(scene) : this->DrawDistances(scene)) ||
    !this->LeavesPixelsOut() || !this->PrepareCasters())
  {
    return false;
  }
  scene.UpdateCasters();
  if (!this->CollectFragments(scene) || !this->ScatterLights() ||
    !(single || (this->WalkLightWays() && this->DrawColours(scene))))
  {
    return false;
  }
  if ((this->HasRadiance() || this->Plan.KeepBuffers) && !this->CompositeTranslucent())
  {
    return false;
  }
  if (this->Plan.Translucent)
  {
    scene.DrawTranslucent();
  }
  return true;
}

//------------------------------------------------------------------------------
bool Frame::DrawDistances(SceneDrawer& scene)
{
  if (!this->Geometry.BindDistances(this->GetScene(), this->Plan))
  {
    return this->Fail(this->Geometry.GetError());
  }
  scene.DrawDistances();
  return this->Geometry.CompleteDistances(this->GetScene(), this->Plan) ||
    this->Fail(this->Geometry.GetError());
}

//------------------------------------------------------------------------------
bool Frame::LeavesPixelsOut()
{
  const FramePlan& plan = this->Plan;
  if (!this->ChoosePixels || this->Mask || this->HasRadiance() || plan.KeepBuffers ||
    plan.LinearFrame || plan.View != DebugView::Shaded)
  {
    return true;
  }
  if (!this->Choice.Ask(this->GetScene(), this->Textures, this->ChoosePixels))
  {
    return this->Fail(this->Choice.GetError());
  }
  if (this->Choice.IsSome())
  {
    this->Geometry.SetMask(this->Choice.GetMask());
    this->Geometry.HideOthers(this->GetScene());
  }
  return true;
}

//------------------------------------------------------------------------------
bool Frame::DrawColours(SceneDrawer& scene)
{
  if (!this->Geometry.BindColours(this->GetScene(), this->Plan, this->Current->Renderer))
  {
    return this->Fail(this->Geometry.GetError());
  }
  scene.DrawColours();
  return true;
}

//------------------------------------------------------------------------------
double Frame::EstimateTranslucent(vtkOpenGLRenderWindow* window, const CameraUniforms& rays,
  const f64::AirlightMedia& media, const std::vector<SceneLight>& lights,
  const CasterCache& casters, const std::vector<vtkProp*>& solids)
{
  const FrameScene scene{ window, media, lights, rays, nullptr, nullptr, rays.GetWidth(),
    rays.GetHeight() };
  return this->Shadows.EstimateTranslucent(scene, casters, solids);
}

//------------------------------------------------------------------------------
LightShadows::Options Frame::GetShadowOptions() const
{
  LightShadows::Options options;
  options.Method = this->Plan.Shadows;
  options.SurfaceShadows = this->Plan.SurfaceShadows;
  options.TranslucentShadows = this->Plan.TranslucentShadows;
  options.OpaqueOnly = this->Plan.Froxels;
  options.LimitPlanes = this->Plan.LimitPlanes;
  options.MaximumBoundaries = this->Plan.MaximumBoundaries;
  options.MapNonPolygonal = this->Plan.MapNonPolygonal;
  options.MapResolution = this->Plan.MapResolution;
  options.Steps = this->Plan.Steps;
  options.MemoryLimit = this->Plan.MemoryLimit;
  return options;
}

//------------------------------------------------------------------------------
bool Frame::BeginFroxels()
{
  Froxels::Options options;
  options.Boundaries = this->Plan.TranslucentBoundaries;
  options.MaximumBoundaries = this->Plan.MaximumBoundaries;
  options.Transmits = this->Plan.CastersInFroxels;
  options.Record = this->Plan.Record;
  options.MemoryLimit = this->Plan.MemoryLimit;
  return !this->Plan.Froxels ||
    this->CoarseAir.Begin(this->Current->Renderer, this->GetScene(), options) ||
    this->Fail(this->CoarseAir.GetError());
}

//------------------------------------------------------------------------------
bool Frame::PrepareCasters()
{
  if (!this->Shadows.Prepare(
        this->GetScene(), this->GetShadowOptions(), *this->Current->Casters, this->Current->Solids))
  {
    return this->Fail(this->Shadows.GetError());
  }
  const bool transmits = this->Shadows.TransmitsLight();
  const CameraUniforms& rays = this->Current->Rays;
  return !this->Plan.TranslucentFragments ||
    this->FragmentLists.Prepare(rays.GetWidth(), rays.GetHeight(), transmits,
      transmits ? this->Shadows.GetSurfaceTransmittance().GetSlotCount() : 0) ||
    this->Fail(this->FragmentLists.GetError());
}

//------------------------------------------------------------------------------
// Until the records have room for all fragments. Volumes are content with fewer nodes on a ray.
bool Frame::CollectFragments(SceneDrawer& scene)
{
  if (!this->Plan.TranslucentFragments)
  {
    return true;
  }
  using Outcome = TranslucentFragments::Outcome;
  Outcome outcome = Outcome::Again;
  while (outcome == Outcome::Again)
  {
    if (!this->Geometry.BindDepth(this->GetScene()))
    {
      return this->Fail(this->Geometry.GetError());
    }
    scene.CollectFragments();
    outcome = this->FragmentLists.Check();
    if (outcome == Outcome::TooMany && this->Plan.VolumeNodes > MinimumVolumeNodes)
    {
      this->Plan.VolumeNodes = std::max(this->Plan.VolumeNodes / 2, MinimumVolumeNodes);
      outcome = Outcome::Again;
    }
  }
  this->TooMuch = outcome == Outcome::TooMany ? Excess::Records : this->TooMuch;
  return outcome == Outcome::Done ? this->SortFragments()
                                  : this->Fail(this->FragmentLists.GetError());
}

//------------------------------------------------------------------------------
// Volumes of lower resolution leave the renderer's viewport behind them.
bool Frame::SortFragments()
{
  if (!this->Geometry.BindDepth(this->GetScene()))
  {
    return this->Fail(this->Geometry.GetError());
  }
  return this->FragmentLists.Sort(this->GetWindow()) || this->Fail(this->FragmentLists.GetError());
}

//------------------------------------------------------------------------------
vtkOpenGLRenderWindow* Frame::GetWindow() const
{
  return vtkOpenGLRenderWindow::SafeDownCast(this->Current->Renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
FrameScene Frame::GetScene()
{
  const Input& input = *this->Current;
  return { this->GetWindow(), input.Media, input.SceneLights, input.Rays, this->Arrays.GetTexture(),
    this->Arrays.GetWholeNumbers(), input.Rays.GetWidth(), input.Rays.GetHeight() };
}

//------------------------------------------------------------------------------
InscatterTargets Frame::GetInscatterTargets()
{
  InscatterTargets targets;
  targets.Bind = [this](const std::vector<vtkTextureObject*>& colours, vtkTextureObject* depth) {
    return this->Textures.Bind(colours, depth) ? std::string() : this->Textures.GetError();
  };
  targets.Scattered = { this->Textures.Scattered };
  if (this->Plan.Record)
  {
    targets.Scattered.push_back(this->Textures.Counts);
    targets.Scattered.push_back(this->Textures.Single);
  }
  if (this->HasMoreLit())
  {
    targets.Scattered.push_back(this->Textures.Lit);
  }
  if (this->RecordsSeveral())
  {
    targets.Scattered.push_back(this->Textures.SeveralOfLights);
  }
  targets.Distances = this->Textures.Distances;
  targets.Depth = this->Textures.Depth;
  targets.Mask = this->Choice.IsSome() ? this->Textures.Depth.Get() : this->Mask;
  const CameraUniforms& rays = this->Current->Rays;
  targets.Area = this->Choice.IsSome() ? this->Choice.GetArea()
                                       : PixelArea{ 0, 0, rays.GetWidth(), rays.GetHeight() };
  return targets;
}

//------------------------------------------------------------------------------
bool Frame::ScatterLights()
{
  this->Buffers.Clear();
  if (this->Plan.UnshadowedInComposite)
  {
    this->Shadows.ReleaseMaps(this->GetWindow());
    return true;
  }
  const InscatterTargets targets = this->GetInscatterTargets();
  if (!this->ClearScattered(targets, 0.0f))
  {
    return false;
  }
  if (!this->Shadows.Update(this->GetScene(), targets, this->Current->Casters->GetNonPolygonal(),
        this->Current->DrawInMap))
  {
    return this->Fail(this->Shadows.GetError());
  }
  float litBits = 0.0f;
  const std::vector<int> effective = this->FindEffectiveLights(litBits);
  if (litBits > 0.0f && !this->ClearScattered(targets, litBits))
  {
    return false;
  }
  std::vector<int> unshadowed;
  for (int light : effective)
  {
    if (this->MayJoinOthers(light))
    {
      unshadowed.push_back(light);
    }
    else if (!this->ScatterLight(targets, light))
    {
      return false;
    }
  }
  if (!this->ScatterUnshadowed(targets, unshadowed))
  {
    return false;
  }
  if (this->Plan.Froxels && !this->CoarseAir.Finish(this->GetScene()))
  {
    return this->Fail(this->CoarseAir.GetError());
  }
  // The mappers read what the inscatter shaders wrote.
  if (this->Plan.TranslucentFragments || this->Shadows.TransmitsLight())
  {
    // No test fails without it, see AirlightOpenGL.h.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  return true;
}

//------------------------------------------------------------------------------
// The lights that leave something in the targets, and the bits of the others, which reach all
// surfaces.
std::vector<int> Frame::FindEffectiveLights(float& litBits)
{
  std::vector<int> effective;
  for (int light = 0; light < static_cast<int>(this->Current->SceneLights.size()); ++light)
  {
    if (this->LeavesNothing(light))
    {
      litBits += std::ldexp(1.0f, light);
    }
    else
    {
      effective.push_back(light);
    }
  }
  return effective;
}

//------------------------------------------------------------------------------
// In alpha, the bits of lights that reach all surfaces, see AirlightSurface.glsl.
bool Frame::ClearScattered(const InscatterTargets& targets, float litBits)
{
  if (!this->Textures.Bind(targets.Scattered, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Textures.Clear(0.0f, litBits);
  return true;
}

//------------------------------------------------------------------------------
// Lights that are fixed to the camera have neither power in the medium nor shadows: a pass over the
// pixels for each of them would write nothing but what fragments' records and buffers ask for.
bool Frame::LeavesNothing(int light)
{
  return !this->Plan.Record && !this->Plan.TranslucentFragments && !this->HasMoreLit() &&
    !this->Current->SceneLights[light].HasPower() &&
    this->Shadows.IsUnshadowed(this->GetScene(), light);
}

//------------------------------------------------------------------------------
// Whether a light without shadows may have a step together with others.
bool Frame::MayJoinOthers(int light)
{
  const FrameScene scene = this->GetScene();
  return !this->Plan.Record && !this->Plan.TranslucentFragments && !this->Plan.Froxels &&
    scene.Lights[light].Scatters() && scene.Lights[light].Values.goniometric == 0 &&
    IsEquiangular(scene, light) && this->Shadows.IsUnshadowed(scene, light);
}

//------------------------------------------------------------------------------
bool Frame::ScatterUnshadowed(const InscatterTargets& targets, const std::vector<int>& lights)
{
  for (size_t first = 0; first < lights.size(); first += MaximumUnshadowedLights)
  {
    const size_t end = std::min(first + MaximumUnshadowedLights, lights.size());
    if (!this->Inscatter.DrawUnshadowed(
          this->GetScene(), targets, { lights.begin() + first, lights.begin() + end }))
    {
      return this->Fail(this->Inscatter.GetError());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// With its recording, which clears the target of a single light for the next one.
bool Frame::ScatterLight(const InscatterTargets& targets, int light)
{
  InscatterOptions options;
  options.Record = this->Plan.Record;
  options.PhaseErrorBound = this->Plan.PhaseErrorBound;
  options.MultipleErrorBound = this->Plan.MultipleErrorBound;
  options.Records = this->Plan.TranslucentFragments ? &this->FragmentLists : nullptr;
  if (this->Current->SceneLights[light].Scatters() &&
    !this->Inscatter.Draw(this->GetScene(), options, targets, this->Shadows, light))
  {
    this->TooMuch = this->Shadows.IsOverBudget() ? Excess::Boundaries : Excess::None;
    return this->Fail(this->Inscatter.GetError());
  }
  if (this->Plan.Froxels && this->Current->SceneLights[light].Scatters() &&
    !this->CoarseAir.ScatterLight(this->GetScene(), light, this->Current->Casters->GetCasters(),
      this->Shadows.GetMap(light), targets))
  {
    return this->Fail(this->CoarseAir.GetError());
  }
  if (this->Plan.Record)
  {
    if (!this->Buffers.RecordLight(this->Textures, light))
    {
      return this->Fail(this->Textures.GetError());
    }
    this->Textures.Clear(0.0f);
  }
  return true;
}

//------------------------------------------------------------------------------
bool Frame::WalkLightWays()
{
  return this->Plan.LightLayers == 0 ||
    this->LightWays.Draw(this->GetScene(), this->Plan.LightLayers, this->Textures) ||
    this->Fail(this->LightWays.GetError());
}

//------------------------------------------------------------------------------
ShadowTechnique Frame::GetTechnique() const
{
  return this->Shadows.HasMap()   ? ShadowTechnique::Map
    : this->Plan.CastersInFroxels ? ShadowTechnique::Froxels
                                  : this->Plan.Technique;
}

//------------------------------------------------------------------------------
ShadowTechnique Frame::GetTechnique(const vtkLight* light) const
{
  switch (this->Shadows.GetMethod(light))
  {
    case ShadowMethod::Planes:
      return this->Plan.CastersInFroxels ? ShadowTechnique::Froxels : ShadowTechnique::Planes;
    case ShadowMethod::Map:
      return ShadowTechnique::Map;
    case ShadowMethod::March:
      return ShadowTechnique::March;
    default:
      return ShadowTechnique::None;
  }
}

//------------------------------------------------------------------------------
bool Frame::Record()
{
  return this->Buffers.Record(this->Textures, this->RecordsSeveral()) ||
    this->Fail(this->Textures.GetError());
}

//------------------------------------------------------------------------------
CompositePass::Options Frame::GetCompositeOptions() const
{
  CompositePass::Options options;
  options.Unshadowed = this->Plan.UnshadowedInComposite;
  options.Equiangular = !this->Shadows.TransmitsLight();
  options.ShadowingLight = this->Plan.ShadowingLight;
  options.LightsPerChannel = BitsPerChannel;
  options.DebugView = static_cast<int>(this->Plan.View);
  options.Record = this->Plan.Record;
  options.Several = this->RecordsSeveral();
  options.DiffuseError =
    std::max(ClosedFormError, static_cast<float>(this->Plan.MultipleErrorBound));
  options.EncodedInput = this->Plan.EncodedInput;
  options.Suns = this->Current->Suns;
  options.Masked = this->Mask != nullptr;
  options.Chosen = this->Choice.IsSome();
  return options;
}

//------------------------------------------------------------------------------
CompositePass::Inputs Frame::GetCompositeInputs()
{
  CompositePass::Inputs inputs;
  inputs.Distances = this->Textures.Distances;
  inputs.Depth = this->Textures.Depth;
  inputs.Scene = this->Textures.Scene;
  inputs.SceneWithoutLight = this->Textures.WithoutLight;
  inputs.Scattered = this->Textures.Scattered;
  inputs.MoreLit = this->Textures.Lit;
  inputs.Counts = this->Textures.Counts;
  inputs.SeveralOfLights = this->Textures.SeveralOfLights;
  return inputs;
}

//------------------------------------------------------------------------------
bool Frame::CompositeTranslucent()
{
  std::vector<vtkTextureObject*> targets = { this->Textures.Radiance };
  if (this->Plan.Record)
  {
    targets.insert(targets.end(),
      { this->Textures.Airlight, this->Textures.Surface, this->Textures.Transmittance });
  }
  if (this->RecordsSeveral())
  {
    targets.push_back(this->Textures.Several);
  }
  if (!this->Textures.Bind(targets, this->Mask))
  {
    return this->Fail(this->Textures.GetError());
  }
  if (!this->Composition.DrawIntoTextures(
        this->GetScene(), this->GetCompositeOptions(), this->GetCompositeInputs()))
  {
    return this->Fail(this->Composition.GetError());
  }
  return this->Geometry.BindRadiance(this->GetScene()) || this->Fail(this->Geometry.GetError());
}

//------------------------------------------------------------------------------
bool Frame::Composite(int x, int y, const DisplayStage& display, bool blend)
{
  const FrameScene scene = this->GetScene();
  const CompositePass::Inputs inputs = this->GetCompositeInputs();
  CompositePass::Options options = this->GetCompositeOptions();
  options.Display = display;
  const bool ok = this->HasRadiance()
    ? this->Composition.CopyIntoViewport(
        scene, options, inputs, this->Textures.Radiance, x, y, blend)
    : this->Composition.DrawIntoViewport(scene, options, inputs, x, y, blend);
  return ok || this->Fail(this->Composition.GetError());
}

//------------------------------------------------------------------------------
bool Frame::DrawPlanes()
{
  return this->Shadows.DrawWireframe(this->GetScene(), this->Textures.Distances) ||
    this->Fail(this->Shadows.GetError());
}

//------------------------------------------------------------------------------
SurfaceUniforms Frame::GetSurfaceUniforms(SurfaceStage stage)
{
  SurfaceUniforms values;
  values.Stage = stage;
  const Input& input = *this->Current;
  values.Rays = &input.Rays;
  values.Width = input.Rays.GetWidth();
  values.Height = input.Rays.GetHeight();
  values.VolumeNodes = this->Plan.VolumeNodes;
  values.Media = &input.Media;
  values.CastingVolumes = &input.CastingVolumes;
  values.SceneLights = &input.SceneLights;
  values.Lit = this->Textures.Scattered;
  values.MoreLit = this->HasMoreLit() ? this->Textures.Lit : this->Textures.Scattered;
  if (this->Plan.LightLayers > 0)
  {
    values.LightWays = this->Textures.LightWays;
    values.LightLayers = LightWaysPass::GetLayers(this->GetScene(), this->Plan.LightLayers);
  }
  values.Data = this->Arrays.GetTexture();
  values.Samples = this->Arrays.GetWholeNumbers();
  values.ScatteredIrradiance = this->Plan.ScatteredSurfaceLight;
  values.Records = this->Plan.TranslucentFragments ? &this->FragmentLists : nullptr;
  values.Transmittances = &this->Shadows.GetSurfaceTransmittance();
  values.Froxels = this->Plan.Froxels ? &this->CoarseAir.GetNodes() : nullptr;
  // Without records the bits are those of the opaque surface, which lies behind the layers.
  values.UseLit = this->Plan.Shadows != ShadowMethod::None && this->Plan.SurfaceShadows &&
    (stage != SurfaceStage::Translucent ? !this->Plan.SingleGeometryPass
                                        : values.Records || values.Froxels);
  return values;
}

//------------------------------------------------------------------------------
void Frame::ReleaseObjects(vtkWindow* window)
{
  this->Geometry.Release();
  this->Inscatter.Release();
  this->LightWays.Release();
  this->Choice.Release(window);
  this->Composition.Release();
  this->FragmentLists.Release();
  this->CoarseAir.Release(window);
  this->Shadows.ReleaseObjects(window);
  this->Textures.Release(window);
  this->Arrays.Release(window);
  this->Slots.Release();
}

//------------------------------------------------------------------------------
void Frame::Release(vtkWindow* window)
{
  this->ReleaseObjects(window);
  this->Shadows.Release(window);
}
}
