// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightFrame.h"

#include "Frame/AirlightSceneDrawer.h"

#include "AirlightCameraShader.h"
#include "AirlightDistancesFS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
bool IsClear(const f64::AirlightMedia& media)
{
  return std::all_of(media.item, media.item + media.count,
    [](const f64::AirlightMedium& medium) { return medium.sigmaT == glm::dvec3(0.0); });
}

//------------------------------------------------------------------------------
bool Frame::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool Frame::Upload(vtkOpenGLRenderWindow* window, const std::vector<vtkParticipatingMedium*>& media,
  f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights)
{
  this->OverBudget = false;
  return UploadData(this->Data, &this->Grids, window, media, converted, sceneLights) ||
    this->Fail(this->Data.GetError());
}

//------------------------------------------------------------------------------
bool Frame::Begin(const Input& input)
{
  this->Renderer = input.Renderer;
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(input.Renderer->GetRenderWindow());
  this->Media = input.Media;
  this->SceneLights = input.SceneLights;
  this->Rays = input.Rays;
  this->Solids = input.Solids;
  this->DrawInMap = input.DrawInMap;
  this->Width = input.Rays.GetWidth();
  this->Height = input.Rays.GetHeight();
  Targets::Needs needs;
  needs.SceneLights = input.SceneLights.size();
  needs.Drawn = !this->Plan.AllShadersInjectable;
  needs.WithoutLight = this->Plan.ShadowingLight >= 0;
  needs.Record = this->Plan.Record;
  needs.Translucent = this->Plan.Translucent;
  return this->Textures.Prepare(this->Window, this->Width, this->Height, needs) ||
    this->Fail(this->Textures.GetError());
}

//------------------------------------------------------------------------------
bool Frame::Draw(SceneDrawer& scene)
{
  const bool single = this->Plan.SingleGeometryPass;
  if (!(single ? this->DrawColours(scene) : this->DrawDistances(scene)) || !this->PrepareCasters())
  {
    return false;
  }
  scene.UpdateCasters();
  if (!this->CollectFragments(scene) || !this->ScatterLights() ||
    !(single || this->DrawColours(scene)))
  {
    return false;
  }
  if ((this->Plan.Translucent || this->Plan.KeepBuffers) && !this->CompositeTranslucent())
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
  if (!this->BindDistances())
  {
    return false;
  }
  scene.DrawDistances();
  return this->ResolveDistances();
}

//------------------------------------------------------------------------------
bool Frame::DrawColours(SceneDrawer& scene)
{
  if (!(this->Plan.SingleGeometryPass ? this->BindSceneAndDistances() : this->BindScene()))
  {
    return false;
  }
  scene.DrawColours();
  return true;
}

//------------------------------------------------------------------------------
// Until the records have room for all fragments.
bool Frame::CollectFragments(SceneDrawer& scene)
{
  TranslucentFragments::Outcome outcome = this->Plan.TranslucentFragments
    ? TranslucentFragments::Outcome::Again
    : TranslucentFragments::Outcome::Done;
  while (outcome == TranslucentFragments::Outcome::Again)
  {
    if (!this->BindDepth())
    {
      return false;
    }
    scene.CollectFragments();
    outcome = this->FragmentLists.Check();
  }
  return outcome == TranslucentFragments::Outcome::Done ||
    this->Fail(this->FragmentLists.GetError());
}

//------------------------------------------------------------------------------
void Frame::ClearTarget(float value)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(value, value, value, value);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

