// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What casts shadows in a frame, and what becomes of a frame where some of it lets light through.

#include "AirlightFrame.h"

#include "AirlightOpenGL.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
//------------------------------------------------------------------------------
// Maps know of light and dark only: what lets light through is left out of them.
bool Frame::PrepareCasters()
{
  const bool planes = this->Settings.Shadows == ShadowMethod::Planes;
  this->FoundCasters = nullptr;
  this->OpaqueCasters.clear();
  if (this->Settings.Shadows != ShadowMethod::None)
  {
    this->FoundCasters = &this->Casters.GetCasters();
  }
  if (!planes || this->Settings.Difference)
  {
    std::copy_if(this->Casters.GetCasters().begin(), this->Casters.GetCasters().end(),
      std::back_inserter(this->OpaqueCasters),
      [](const Caster& caster) { return caster.Layer.Blocks == glm::ivec3(1); });
  }
  if (this->FoundCasters && !planes)
  {
    this->FoundCasters = &this->OpaqueCasters;
  }
  this->Dimmed = planes && this->Settings.TranslucentShadows && this->Casters.MetTranslucent();
  std::vector<int> slots(this->Lamps.size(), -1);
  int count = 0;
  for (size_t k = 0; k < slots.size() && k < MaximumShadowingLights; ++k)
  {
    const Lamp& lamp = this->Lamps[k];
    if (this->Dimmed && this->Settings.SurfaceShadows && lamp.Scatters() && lamp.CastsShadows)
    {
      slots[k] = count++;
    }
  }
  if (planes)
  {
    this->Boundaries.SetDimmed(this->Dimmed);
  }
  if (!this->SurfaceDimming.Prepare(this->Width, this->Height, slots))
  {
    return this->Fail(this->SurfaceDimming.GetError());
  }
  const int words = this->Dimmed ? 9 + 2 * count : 8;
  return !this->Settings.LayerRecords ||
    this->LayerLists.Prepare(this->Width, this->Height, words) ||
    this->Fail(this->LayerLists.GetError());
}

//------------------------------------------------------------------------------
// How casters stand between the light and the start of the rays.
void Frame::SetStartUniforms(vtkShaderProgram* program, int index, bool planes)
{
  if (!this->Dimmed)
  {
    program->SetUniformi("startCount", planes ? this->Volumes[index].GetStartCount() : 0);
    return;
  }
  const ShadowLayer start = planes ? this->Volumes[index].GetStartLayers() : ShadowLayer{};
  // Vectors of integers, which vtkShaderProgram cannot set.
  const auto set = [program](const char* name, const glm::ivec3& value) {
    glUniform3iv(glGetUniformLocation(program->GetHandle(), name), 1, &value.x);
  };
  set("startBlocks", start.Blocks);
  set("startThickness", start.Thickness);
  program->SetUniformi("dimmingSlot", this->SurfaceDimming.GetSlot(index));
  this->SurfaceDimming.Use(program);
}
}
