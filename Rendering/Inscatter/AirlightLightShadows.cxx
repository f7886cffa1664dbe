// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightLightShadows.h"

#include "Inscatter/AirlightMixedShadow.h"
#include "Inscatter/AirlightPlanesShadow.h"
#include "MapperShaders/AirlightSurfaceShader.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
namespace
{
bool Casts(const FrameScene& scene, size_t light)
{
  return scene.Lights[light].Scatters() && scene.Lights[light].CastsShadows;
}
}

//------------------------------------------------------------------------------
// A light's shadows. Those that it does not need are null.
struct LightShadows::OneLight
{
  PlanesShadow& MakePlanes(ShadowLists& lists)
  {
    if (!this->Planes)
    {
      this->Planes = std::make_unique<PlanesShadow>(lists);
    }
    return *this->Planes;
  }

  void ReleaseMap(vtkWindow* window)
  {
    this->Mixed.reset();
    if (this->Map)
    {
      this->Map->Release(window);
      this->Map.reset();
    }
  }

  const vtkLight* Light = nullptr;          // to be compared only
  ShadowMethod Method = ShadowMethod::None; // in this frame
  std::unique_ptr<PlanesShadow> Planes;
  std::unique_ptr<MapShadow> Map;
  std::unique_ptr<MixedShadow> Mixed; // of both
};

//------------------------------------------------------------------------------
LightShadows::LightShadows()
  : NoMap(this->Programs, true)
{
}

//------------------------------------------------------------------------------
LightShadows::~LightShadows() = default;

//------------------------------------------------------------------------------
bool LightShadows::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool LightShadows::HasMaps() const
{
  return this->Current.Method == ShadowMethod::Map || this->Current.Method == ShadowMethod::March;
}

//------------------------------------------------------------------------------
bool LightShadows::Prepare(const FrameScene& scene, const Options& options,
  const CasterCache& casters, const std::vector<vtkProp*>& solids)
{
  if (options.Method != this->Current.Method)
  {
    this->ReleaseMaps(scene.Window);
  }
  this->Current = options;
  for (OneLight& light : this->Lights)
  {
    light.Method = ShadowMethod::None;
  }
  const bool planes = options.Method == ShadowMethod::Planes;
  const std::vector<Caster>& all = casters.GetCasters();
  this->OpaqueCasters.clear();
  if (this->HasMaps())
  {
    std::copy_if(all.begin(), all.end(), std::back_inserter(this->OpaqueCasters),
      [](const Caster& caster) { return caster.IsOpaque(); });
  }
  this->Casters = planes ? &all : this->HasMaps() ? &this->OpaqueCasters : nullptr;
  this->Faces =
    planes ? FindPlanarOccluders(all, solids, scene.Rays) : std::vector<PlanarOccluder>();
  this->Transmits =
    planes && options.TranslucentShadows && !options.OpaqueOnly && casters.MetTranslucent();
  return this->PrepareTransmittance(scene);
}

//------------------------------------------------------------------------------
double LightShadows::EstimateTranslucent(
  const FrameScene& scene, const CasterCache& casters, const std::vector<vtkProp*>& solids)
{
  const std::vector<Caster>& all = casters.GetCasters();
  if (std::all_of(all.begin(), all.end(), [](const Caster& caster) { return caster.IsOpaque(); }))
  {
    return 0.0;
  }
  if (std::any_of(all.begin(), all.end(), [](const Caster& caster) {
        return !caster.IsOpaque() && caster.OpticalThickness.Blocks != glm::ivec3(0);
      }))
  {
    return -1.0;
  }
  this->ResizeLights(scene);
  const std::vector<PlanarOccluder> faces = FindPlanarOccluders(all, solids, scene.Rays);
  const std::vector<NonPolygonalCaster> none;
  const DrawActors draw;
  const ShadowCasters shadowCasters{ all, none, faces, this->Remote, draw, 0 };
  double most = 0.0;
  for (size_t k = 0; k < this->Lights.size(); ++k)
  {
    if (Casts(scene, k))
    {
      most = std::max(most,
        this->Lights[k]
          .MakePlanes(this->Boundaries)
          .EstimateTranslucent(scene, static_cast<int>(k), shadowCasters));
    }
  }
  return most;
}

//------------------------------------------------------------------------------
// A slot for each light that casters dim on surfaces.
bool LightShadows::PrepareTransmittance(const FrameScene& scene)
{
  std::vector<int> slots(scene.Lights.size(), -1);
  int count = 0;
  for (size_t k = 0; k < slots.size() && k < MaximumShadowingLights; ++k)
  {
    if (this->Transmits && this->Current.SurfaceShadows && Casts(scene, k))
    {
      slots[k] = count++;
    }
  }
  return this->SurfaceTransmittance.Prepare(scene.Width, scene.Height, slots) ||
    this->Fail(this->SurfaceTransmittance.GetError());
}

