// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What casts shadows in a frame, and what becomes of a frame where some of it lets light through.

#include "Frame/AirlightFrame.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
//------------------------------------------------------------------------------
// Maps know of light and dark only: what lets light through is left out of them.
bool Frame::PrepareCasters()
{
  const bool planes = this->Plan.Shadows == ShadowMethod::Planes;
  this->FoundCasters = nullptr;
  this->OpaqueCasters.clear();
  if (this->Plan.Shadows != ShadowMethod::None)
  {
    this->FoundCasters = &this->Casters.GetCasters();
  }
  if (!planes)
  {
    std::copy_if(this->Casters.GetCasters().begin(), this->Casters.GetCasters().end(),
      std::back_inserter(this->OpaqueCasters),
      [](const Caster& caster) { return caster.OpticalThickness.Blocks == glm::ivec3(1); });
  }
  if (this->FoundCasters && !planes)
  {
    this->FoundCasters = &this->OpaqueCasters;
  }
  this->Faces = planes ? FindPlanarOccluders(this->Casters.GetCasters(), this->Solids, *this->Rays)
                       : std::vector<PlanarOccluder>();
  this->TransmitsShadows =
    planes && this->Plan.TranslucentShadows && this->Casters.MetTranslucent();
  std::vector<int> slots(this->SceneLights.size(), -1);
  int count = 0;
  for (size_t k = 0; k < slots.size() && k < MaximumShadowingLights; ++k)
  {
    const SceneLight& sceneLight = this->SceneLights[k];
    if (this->TransmitsShadows && this->Plan.SurfaceShadows && sceneLight.Scatters() &&
      sceneLight.CastsShadows)
    {
      slots[k] = count++;
    }
  }
  if (!this->SurfaceTransmittance.Prepare(this->Width, this->Height, slots))
  {
    return this->Fail(this->SurfaceTransmittance.GetError());
  }
  const int words = this->TransmitsShadows ? 9 + 2 * count : 8;
  return !this->Plan.TranslucentFragments ||
    this->FragmentLists.Prepare(this->Width, this->Height, words) ||
    this->Fail(this->FragmentLists.GetError());
}

//------------------------------------------------------------------------------
// Those that were made for the light as it is, but for roundings.
ShadowVolumes::RemoteSilhouettes Frame::GetRemoteSilhouettes(int index) const
{
  ShadowVolumes::RemoteSilhouettes found;
  for (const ProcessSilhouettes& remote : this->RemoteSilhouettes)
  {
    const auto k = static_cast<size_t>(index);
    const glm::dvec4& light = this->SceneLights[k].World;
    if (k < remote.size() && glm::distance(remote[k]->Light, light) <= 1e-9 * glm::length(light))
    {
      found.push_back(remote[k]);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
// Of all lights. How much room boundaries get follows from the planes that are to be drawn.
bool Frame::UpdateShadows()
{
  size_t edges = 0;
  for (size_t k = 0; k < this->SceneLights.size() && this->FoundCasters; ++k)
  {
    const SceneLight& sceneLight = this->SceneLights[k];
    if (sceneLight.Scatters() && sceneLight.CastsShadows)
    {
      if (!this->UpdateShadows(static_cast<int>(k), *this->FoundCasters))
      {
        return false;
      }
      edges = std::max(edges, this->Volumes[k].GetEdges().size());
    }
  }
  return this->Plan.Shadows != ShadowMethod::Planes ||
    this->Boundaries.Prepare(this->Window, this->Width, this->Height, this->TransmitsShadows, edges,
      this->Plan.MemoryLimit, this->Plan.LimitPlanes) ||
    this->Fail(this->Boundaries.GetError());
}

//------------------------------------------------------------------------------
// Of one light.
bool Frame::UpdateShadows(int index, const std::vector<Caster>& casters)
{
  const SceneLight& sceneLight = this->SceneLights[index];
  if (this->Plan.Shadows == ShadowMethod::Planes)
  {
    this->Volumes[index].SetRemoteSilhouettes(this->GetRemoteSilhouettes(index));
    if (this->Volumes[index].Update(casters, sceneLight.World, *this->Rays))
    {
      return this->Boundaries.SetVolumes(index, this->Volumes[index]) ||
        this->Fail(this->Boundaries.GetError());
    }
    return true;
  }
  if (!this->Maps[index])
  {
    this->Maps[index] = std::make_unique<ShadowMap>();
  }
  ShadowMap& map = *this->Maps[index];
  if (!map.Update(casters, this->Casters.GetNonPolygonal(), sceneLight, this->Plan.MapResolution))
  {
    return true;
  }
  if (!map.Prepare(this->Window))
  {
    return this->Fail(map.GetError());
  }
  if (!this->Textures.Bind({ map.GetTexture() }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  if (!map.Draw(this->Window, this->MapPrograms))
  {
    return this->Fail(map.GetError());
  }
  if (!map.HasNonPolygonal())
  {
    return true;
  }
  if (!this->Textures.Bind({ map.GetNonPolygonalTexture() }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  map.DrawNonPolygonal(this->Window, this->DrawInMap);
  if (!this->Textures.Bind({ map.GetTexture() }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  return map.MergeNonPolygonal(this->Window, this->MapQuad) || this->Fail(map.GetError());
}

//------------------------------------------------------------------------------
// How casters stand between the light and the start of the rays.
void Frame::SetStartUniforms(vtkShaderProgram* program, int index, bool planes)
{
  if (!this->TransmitsShadows)
  {
    program->SetUniformi("startCount", planes ? this->Volumes[index].GetStartCount() : 0);
    return;
  }
  const CasterOpticalThickness start =
    planes ? this->Volumes[index].GetStartLayers() : CasterOpticalThickness{};
  // Vectors of integers, which vtkShaderProgram cannot set.
  const auto set = [program](const char* name, const glm::ivec3& value) {
    glUniform3iv(glGetUniformLocation(program->GetHandle(), name), 1, &value.x);
  };
  set("startBlocks", start.Blocks);
  set("startThickness", start.Thickness);
  program->SetUniformi("transmittanceSlot", this->SurfaceTransmittance.GetSlot(index));
  this->SurfaceTransmittance.Use(program);
}
}