//------------------------------------------------------------------------------
bool Frame::BindDistances()
{
  const vtkNew<vtkTextureObject>& target =
    this->Plan.AllShadersInjectable ? this->Textures.Distances : this->Textures.Drawn;
  if (!this->Textures.Bind({ target }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->ClearTarget(-1.0f);
  this->ClearDepth();
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  return true;
}

//------------------------------------------------------------------------------
void Frame::ClearDepth()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

//------------------------------------------------------------------------------
bool Frame::BindDepth()
{
  if (!this->Textures.Bind({}, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::ResolveDistances()
{
  if (this->Plan.AllShadersInjectable)
  {
    return true;
  }
  if (!this->Textures.Bind({ this->Textures.Distances }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  vtkShaderProgram* program = this->DistancesQuad.GetOrCompile(
    this->Window, std::string("#version 330\n") + AirlightCameraShader + AirlightDistancesFS);
  if (!program)
  {
    return this->Fail(std::string("the shader of distances") + ProgramMaker::GetReason());
  }
  this->Rays->SetUniforms(program, 0, 0);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  this->DistancesQuad.Draw(
    { { "drawn", this->Textures.Drawn }, { "sceneDepth", this->Textures.Depth } });
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkTextureObject*> Frame::GetScatterTargets()
{
  std::vector<vtkTextureObject*> targets = { this->Textures.Scattered };
  if (this->Plan.Record)
  {
    targets.push_back(this->Textures.Counts);
    targets.push_back(this->Textures.Single);
  }
  if (this->HasMoreLit())
  {
    targets.push_back(this->Textures.Lit);
  }
  return targets;
}

//------------------------------------------------------------------------------
bool Frame::ScatterLights()
{
  if (this->Plan.UnshadowedInComposite)
  {
    this->Buffers.Clear();
    this->ReleaseMaps(this->Window);
    return true;
  }
  if (!this->Textures.Bind(this->GetScatterTargets(), nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->ClearTarget(0.0f);
  this->Buffers.Clear();
  this->Volumes.resize(this->SceneLights.size());
  // Maps are large: they go with their light or technique.
  const bool mapped =
    this->Plan.Shadows == ShadowMethod::Map || this->Plan.Shadows == ShadowMethod::March;
  if (this->Maps.size() > this->SceneLights.size() || !mapped)
  {
    this->ReleaseMaps(this->Window);
  }
  this->Maps.resize(this->SceneLights.size());
  if (!this->UpdateShadows())
  {
    return false;
  }
  for (size_t k = 0; k < this->SceneLights.size(); ++k)
  {
    const SceneLight& sceneLight = this->SceneLights[k];
    if (sceneLight.Scatters() && !this->ScatterLight(static_cast<int>(k)))
    {
      return false;
    }
    if (this->Plan.Record && !this->RecordSingle(static_cast<int>(k)))
    {
      return false;
    }
  }
  // The mappers read what the resolves wrote.
  if (this->Plan.TranslucentFragments || this->TransmitsShadows)
  {
    // No test fails without it, see AirlightOpenGL.h.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads one light's airlight and clears its target for the next one.
bool Frame::RecordSingle(int index)
{
  if (!this->Buffers.RecordLight(this->Textures, index))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->ClearTarget(0.0f);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::Record()
{
  return this->Buffers.Record(this->Textures) || this->Fail(this->Textures.GetError());
}

//------------------------------------------------------------------------------
FrameScene Frame::GetScene()
{
  return { this->Window, this->Media, this->SceneLights, *this->Rays, this->Data.GetTexture(),
    this->Width, this->Height };
}

//------------------------------------------------------------------------------
CompositePass::Options Frame::GetCompositeOptions() const
{
  CompositePass::Options options;
  options.Unshadowed = this->Plan.UnshadowedInComposite;
  options.Equiangular = !this->TransmitsShadows;
  options.ShadowingLight = this->Plan.ShadowingLight;
  options.LightsPerChannel = BitsPerChannel;
  options.DebugView = static_cast<int>(this->Plan.View);
  options.Record = this->Plan.Record;
  options.AmbientError = ClosedFormError;
  options.EncodedInput = this->Plan.EncodedInput;
  options.EncodedOutput = this->Plan.EncodedOutput;
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
  if (!this->Textures.Bind(targets, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  if (!this->Composition.DrawIntoTextures(
        this->GetScene(), this->GetCompositeOptions(), this->GetCompositeInputs()))
  {
    return this->Fail(this->Composition.GetError());
  }
  if (!this->Textures.Bind({ this->Textures.Radiance }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->BlendColours();
  this->Window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::Composite(int x, int y, bool blend)
{
  const FrameScene scene = this->GetScene();
  const CompositePass::Options options = this->GetCompositeOptions();
  const CompositePass::Inputs inputs = this->GetCompositeInputs();
  const bool ok = this->Plan.Translucent
    ? this->Composition.CopyIntoViewport(
        scene, options, inputs, this->Textures.Radiance, x, y, blend)
    : this->Composition.DrawIntoViewport(scene, options, inputs, x, y, blend);
  return ok || this->Fail(this->Composition.GetError());
}

//------------------------------------------------------------------------------
bool Frame::DrawPlanes()
{
  const bool planes = this->Plan.Shadows == ShadowMethod::Planes;
  for (size_t k = 0; k < this->SceneLights.size() && planes; ++k)
  {
    const SceneLight& sceneLight = this->SceneLights[k];
    if (sceneLight.Scatters() && sceneLight.CastsShadows && this->Volumes[k].HasShadows() &&
      !this->Boundaries.DrawWireframe(this->GetPlanesSource(static_cast<int>(k))))
    {
      return this->Fail(this->Boundaries.GetError());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void Frame::ReleaseMaps(vtkWindow* window)
{
  for (const auto& map : this->Maps)
  {
    if (map)
    {
      map->Release(window);
    }
  }
  this->Maps.clear();
}

//------------------------------------------------------------------------------
void Frame::ReleaseObjects(vtkWindow* window)
{
  for (Quad& quad : this->ResolveQuads)
  {
    quad.Release();
  }
  this->DistancesQuad.Release();
  this->Composition.Release();
  this->MapQuad.Release();
  this->Boundaries.Release();
  this->FragmentLists.Release();
  this->SurfaceTransmittance.Release();
  this->Volumes.clear();
  this->ReleaseMaps(window);
  this->Textures.Release(window);
  this->Data.Release(window);
}

//------------------------------------------------------------------------------
void Frame::Release(vtkWindow* window)
{
  this->ReleaseObjects(window);
  this->Casters.Clear();
  this->FoundCasters = nullptr;
  this->OpaqueCasters.clear();
}
}
