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
  const bool planes = options.Method == ShadowMethod::Planes;
  const std::vector<Caster>& all = casters.GetCasters();
  this->OpaqueCasters.clear();
  if (this->HasMaps())
  {
    std::copy_if(all.begin(), all.end(), std::back_inserter(this->OpaqueCasters),
      [](const Caster& caster) { return caster.OpticalThickness.Blocks == glm::ivec3(1); });
  }
  this->Casters = planes ? &all : this->HasMaps() ? &this->OpaqueCasters : nullptr;
  this->Faces =
    planes ? FindPlanarOccluders(all, solids, scene.Rays) : std::vector<PlanarOccluder>();
  this->Transmits = planes && options.TranslucentShadows && casters.MetTranslucent();
  return this->PrepareTransmittance(scene);
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
void LightShadows::MakeShadows(const FrameScene& scene)
{
  const size_t count = scene.Lights.size();
  if (this->Current.Method == ShadowMethod::Planes)
  {
    this->Planes.resize(count);
  }
  for (auto& shadow : this->Planes)
  {
    if (!shadow)
    {
      shadow = std::make_unique<PlanesShadow>(this->Boundaries);
    }
    // A map has light and dark only.
    shadow->SetMaximumBoundaries(
      this->Transmits ? std::numeric_limits<double>::infinity() : this->Current.MaximumBoundaries);
  }
  if (this->Maps.size() > count)
  {
    this->ReleaseMaps(scene.Window);
  }
  if (!this->HasMaps())
  {
    this->Maps.resize(count);
    this->Mixed.resize(count);
    return;
  }
  this->Maps.resize(count);
  for (size_t k = 0; k < this->Maps.size(); ++k)
  {
    if (!this->Maps[k] && Casts(scene, k))
    {
      this->Maps[k] =
        std::make_unique<MapShadow>(this->Programs, this->Current.Method == ShadowMethod::March);
    }
    if (this->Maps[k])
    {
      this->Maps[k]->SetSteps(this->Current.Steps);
    }
  }
  this->NoMap.SetSteps(this->Current.Steps);
}

//------------------------------------------------------------------------------
LightShadow* LightShadows::Find(size_t light)
{
  if (this->HasMaps())
  {
    return this->Maps[light].get();
  }
  if (!this->Mixed[light])
  {
    return this->Planes[light].get();
  }
  return this->Planes[light]->HasShadow() ? static_cast<LightShadow*>(this->Mixed[light].get())
                                          : this->Maps[light].get();
}

//------------------------------------------------------------------------------
bool LightShadows::HasMapBesidePlanes(size_t light) const
{
  return light < this->Mixed.size() && this->Mixed[light];
}

//------------------------------------------------------------------------------
LightShadows::CostlyCasters LightShadows::GetCostlyCasters() const
{
  CostlyCasters most;
  for (size_t k = 0; k < this->Mixed.size(); ++k)
  {
    const size_t count = this->Mixed[k] ? this->Planes[k]->GetLeftOut().size() : 0;
    if (count > 0 && this->Planes[k]->GetEstimate() > most.Boundaries)
    {
      most = { count, this->Planes[k]->GetEstimate() };
    }
  }
  return most;
}

//------------------------------------------------------------------------------
void LightShadows::DropMap(const FrameScene& scene, size_t light)
{
  this->Mixed[light].reset();
  if (this->Maps[light])
  {
    this->Maps[light]->Release(scene.Window);
    this->Maps[light].reset();
  }
}

//------------------------------------------------------------------------------
// The map of the casters that have no planes.
bool LightShadows::UpdateMixed(
  const FrameScene& scene, int light, const ShadowCasters& casters, const InscatterTargets& targets)
{
  const std::vector<Caster>& left = this->Planes[light]->GetLeftOut();
  std::unique_ptr<MapShadow>& map = this->Maps[light];
  std::vector<NonPolygonalCaster> others;
  if (this->Current.MapNonPolygonal)
  {
    others = casters.NonPolygonal;
  }
  if (left.empty() && others.empty())
  {
    this->DropMap(scene, light);
    return true;
  }
  if (!map)
  {
    map = std::make_unique<MapShadow>(this->Programs, false);
  }
  map->SetSteps(this->Current.Steps);
  this->Mixed[light] = std::make_unique<MixedShadow>(*this->Planes[light], *map);
  const ShadowCasters costly{ left, others, casters.Faces, casters.Remote, casters.DrawNonPolygonal,
    casters.MapResolution };
  return map->Update(scene, light, costly, targets) || this->Fail(map->GetError());
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
  for (size_t k = 0; k < scene.Lights.size(); ++k)
  {
    if (Casts(scene, k))
    {
      const int light = static_cast<int>(k);
      LightShadow* shadow =
        this->HasMaps() ? static_cast<LightShadow*>(this->Maps[k].get()) : this->Planes[k].get();
      if (!shadow->Update(scene, light, casters, targets))
      {
        return this->Fail(shadow->GetError());
      }
      if (!this->HasMaps() && !this->UpdateMixed(scene, light, casters, targets))
      {
        return false;
      }
      edges = std::max(edges, shadow->GetEdgeCount());
    }
    else if (!this->HasMaps())
    {
      this->DropMap(scene, k);
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
  LightShadow* shadow = this->Casters && scene.Lights[light].CastsShadows
    ? this->Find(static_cast<size_t>(light))
    : nullptr;
  if (shadow && shadow->HasShadow())
  {
    return *shadow;
  }
  const bool march = this->Current.Method == ShadowMethod::March;
  return march ? static_cast<LightShadow&>(this->NoMap) : this->None;
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
    ? std::min(this->Planes.size(), scene.Lights.size())
    : 0;
  for (size_t k = 0; k < count; ++k)
  {
    PlanesShadow& shadow = *this->Planes[k];
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
  for (const auto& map : this->Maps)
  {
    if (map)
    {
      map->Release(window);
    }
  }
  this->Maps.clear();
  this->Mixed.clear();
}

//------------------------------------------------------------------------------
void LightShadows::ReleaseObjects(vtkWindow* window)
{
  this->ReleaseMaps(window);
  this->Planes.clear();
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
