// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Step 2 of a frame: one light's shadow planes into lists, and these into its airlight.

#include "AirlightFrame.h"

#include "AirlightLayers.h"
#include "AirlightNoBoundaries.h"
#include "AirlightOpenGL.h"
#include "AirlightResolveFS.h"
#include "AirlightResolveLayers.h"
#include "AirlightViewShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
bool IsQuadrature(const airlight::f64::AirlightLight& light)
{
  return light.kind == AIRLIGHT_POINT_QUADRATURE || light.kind == AIRLIGHT_DIRECTIONAL_QUADRATURE;
}
}

namespace airlight
{
//------------------------------------------------------------------------------
bool Frame::ScatterLight(int index)
{
  const ShadowVolumes& volumes = this->Volumes[index];
  const bool shadows = this->Settings.Shadows && this->Lamps[index].CastsShadows;
  if (!shadows || !volumes.HasPlanes())
  {
    return this->Resolve(index, Lists::None, 0, this->Height);
  }
  for (int row = 0; row < this->Height;)
  {
    if (!this->Textures.Bind({}, this->Textures.Depth))
    {
      return this->Fail(this->Textures.GetError());
    }
    const int rows = this->Boundaries.Fill(index, volumes, this->Lamps[index].World, *this->Rays,
      this->Textures.Distances, row, this->Height - row);
    if (rows == 0)
    {
      return this->Fail(this->Boundaries.GetError());
    }
    if (!this->Resolve(index, Lists::Short, row, rows))
    {
      return false;
    }
    const int draws = this->Boundaries.GetLongDraws();
    if (draws > 0 && !this->Boundaries.Sort())
    {
      return this->Fail(this->Boundaries.GetError());
    }
    for (int draw = 0; draw < draws; ++draw)
    {
      if (!this->Resolve(index, draw == 0 ? Lists::Long : Lists::LongRest, row, rows))
      {
        return false;
      }
    }
    row += rows;
  }
  return true;
}

//------------------------------------------------------------------------------
bool Frame::Resolve(int index, Lists lists, int row, int rows)
{
  const bool shadows = lists != Lists::None;
  const bool records = this->Settings.LayerRecords;
  const std::string source = std::string(shadows || records ? "#version 430\n" : "#version 330\n") +
    (this->Settings.Record ? RecordDefinition : "") +
    (records ? "#define AIRLIGHT_LAYER_RECORDS\n" : "") +
    GetScatteringSource(
      this->Media, this->Lamps[index].Values.kind, this->Lamps[index].Values.goniometric != 0) +
    AirlightViewShader +
    (shadows ? ShadowLists::GetBoundariesSource(lists != Lists::Short) : AirlightNoBoundaries) +
    (records ? std::string(AirlightLayers) + AirlightResolveLayers : "") + AirlightResolveFS;
  Quad& quad =
    this->ResolveQuads[std::min(static_cast<size_t>(lists), this->ResolveQuads.size() - 1)];
  vtkShaderProgram* program = quad.Ready(this->Window, source);
  if (!program)
  {
    return this->Fail("the airlight shader did not compile: " + quad.GetError());
  }
  if (!this->Textures.Bind(this->GetScatterTargets(), nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Rays->SetUniforms(program, 0, 0);
  SetMediaUniforms(program, "media", this->Media);
  SetLightUniforms(program, "light", this->Lamps[index].Values);
  if (f64::airlightIsDirectional(this->Lamps[index].Values))
  {
    program->SetUniformi("lightHasPixel", 0);
  }
  else
  {
    this->Rays->SetFootUniforms(program, this->Lamps[index].Values.position);
  }
  program->SetUniformi("startCount", shadows ? this->Volumes[index].GetStartCount() : 0);
  glm::vec4 bit(0.0f);
  if (index < MaximumShadowingLights)
  {
    bit[index / BitsPerChannel] = std::ldexp(1.0f, index % BitsPerChannel);
  }
  program->SetUniform4f("litBit", &bit.x);
  if (this->Settings.Record)
  {
    program->SetUniformf("phaseError", static_cast<float>(this->Settings.PhaseErrorBound));
    program->SetUniformf(
      "error", IsQuadrature(this->Lamps[index].Values) ? QuadratureError : ClosedFormError);
  }
  if (records)
  {
    this->LayerLists.Use(program);
    program->SetUniformi("layerBit", index < MaximumShadowingLights ? index : -1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  if (shadows)
  {
    this->Boundaries.Use(program);
    program->SetUniformi("resume", lists == Lists::LongRest ? 1 : 0);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }

  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, row, this->Width, rows);
  quad.Draw(
    { { "distances", this->Textures.Distances }, { "airlightData", this->Data.GetTexture() } });
  state->vtkglScissor(0, 0, this->Width, this->Height);
  return true;
}

}