//------------------------------------------------------------------------------
// Lights that have gone away may have changed the numbers of the others.
void LightShadows::ResizeLights(const FrameScene& scene)
{
  if (this->Lights.size() > scene.Lights.size())
  {
    this->ReleaseMaps(scene.Window);
  }
  this->Lights.resize(scene.Lights.size());
}

//------------------------------------------------------------------------------
void LightShadows::MakeShadows(const FrameScene& scene)
{
  this->ResizeLights(scene);
  for (size_t k = 0; k < this->Lights.size(); ++k)
  {
    this->Lights[k].Light = scene.Lights[k].Light;
    this->MakeShadow(this->Lights[k], Casts(scene, k));
  }
  this->NoMap.SetSteps(this->Current.Steps);
}

//------------------------------------------------------------------------------
void LightShadows::MakeShadow(OneLight& light, bool casts)
{
  if (this->Current.Method == ShadowMethod::Planes)
  {
    PlanesShadow& planes = light.MakePlanes(this->Boundaries);
    planes.SetOpaqueOnly(this->Current.OpaqueOnly);
    // A map has light and dark only.
    planes.SetMaximumBoundaries(
      this->Transmits ? std::numeric_limits<double>::infinity() : this->Current.MaximumBoundaries);
  }
  if (this->HasMaps() && casts && !light.Map)
  {
    light.Map =
      std::make_unique<MapShadow>(this->Programs, this->Current.Method == ShadowMethod::March);
  }
  if (light.Map)
  {
    light.Map->SetSteps(this->Current.Steps);
  }
}

//------------------------------------------------------------------------------
LightShadow* LightShadows::Find(const OneLight& light)
{
  if (this->HasMaps())
  {
    return light.Map.get();
  }
  if (!light.Mixed)
  {
    return light.Planes.get();
  }
  return light.Planes->HasShadow() ? static_cast<LightShadow*>(light.Mixed.get()) : light.Map.get();
}

//------------------------------------------------------------------------------
ShadowMethod LightShadows::GetMethod(const vtkLight* light) const
{
  const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const OneLight& one) { return one.Light == light; });
  return found != this->Lights.end() ? found->Method : ShadowMethod::None;
}

//------------------------------------------------------------------------------
bool LightShadows::HasMap() const
{
  return std::any_of(this->Lights.begin(), this->Lights.end(),
    [](const OneLight& light) { return light.Method == ShadowMethod::Map; });
}

//------------------------------------------------------------------------------
LightShadows::CostlyCasters LightShadows::GetCostlyCasters() const
{
  CostlyCasters most;
  for (const OneLight& light : this->Lights)
  {
    const size_t count = light.Mixed ? light.Planes->GetLeftOut().size() : 0;
    if (count > 0 && light.Planes->GetEstimate() > most.Boundaries)
    {
      most = { count, light.Planes->GetEstimate() };
    }
  }
  return most;
}

//------------------------------------------------------------------------------
// The map of the casters that have no planes.
bool LightShadows::UpdateMixed(
  const FrameScene& scene, int light, const ShadowCasters& casters, const InscatterTargets& targets)
{
  OneLight& own = this->Lights[light];
  std::vector<NonPolygonalCaster> others;
  if (this->Current.MapNonPolygonal)
  {
    others = casters.NonPolygonal;
  }
  if (own.Planes->GetLeftOut().empty() && others.empty())
  {
    own.ReleaseMap(scene.Window);
    return true;
  }
  if (!own.Map)
  {
    own.Map = std::make_unique<MapShadow>(this->Programs, false);
  }
  own.Map->SetSteps(this->Current.Steps);
  own.Mixed = std::make_unique<MixedShadow>(*own.Planes, *own.Map);
  own.Method = ShadowMethod::Map;
  const ShadowCasters costly{ own.Planes->GetLeftOut(), others, casters.Faces, casters.Remote,
    casters.DrawNonPolygonal, casters.MapResolution };
  return own.Map->Update(scene, light, costly, targets) || this->Fail(own.Map->GetError());
}

//------------------------------------------------------------------------------
bool LightShadows::UpdateLight(
  const FrameScene& scene, int light, const ShadowCasters& casters, const InscatterTargets& targets)
{
  OneLight& own = this->Lights[light];
  own.Method = this->Current.Method;
  LightShadow& shadow =
    this->HasMaps() ? static_cast<LightShadow&>(*own.Map) : static_cast<LightShadow&>(*own.Planes);
  if (!shadow.Update(scene, light, casters, targets))
  {
    return this->Fail(shadow.GetError());
  }
  return this->HasMaps() || this->UpdateMixed(scene, light, casters, targets);
}

