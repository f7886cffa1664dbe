// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightPassRenderer.h"

#include "Integration/AirlightIntegrate.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Pass/AirlightAnnotations.h"
#include "Pass/AirlightErrorRecovery.h"
#include "Pass/AirlightGaussianFragments.h"
#include "Pass/AirlightSceneSupport.h"
#include "Pass/AirlightStateSaver.h"
#include "Pass/AirlightWiderRange.h"
#include "Scene/AirlightSceneProps.h"
#include "Scene/AirlightVolumeCheck.h"

#include "vtkCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <optional>

namespace airlight
{
// A renderer's scene in one frame.
struct PassRenderer::Scene
{
  Scene(vtkRenderer* renderer, int width, int height)
    : Window(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
    , Rays(renderer, width, height)
  {
  }

  vtkOpenGLRenderWindow* Window;
  CameraUniforms Rays;
  SceneSources Sources;
  std::vector<vtkVolume*> CastingVolumes;
  f64::AirlightMedia Converted{};
  std::vector<SceneLight> Lights;
  SceneProps Props;
  std::optional<SceneSupport> Support;
};

namespace
{
// A renderer with a pass leaves out that the camera learns whether it is one of a stereo pair,
// which it learns from vtkCamera::Render() alone. That also clears the viewport, as every frame
// does.
void UpdateStereo(vtkRenderer* renderer)
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

// Whether a frame goes over what the framebuffer holds.
bool IsBlended(vtkRenderer* renderer)
{
  return renderer->GetPreserveColorBuffer() || renderer->Transparent();
}

// The same for other props, which must outlive it.
void SetState(const vtkRenderState& from, std::vector<vtkProp*>& props, vtkRenderState& to)
{
  to.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  to.SetFrameBuffer(from.GetFrameBuffer());
  to.SetRequiredKeys(from.GetRequiredKeys());
}
}

//------------------------------------------------------------------------------
PassRenderer::PassRenderer(vtkObject* pass, const SceneStages::RenderHooks& hooks)
  : Pass(pass)
  , Messages(pass)
  , Mappers(pass)
  , Stages(this->CurrentFrame, this->Mappers, this->Messages, hooks)
{
  this->Context->SetRelease([this](vtkWindow* window) {
    this->CurrentFrame.Release(window);
    this->Mean.Release(window);
    this->Edges.Release(window);
    this->Refined.Forget();
    this->Lamps.Release(window);
    this->Exposure.Release(window);
    this->Casters.Clear();
    this->Stages.Release(window);
    this->Mappers.Release();
  });
}

PassRenderer::~PassRenderer() { this->Context->SetContext(nullptr); }

//------------------------------------------------------------------------------
void PassRenderer::Render(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  this->Stages.GetPasses().SetDelegate(settings.Delegate);
  UpdateStereo(s->GetRenderer());
  // Picking reads colours as numbers: nothing may change them.
  if (s->GetRenderer()->GetSelector())
  {
    this->Stages.GetPasses().DrawAll(s);
    return;
  }
  std::vector<vtkProp*> props = this->FindProps(s);
  const std::vector<vtkProp*>& lamps =
    this->Lamps.Update(s->GetRenderer(), settings.Properties.LinearInput);
  props.insert(props.end(), lamps.begin(), lamps.end());
  vtkRenderState state(s->GetRenderer());
  SetState(*s, props, state);
  this->Suns = CollectSunDiscs(s->GetRenderer());
  const WiderRange range(s->GetRenderer()->GetActiveCamera(), this->Lamps.GetRange());
  this->RenderScene(&state, settings, viewport);
}

//------------------------------------------------------------------------------
// What is drawn: all props but volumes that are media.
std::vector<vtkProp*> PassRenderer::FindProps(const vtkRenderState* s)
{
  std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  this->MediaOfVolumes.clear();
  this->VolumesAsMedia.clear();
  for (const VolumeMedium& found : this->ScatteringVolumes.Update(s->GetRenderer()))
  {
    const bool fits = this->Media.GetSize() + this->MediaOfVolumes.size() < AIRLIGHT_MAX_MEDIA;
    if (found.Medium && fits)
    {
      this->MediaOfVolumes.push_back(found.Medium);
      const auto end = std::remove(props.begin(), props.end(), found.Volume);
      if (end != props.end())
      {
        this->VolumesAsMedia.push_back(found.Volume);
      }
      props.erase(end, props.end());
    }
    this->Messages.ReportVolume(found.Medium && !fits
        ? DescribeNoMedium(found.Volume,
            "there are " + std::to_string(AIRLIGHT_MAX_MEDIA) +
              " media already: call RemoveMedium() or SetVolumeScatters(volume, false) for others")
        : found.Error);
  }
  return props;
}

//------------------------------------------------------------------------------
void PassRenderer::RenderScene(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  this->Messages.CheckMedia(this->Media);
  const bool mean = settings.SubpixelFrames > 1 &&
    SubpixelFrames::MayAverage(s->GetRenderer(), settings.Properties.View);
  this->AccumulatedFrames = 1;
  this->Unfinished = false;
  if (!mean)
  {
    this->Refined.Forget(); // this frame's buffers and depths replace the mean's
  }
  const bool multisampled = !mean && settings.Multisampling &&
    SubpixelFrames::MayAverage(s->GetRenderer(), settings.Properties.View);
  if (mean           ? this->RenderMean(s, settings, viewport)
      : multisampled ? this->RenderMultisampled(s, settings, viewport)
                     : this->RenderFrame(s, settings, viewport))
  {
    this->Messages.ForgetFrame();
    return;
  }
  this->Messages.ReportFrame(this->Error);
  this->AccumulatedFrames = 1;
  this->Unfinished = false;
  this->EffectiveExposure = 1.0; // VTK's picture
  this->Recover();
  this->DrawWithoutMedia(s);
}

//------------------------------------------------------------------------------
// With the volumes that would have been media.
void PassRenderer::DrawWithoutMedia(const vtkRenderState* s)
{
  std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  props.insert(props.end(), this->VolumesAsMedia.begin(), this->VolumesAsMedia.end());
  vtkRenderState all(s->GetRenderer());
  SetState(*s, props, all);
  this->Stages.GetPasses().DrawAll(&all);
}

//------------------------------------------------------------------------------
// What pictures of several frames have in common. `draw` draws one after the framebuffer that
// `saver` keeps is bound again.
bool PassRenderer::RenderSeveral(const vtkRenderState* s, const Settings& settings,
  const std::function<bool(StateSaver& saver)>& draw)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
  this->Context->SetContext(window);
  if (!CheckOpenGL(window, this->Error))
  {
    return false;
  }
  this->Error.clear();
  StateSaver saver(window, ShadowLists::IsSupported(window));
  if (!draw(saver))
  {
    return false;
  }
  // Without FXAA, which would blur edges that are smooth.
  if (settings.Properties.Annotations)
  {
    DrawAnnotations(s);
  }
  return true;
}

//------------------------------------------------------------------------------
bool PassRenderer::FindDisplay(vtkRenderer* renderer, const Settings& settings,
  vtkTextureObject* radiances, const glm::ivec4& picture, DisplayStage& display)
{
  display = GetDisplay(settings.Properties, this->CurrentFrame.IsClear());
  this->EffectiveExposure = display.Exposure;
  return !MeasuresExposure(settings.Properties) ||
    this->MeasureExposure(renderer, radiances, picture, display);
}

//------------------------------------------------------------------------------
bool PassRenderer::RenderMean(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  vtkRenderer* renderer = s->GetRenderer();
  const glm::ivec4 picture(viewport.X, viewport.Y, viewport.Width, viewport.Height);
  return this->RenderSeveral(s, settings, [&](StateSaver& saver) {
    if (!this->AddFrames(s, settings, viewport))
    {
      this->Refined.Forget();
      return this->Error.empty() ? this->Fail(this->Mean.GetError()) : false;
    }
    DisplayStage display;
    if (!this->FindDisplay(renderer, settings, this->Mean.GetRadiance(), picture, display))
    {
      return false;
    }
    saver.PopFramebuffer();
    return this->Mean.DrawIntoViewport(picture, display, IsBlended(renderer)) ||
      this->Fail(this->Mean.GetError());
  });
}

//------------------------------------------------------------------------------
// A plain picture has the window's own samples.
bool PassRenderer::RenderMultisampled(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  this->FoundPlain = false;
  const bool ok = this->RenderSamples(s, settings, viewport);
  this->EdgeMask = nullptr;
  return this->FoundPlain ? this->RenderFrame(s, settings, viewport) : ok;
}

//------------------------------------------------------------------------------
bool PassRenderer::RenderSamples(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  vtkRenderer* renderer = s->GetRenderer();
  Settings frame = settings;
  frame.Properties.LinearFrame = true;
  frame.Properties.EdgeSample = true;
  const glm::ivec2 size(viewport.Width, viewport.Height);
  double exposure = 1.0;
  const auto getDisplay = [&](DisplayStage& display) {
    const bool found = this->FindDisplay(
      renderer, settings, this->Edges.GetRadiance(), { 0, 0, size.x, size.y }, display);
    exposure = display.Exposure;
    return found;
  };
  const auto renderFrame = [&](vtkTextureObject* mask) {
    this->EdgeMask = mask;
    return this->RenderFrame(s, frame, { 0, 0, size.x, size.y });
  };
  return this->RenderSeveral(s, settings, [&](StateSaver& saver) {
    bool ok = this->Edges.Render(renderer, size, IsBlended(renderer),
      this->CurrentFrame.GetBuffers(), getDisplay, renderFrame);
    this->EffectiveExposure = exposure; // that of the frames is 1
    saver.PopFramebuffer();
    ok = ok &&
      this->Edges.DrawIntoViewport({ viewport.X, viewport.Y, size.x, size.y }, IsBlended(renderer));
    return ok || (this->Error.empty() && this->Fail(this->Edges.GetError()));
  });
}

//------------------------------------------------------------------------------
bool PassRenderer::AddFrames(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  vtkRenderer* renderer = s->GetRenderer();
  const glm::ivec4 picture(viewport.X, viewport.Y, viewport.Width, viewport.Height);
  Settings frame = settings;
  frame.Properties.LinearFrame = true;
  const bool remote = this->CurrentFrame.HasRemoteSilhouettes();
  // Silhouettes of other processes are those of lamps in their middles.
  this->Mean.SetMovesLamps(!remote);
  SubpixelFrames::Range range{ 0, settings.SubpixelFrames, settings.SubpixelFrames };
  const bool refines = settings.Progressive && !remote && Refinement::MayRefine(s);
  const Refinement::Picture refined{ s, this->Pass, settings.Delegate, picture, range.Count,
    settings.Requested };
  if (refines)
  {
    const Refinement::Frames frames = this->Refined.Begin(refined);
    range.First = frames.First;
    range.Last = frames.Last;
  }
  const auto progress = [&](double share) {
    this->AccumulatedFrames = this->Mean.GetDone();
    if (refines)
    {
      this->Refined.Keep(refined, this->AccumulatedFrames);
    }
    return settings.Progress(share);
  };
  if (!this->Mean.Render(renderer, picture, range, this->CurrentFrame.GetBuffers(), progress,
        [&] { return this->RenderFrame(s, frame, viewport); }))
  {
    return false;
  }
  this->AccumulatedFrames = this->Mean.GetDone();
  this->Unfinished = refines && this->AccumulatedFrames < range.Count;
  if (!refines)
  {
    this->Refined.Forget();
    this->CurrentFrame.GetBuffers().ClearMean();
  }
  return true;
}

//------------------------------------------------------------------------------
bool PassRenderer::MeasureExposure(vtkRenderer* renderer, vtkTextureObject* radiances,
  const glm::ivec4& picture, DisplayStage& display)
{
  if (!this->Exposure.Measure(renderer, radiances, picture))
  {
    return this->Fail(this->Exposure.GetError());
  }
  // Single precision holds no more.
  display.Exposure = std::min(display.Exposure * this->Exposure.GetExposure(), 1e30);
  this->EffectiveExposure = display.Exposure;
  return true;
}

//------------------------------------------------------------------------------
bool PassRenderer::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
// What needs too much memory is found out while it is drawn: the frame then does without shadow
// planes, or without records of translucent fragments.
bool PassRenderer::RenderFrame(
  const vtkRenderState* s, const Settings& settings, const Viewport& viewport)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->Context->SetContext(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  this->Stages.GetPasses().PrepareLights(renderer);
  Scene scene(renderer, viewport.Width, viewport.Height);
  if (!CheckOpenGL(scene.Window, this->Error) || !this->CollectScene(s, settings, scene))
  {
    return false;
  }
  this->CollectProps(s, settings, scene);
  FrameLimits limits;
  limits.StorageBuffers = ShadowLists::IsSupported(scene.Window);
  limits.RecordsOverMemory = this->TooManyRecords == RecordsKey(scene);
  bool ok = this->RenderPlan(s, settings, viewport, limits, scene);
  if (!ok && this->CurrentFrame.GetExcess() == Frame::Excess::Records)
  {
    this->TooManyRecords = RecordsKey(scene);
    limits.RecordsOverMemory = true;
    ok = this->RenderPlan(s, settings, viewport, limits, scene);
  }
  if (!ok && this->CurrentFrame.GetExcess() == Frame::Excess::Boundaries &&
    settings.Properties.Technique == ShadowTechnique::Automatic)
  {
    limits.PlanesOverMemory = true;
    ok = this->RenderPlan(s, settings, viewport, limits, scene);
  }
  if (ok)
  {
    this->Error.clear(); // of a plan that was tried before
  }
  return ok;
}

//------------------------------------------------------------------------------
// Records are tried again if something else is drawn, or in another size: each try makes the
// shaders of all mappers again.
std::array<size_t, 3> PassRenderer::RecordsKey(const Scene& scene)
{
  return { static_cast<size_t>(scene.Rays.GetWidth()), static_cast<size_t>(scene.Rays.GetHeight()),
    scene.Props.GetProps().size() };
}

//------------------------------------------------------------------------------
bool PassRenderer::RenderPlan(const vtkRenderState* s, const Settings& settings,
  const Viewport& viewport, const FrameLimits& limits, Scene& scene)
{
  const PassProperties& properties = settings.Properties;
  SceneFacts facts = this->GetFacts(scene);
  if (properties.Technique == ShadowTechnique::Automatic && limits.StorageBuffers &&
    facts.Volumes == 0 && !this->CurrentFrame.HasRemoteSilhouettes())
  {
    facts.TranslucentBoundaries = this->CurrentFrame.EstimateTranslucent(scene.Window, scene.Rays,
      scene.Converted, scene.Lights, this->Casters, scene.Support->Solids);
    facts.GaussianFragments = EstimateGaussianFragments(scene.Props, scene.Rays);
  }
  const FramePlan plan = MakeFramePlan(properties, facts, limits);
  this->CurrentFrame.SetPlan(plan);
  this->EffectiveExposure = plan.Plain ? 1.0 : plan.Display.Exposure;
  this->Messages.CheckPlan(plan, properties, this->Casters, scene.Window);
  this->Messages.CheckColorSpace(plan.Display, scene.Window);
  // Whether nothing that draws the scene reads the pixels beside its own.
  const bool hides = !settings.Delegate && !plan.Froxels && facts.Volumes == 0 &&
    !s->GetRenderer()->GetUseSSAO() && !s->GetRenderer()->GetUseHiddenLineRemoval();
  this->CurrentFrame.SetMask(this->EdgeMask, hides);
  this->CurrentFrame.SetPixelChooser(hides ? settings.ChoosePixels : nullptr);
  this->FoundPlain = plan.Plain && properties.EdgeSample;
  if (this->FoundPlain)
  {
    return false;
  }
  if (plan.Plain)
  {
    this->CurrentFrame.ForgetBuffers();
    this->Stages.GetPasses().DrawAll(s);
    return true;
  }
  this->Messages.CheckCasters(this->Casters, plan);
  this->Mappers.Update(plan, scene.Converted, scene.Lights,
    { scene.Window, limits.StorageBuffers, scene.Rays.IsParallel(), settings.Delegate != nullptr,
      scene.Support->Actors });
  return this->Draw(s, plan, scene, viewport);
}

//------------------------------------------------------------------------------
// Null without one.
const SkyHarmonics* PassRenderer::FindEnvironment(vtkRenderer* renderer, const Settings& settings)
{
  if (!settings.Environment)
  {
    return nullptr;
  }
  const double* up = renderer->GetEnvironmentUp();
  const double* right = renderer->GetEnvironmentRight();
  std::string error;
  const bool found = this->Sky.Update(renderer->GetEnvironmentTexture(),
    glm::dvec3(up[0], up[1], up[2]), glm::dvec3(right[0], right[1], right[2]), error);
  this->Messages.CheckEnvironment(error);
  return found ? &this->Sky.GetHarmonics() : nullptr;
}

//------------------------------------------------------------------------------
bool PassRenderer::CollectScene(const vtkRenderState* s, const Settings& settings, Scene& scene)
{
  if (!scene.Rays.IsValid())
  {
    this->Error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  scene.Sources.Media = this->Media.GetAll();
  scene.Sources.Media.insert(
    scene.Sources.Media.end(), this->MediaOfVolumes.begin(), this->MediaOfVolumes.end());
  if (scene.Sources.Media.empty())
  {
    scene.Sources.Media.push_back(this->Vacuum);
  }
  scene.Converted = ConvertMedia(
    scene.Sources.Media, scene.Rays.GetEye(), this->FindEnvironment(s->GetRenderer(), settings));
  scene.Props = SceneProps(s->GetRenderer(), s->GetPropArray(), s->GetPropArrayCount());
  if (settings.Properties.VolumeShadows)
  {
    this->CollectVolumes(scene);
  }
  scene.Lights =
    CollectSceneLights(s->GetRenderer(), scene.Converted, scene.Rays, settings.LightRadius, true);
  this->Messages.CheckLights(
    scene.Lights, HasScattering(scene.Converted), settings.Properties.ScatteredSurfaceLight);
  this->Messages.CheckVisibleLights(
    scene.Lights, s->GetRenderer()->GetActiveCamera(), scene.Sources.Media);
  this->Messages.CheckMultiple(AddMultipleLamps(scene.Lights, scene.Converted));
  return true;
}

//------------------------------------------------------------------------------
void PassRenderer::CollectVolumes(Scene& scene)
{
  for (const SceneProp& prop : scene.Props.GetProps())
  {
    for (const SceneVolume& part : prop.VolumeParts)
    {
      if (!part.Casts)
      {
        continue;
      }
      std::string error;
      const auto values = this->Extinctions.Get(part.Volume, part.ToWorld, error);
      if (values && AddVolume(scene.Converted, *values->Grid, values->SigmaT, scene.Rays.GetEye()))
      {
        scene.Sources.Volumes.push_back(values->Grid);
        scene.CastingVolumes.push_back(part.Volume);
      }
      else if (values)
      {
        error = DescribeNoShadow(part.Volume,
          "there are " + std::to_string(AIRLIGHT_MAX_MEDIA) +
            " media and volumes that cast already: call vtkAirlightPass::SetCastsShadow(volume, "
            "false) for others");
      }
      this->Messages.ReportVolume(error);
    }
  }
  this->Extinctions.Forget();
}

//------------------------------------------------------------------------------
// What casts brings its pipelines up to date, on which depends what of it is opaque.
void PassRenderer::CollectProps(const vtkRenderState* s, const Settings& settings, Scene& scene)
{
  if (settings.Properties.Technique != ShadowTechnique::None)
  {
    this->Casters.Collect(scene.Props, settings.Properties.TranslucentShadows);
  }
  scene.Support.emplace(scene.Props, s->GetRenderer(), settings.Delegate);
}

//------------------------------------------------------------------------------
SceneFacts PassRenderer::GetFacts(const Scene& scene) const
{
  SceneFacts facts;
  facts.Clear = IsClear(scene.Converted);
  facts.DensityImage = HasGrid(scene.Converted);
  // Delegates may draw in another size, or what is translucent with the rest.
  facts.LongWays =
    !facts.Clear && HasLongWays(scene.Converted) && !this->Stages.GetPasses().GetDelegate();
  for (vtkParticipatingMedium* medium : scene.Sources.Media)
  {
    facts.PhaseErrorBound = std::max(facts.PhaseErrorBound, medium->GetPhaseErrorBound());
    facts.MultipleErrorBound = scene.Converted.multiple.count > 0
      ? medium->GetMultipleScatteringErrorBound() + MultipleQuadratureError
      : 0.0;
  }
  for (const SceneLight& light : scene.Lights)
  {
    facts.Lights.push_back({ light.Scatters(), light.CastsShadows, light.Values.kind,
      light.Values.goniometric != 0, light.HasPower() });
  }
  facts.AllShadersInjectable = scene.Support->AllShadersInjectable;
  facts.PointGaussians = scene.Support->PointGaussians;
  facts.AllOpaque = scene.Support->AllOpaque;
  facts.DrawsOverMedium = scene.Support->DrawsOverMedium;
  facts.NonPolygonalCasters = !this->Casters.GetNonPolygonal().empty();
  facts.TranslucentCasters = this->Casters.MetTranslucent();
  facts.Volumes = scene.Support->Volumes.size();
  facts.VisibleLamps = !this->Lamps.IsEmpty() || !this->Suns.empty();
  facts.Width = scene.Rays.GetWidth();
  facts.Height = scene.Rays.GetHeight();
  return facts;
}

//------------------------------------------------------------------------------
bool PassRenderer::Draw(
  const vtkRenderState* s, const FramePlan& plan, Scene& scene, const Viewport& viewport)
{
  vtkRenderer* renderer = s->GetRenderer();
  StateSaver saver(scene.Window, ShadowLists::IsSupported(scene.Window));
  Frame::Input input{ renderer, scene.Converted, scene.Lights, scene.Rays, &this->Casters,
    scene.Support->Solids,
    [this](const std::vector<NonPolygonalCaster>& casters, vtkCamera* camera, int x, int y,
      int side) { this->Stages.DrawInMap(casters, camera, x, y, side); },
    this->Suns, scene.CastingVolumes };
  bool ok =
    this->CurrentFrame.Upload(scene.Window, scene.Sources, input.Media, input.SceneLights) &&
    this->CurrentFrame.Begin(input);
  if (ok)
  {
    vtkRenderState inner(renderer);
    inner.SetPropArrayAndCount(s->GetPropArray(), s->GetPropArrayCount());
    inner.SetFrameBuffer(this->CurrentFrame.GetFramebuffer());
    this->Stages.Begin(&inner, *scene.Support);
    ok = this->CurrentFrame.Draw(this->Stages);
    this->Stages.End();
    ok = ok && (!plan.KeepBuffers || this->CurrentFrame.Record());
  }
  ok = ok || this->Fail(this->CurrentFrame.GetError());
  DisplayStage display = plan.Display;
  ok = ok &&
    (!plan.MeasuresExposure ||
      this->MeasureExposure(renderer, this->CurrentFrame.GetRadiance(),
        { 0, 0, viewport.Width, viewport.Height }, display));
  saver.PopFramebuffer();
  if (!this->Mappers.CheckCompiled(this->Error))
  {
    return false;
  }
  if (!ok)
  {
    return false;
  }
  if (!this->CurrentFrame.Composite(viewport.X, viewport.Y, display, IsBlended(renderer)) ||
    (plan.View == DebugView::Outlines && !this->CurrentFrame.DrawPlanes()))
  {
    return this->Fail(this->CurrentFrame.GetError());
  }
  this->Messages.CheckCostlyCasters(this->CurrentFrame.GetCostlyCasters(), plan);
  if (!plan.LinearFrame)
  {
    this->Stages.GetPasses().DrawOverFrame(s, plan.Annotations, this->Messages);
  }
  return true;
}

//------------------------------------------------------------------------------
// Where there are only too many boundaries, nothing is broken. A frame that failed has no buffers.
void PassRenderer::Recover()
{
  this->CurrentFrame.ForgetBuffers();
  if (vtkOpenGLRenderWindow* window = this->Context->GetContext())
  {
    RestoreState(window);
    if (this->CurrentFrame.GetExcess() == Frame::Excess::None)
    {
      this->CurrentFrame.ReleaseObjects(window);
      this->Mean.Release(window);
      this->Edges.Release(window);
      this->Refined.Forget();
      this->Exposure.Release(window);
    }
  }
}

//------------------------------------------------------------------------------
bool PassRenderer::CollectSilhouettes(
  vtkRenderer* renderer, double lightRadius, std::vector<unsigned char>& bytes, std::string& error)
{
  const int* size = renderer->GetRenderWindow()->GetSize();
  renderer->UpdateLightsGeometryToFollowCamera();
  const CameraUniforms view(renderer, std::max(size[0], 1), std::max(size[1], 1));
  if (!view.IsValid())
  {
    error = "the camera's matrices are not finite or cannot be inverted";
    return false;
  }
  const std::vector<vtkParticipatingMedium*> media = this->Media.GetAll();
  const std::vector<SceneLight> lights =
    CollectSceneLights(renderer, ConvertMedia(media, view.GetEye()), view, lightRadius, true);
  this->Casters.Collect(SceneProps(renderer), false);
  this->OwnShadows.resize(lights.size());
  std::vector<LightSilhouettes> silhouettes(lights.size());
  for (size_t k = 0; k < lights.size(); ++k)
  {
    silhouettes[k].Light = lights[k].World;
    if (lights[k].Scatters() && lights[k].CastsShadows)
    {
      this->OwnShadows[k].Update(this->Casters.GetCasters(), lights[k].World, view, true);
      silhouettes[k] = DescribeSilhouettes(this->OwnShadows[k], lights[k].World);
    }
  }
  bytes = WriteSilhouettes(silhouettes);
  return true;
}
}
