// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightFroxels.h"

#include "AirlightCameraShader.h"
#include "AirlightFroxelFS.h"
#include "AirlightFroxelLossFS.h"
#include "AirlightResolveOutputs.h"
#include "Inscatter/AirlightInscatterShader.h"
#include "MapperShaders/AirlightSurfaceShader.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightShaderLibrary.h"

#include "vtkBoundingBox.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace airlight
{
namespace
{
// Pixels of the picture to a coarse one, each way: at least so many.
constexpr int LeastPixels = 5;
// Nodes on a ray.
constexpr int NodeCount = 42;

// Between which depths all that is visible is.
std::pair<double, double> FindDepths(vtkRenderer* renderer, const CameraRays& rays)
{
  double nearest = rays.GetNear();
  double farthest = rays.GetFar();
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  if (!vtkBoundingBox(bounds).IsValid())
  {
    return { nearest, farthest };
  }
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 corner(bounds[i % 2], bounds[2 + i / 2 % 2], bounds[4 + i / 4]);
    const double depth = glm::dot(corner - rays.GetEye(), rays.GetForward());
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
  nearest = std::clamp(least, nearest, farthest);
  return { nearest, std::clamp(most, nearest + 1e-3 * (farthest - nearest), farthest) };
}

// A place for each light that casts shadows.
std::vector<int> NumberLights(const std::vector<SceneLight>& lights)
{
  std::vector<int> places;
  int count = 0;
  for (const SceneLight& light : lights)
  {
    const bool shadows = light.Scatters() && light.CastsShadows && count < MaximumShadowingLights;
    places.push_back(shadows ? count++ : -1);
  }
  return places;
}

// The finest grid that OpenGL has room for and that has not too many boundaries.
FroxelNodes::Layout MakeLayout(
  vtkRenderer* renderer, const FrameScene& scene, const Froxels::Options& options)
{
  FroxelNodes::Layout layout;
  const std::pair<double, double> depths = FindDepths(renderer, scene.Rays);
  layout.Nodes = NodeCount;
  layout.FirstDepth = depths.first;
  layout.Step = (depths.second - depths.first) /
    (NodeCount - 1 - FroxelNodes::NearNodes - FroxelNodes::FarNodes);
  layout.Lights = NumberLights(scene.Lights);
  const double share = options.Boundaries / std::max(options.MaximumBoundaries, 1.0);
  int pixels = std::max(LeastPixels, static_cast<int>(std::ceil(std::sqrt(share))));
  do
  {
    layout.Columns = (scene.Width - 1) / pixels + 1;
    layout.Rows = (scene.Height - 1) / pixels + 1;
    ++pixels;
  } while (
    !FroxelNodes::IsPossible(scene.Window, layout, options.MemoryLimit) && layout.Columns > 1);
  layout.PerPixel = glm::vec2(layout.Columns, layout.Rows) / glm::vec2(scene.Width, scene.Height);
  return layout;
}
}

//------------------------------------------------------------------------------
bool Froxels::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
FrameScene Froxels::GetCoarse(const FrameScene& scene) const
{
  const FroxelNodes::Layout& layout = this->Nodes.GetLayout();
  return { scene.Window, scene.Media, scene.Lights, *this->Rays, scene.Data, scene.Samples,
    layout.Columns, layout.Rows };
}

//------------------------------------------------------------------------------
InscatterTargets Froxels::GetTargets()
{
  InscatterTargets targets;
  targets.Bind = [this](const std::vector<vtkTextureObject*>& colours, vtkTextureObject* depth) {
    return this->Textures.Bind(colours, depth) ? std::string() : this->Textures.GetError();
  };
  targets.Scattered = { this->Textures.Scattered };
  targets.Distances = this->Textures.Distances;
  targets.Depth = this->Textures.Depth;
  targets.Area = { 0, 0, this->Rays->GetWidth(), this->Rays->GetHeight() };
  return targets;
}

//------------------------------------------------------------------------------
// No surface ends the rays: a coarse pixel may be of several.
bool Froxels::Begin(vtkRenderer* renderer, const FrameScene& scene, const Options& options)
{
  this->Current = options;
  const FroxelNodes::Layout layout = MakeLayout(renderer, scene, options);
  if (!this->Nodes.Prepare(scene.Window, layout))
  {
    return this->Fail(this->Nodes.GetError());
  }
  this->Rays.emplace(renderer, layout.Columns, layout.Rows);
  Targets::Needs needs;
  needs.SceneLights = 1;
  if (!this->Textures.Prepare(scene.Window, layout.Columns, layout.Rows, needs) ||
    !this->Textures.Bind({ this->Textures.Distances }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Textures.Clear(-1.0f);
  return true;
}

//------------------------------------------------------------------------------
bool Froxels::UpdateShadow(const FrameScene& coarse, int light, const std::vector<Caster>& casters)
{
  this->Shadows.resize(std::max(this->Shadows.size(), coarse.Lights.size()));
  std::unique_ptr<PlanesShadow>& shadow = this->Shadows[light];
  if (!shadow)
  {
    shadow = std::make_unique<PlanesShadow>(this->Boundaries);
  }
  const InscatterTargets targets = this->GetTargets();
  const std::vector<NonPolygonalCaster> others;
  const std::vector<PlanarOccluder> faces; // those of the picture hide nothing from these rays
  const std::vector<ProcessSilhouettes> remote;
  const DrawActors draw;
  const ShadowCasters shadowCasters{ casters, others, faces, remote, draw, 0 };
  return (shadow->Update(coarse, light, shadowCasters, targets) &&
           shadow->FillNodes(coarse, light, targets, this->Nodes)) ||
    this->Fail(shadow->GetError());
}

//------------------------------------------------------------------------------
bool Froxels::DrawRays(const FrameScene& coarse, int light, MapShadow* map)
{
  const f64::AirlightLight& values = coarse.Lights[light].Values;
  vtkShaderProgram* program = this->RayQuad.GetOrCompile(coarse.Window,
    GetShaderVersion(true) +
      InscatterShader::GetRaySource(
        coarse, values.kind, values.goniometric != 0, values.cosCone > 0.0) +
      FroxelNodes::GetSource() + (this->Current.Record ? "#define AIRLIGHT_RECORD\n" : "") +
      (this->Current.Transmits ? "#define AIRLIGHT_FROXEL_TRANSMITS\n" : "") +
      (map ? "#define AIRLIGHT_FROXEL_MAP\n" + MapShadow::GetLookupSource() : "") +
      AirlightFroxelFS);
  if (!program)
  {
    return this->Fail(std::string("the shader of a coarse grid") + ProgramMaker::GetReason());
  }
  if (!this->Textures.Bind({}, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  coarse.Rays.SetUniforms(program, 0, 0);
  SetMediaUniforms(program, "airlightMedia", coarse.Media);
  SetLightUniforms(program, "light", values);
  SetLightPixelUniforms(program, "lightPixel", coarse.Rays, values);
  const bool shadows = this->Nodes.GetLayout().Lights[light] >= 0;
  const CasterOpticalThickness start =
    shadows ? this->Shadows[light]->GetStartThickness() : CasterOpticalThickness{};
  program->SetUniformi("startBlocks", start.Blocks.r);
  // Integers in vectors of three, which vtkShaderProgram cannot set.
  glUniform3iv(glGetUniformLocation(program->GetHandle(), "startThickness"), 1, &start.Thickness.x);
  if (map)
  {
    map->SetLookup(program, coarse);
  }
  this->Nodes.Use(program, light);
  vtkOpenGLState* state = coarse.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  this->RayQuad.Draw({ { "airlightData", coarse.Data }, { "airlightSamples", coarse.Samples },
    { "shadowMap", map ? map->GetTexture() : nullptr } });
  return true;
}

//------------------------------------------------------------------------------
bool Froxels::ScatterLight(const FrameScene& scene, int light, const std::vector<Caster>& casters,
  MapShadow* map, const InscatterTargets& targets)
{
  const FrameScene coarse = this->GetCoarse(scene);
  const bool shadows = this->Nodes.GetLayout().Lights[light] >= 0;
  return (!shadows || this->UpdateShadow(coarse, light, casters)) &&
    this->DrawRays(coarse, light, map) &&
    (!this->Current.Transmits || !shadows || this->DrawLoss(scene, targets));
}

//------------------------------------------------------------------------------
bool Froxels::DrawTexture(const FrameScene& scene, int firstKind, int kinds)
{
  if (!this->Textures.Bind({ this->Nodes.GetTexture() }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  return this->Nodes.DrawTexture(scene.Window, firstKind, kinds) ||
    this->Fail(this->Nodes.GetError());
}

//------------------------------------------------------------------------------
bool Froxels::DrawLoss(const FrameScene& scene, const InscatterTargets& targets)
{
  if (!this->DrawTexture(scene, 1, 1))
  {
    return false;
  }
  const std::string reason = targets.Bind(targets.Scattered, nullptr);
  if (!reason.empty())
  {
    return this->Fail(reason);
  }
  const std::string source = GetShaderVersion(false) + "#define AIRLIGHT_MORE_LIT " +
    std::to_string(scene.Lights.size() > BitsPerChannel) +
    "\n#define AIRLIGHT_FULL_SCREEN\n#define AIRLIGHT_FRAGMENT_IS_PIXEL\n" +
    (this->Current.Record ? "#define AIRLIGHT_RECORD\n" : "") + AirlightCameraShader +
    AirlightResolveOutputs + FroxelNodes::GetLookupSource() + AirlightFroxelLossFS;
  vtkShaderProgram* program = this->LossQuad.GetOrCompile(scene.Window, source);
  if (!program)
  {
    return this->Fail(std::string("the shader of translucent shadows") + ProgramMaker::GetReason());
  }
  vtkTextureObject* texture = this->Nodes.GetTexture();
  texture->Activate();
  scene.Rays.SetUniforms(program, 0, 0);
  this->Nodes.UseTexture(program);
  vtkOpenGLState* state = scene.Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->LossQuad.Draw({ { "distances", targets.Distances } });
  texture->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
bool Froxels::Finish(const FrameScene& scene)
{
  const int lights = this->Nodes.GetLayout().GetLightCount();
  return this->DrawTexture(scene, 0, 1) && (lights == 0 || this->DrawTexture(scene, 2, lights));
}

//------------------------------------------------------------------------------
void Froxels::Release(vtkWindow* window)
{
  this->Textures.Release(window);
  this->Nodes.Release(window);
  this->Boundaries.Release();
  this->Shadows.clear();
  this->RayQuad.Release();
  this->LossQuad.Release();
}
}