//------------------------------------------------------------------------------
bool LightShadows::Update(const FrameScene& scene, const InscatterTargets& targets,
  const std::vector<NonPolygonalCaster>& nonPolygonal, const DrawActors& drawNonPolygonal)
{
  this->MakeShadows(scene);
  if (!this->Casters)
  {
    return true;
  }
  const ShadowCasters casters{ *this->Casters, nonPolygonal, this->Faces, this->Remote,
    drawNonPolygonal, this->Current.MapResolution };
  size_t edges = 0;
  for (size_t k = 0; k < this->Lights.size(); ++k)
  {
    if (!Casts(scene, k))
    {
      this->Lights[k].ReleaseMap(scene.Window);
      continue;
    }
    if (!this->UpdateLight(scene, static_cast<int>(k), casters, targets))
    {
      return false;
    }
    if (this->Lights[k].Planes)
    {
      edges = std::max(edges, this->Lights[k].Planes->GetEdgeCount());
    }
  }
  // How much room boundaries get follows from the planes that are to be drawn.
  return this->Current.Method != ShadowMethod::Planes ||
    this->Boundaries.Prepare(scene.Window, scene.Width, scene.Height, this->Transmits, edges,
      this->Current.MemoryLimit, this->Current.LimitPlanes) ||
    this->Fail(this->Boundaries.GetError());
}

//------------------------------------------------------------------------------
LightShadow& LightShadows::Get(const FrameScene& scene, int light)
{
  LightShadow* shadow =
    this->Casters && scene.Lights[light].CastsShadows ? this->Find(this->Lights[light]) : nullptr;
  if (shadow && shadow->HasShadow())
  {
    return *shadow;
  }
  const bool march = this->Current.Method == ShadowMethod::March;
  return march ? static_cast<LightShadow&>(this->NoMap) : this->None;
}

//------------------------------------------------------------------------------
MapShadow* LightShadows::GetMap(int light)
{
  MapShadow* map =
    static_cast<size_t>(light) < this->Lights.size() ? this->Lights[light].Map.get() : nullptr;
  return map && map->HasShadow() ? map : nullptr;
}

//------------------------------------------------------------------------------
bool LightShadows::IsOverBudget() const
{
  return this->Current.Method == ShadowMethod::Planes && this->Boundaries.IsOverBudget();
}

//------------------------------------------------------------------------------
void LightShadows::SetStartUniforms(
  vtkShaderProgram* program, const LightShadow& shadow, int light) const
{
  if (!this->Transmits)
  {
    program->SetUniformi("startCount", shadow.GetStartCount());
    return;
  }
  const CasterOpticalThickness start = shadow.GetStartThickness();
  // Vectors of integers, which vtkShaderProgram cannot set.
  const auto set = [program](const char* name, const glm::ivec3& value) {
    glUniform3iv(glGetUniformLocation(program->GetHandle(), name), 1, &value.x);
  };
  set("startBlocks", start.Blocks);
  set("startThickness", start.Thickness);
  program->SetUniformi("transmittanceSlot", this->SurfaceTransmittance.GetSlot(light));
  this->SurfaceTransmittance.Use(program);
}

//------------------------------------------------------------------------------
bool LightShadows::DrawWireframe(const FrameScene& scene, vtkTextureObject* distances)
{
  const size_t count = this->Current.Method == ShadowMethod::Planes
    ? std::min(this->Lights.size(), scene.Lights.size())
    : 0;
  for (size_t k = 0; k < count; ++k)
  {
    PlanesShadow& shadow = *this->Lights[k].Planes;
    if (Casts(scene, k) && shadow.HasShadow() &&
      !shadow.DrawWireframe(scene, static_cast<int>(k), distances))
    {
      return this->Fail(shadow.GetError());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void LightShadows::ReleaseMaps(vtkWindow* window)
{
  for (OneLight& light : this->Lights)
  {
    light.ReleaseMap(window);
  }
}

//------------------------------------------------------------------------------
void LightShadows::ReleaseObjects(vtkWindow* window)
{
  this->ReleaseMaps(window);
  this->Lights.clear();
  this->Programs.Merge.Release();
  this->Programs.Slices.Release();
  this->Boundaries.Release();
  this->SurfaceTransmittance.Release();
}

//------------------------------------------------------------------------------
void LightShadows::Release(vtkWindow* window)
{
  this->ReleaseObjects(window);
  this->Casters = nullptr;
  this->OpaqueCasters.clear();
}
}
