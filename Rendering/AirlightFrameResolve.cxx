// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Step 2 of a frame: one light's shadows, from planes or from a map, and its airlight.

#include "AirlightFrame.h"

#include "AirlightDimmed.h"
#include "AirlightLayers.h"
#include "AirlightMapBoundaries.h"
#include "AirlightMapMarch.h"
#include "AirlightNoBoundaries.h"
#include "AirlightOpenGL.h"
#include "AirlightRayMarch.h"
#include "AirlightResolveFS.h"
#include "AirlightResolveLayers.h"
#include "AirlightResolveOutputs.h"
#include "AirlightShadowCounts.h"
#include "AirlightViewShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
bool IsQuadrature(const airlight::f64::AirlightLight& light)
{
  return light.kind == AIRLIGHT_POINT_QUADRATURE || light.kind == AIRLIGHT_DIRECTIONAL_QUADRATURE;
}

const char* GivenUniforms = "uniform AirlightMedia media;\nuniform AirlightLight light;\n";

// The longest way on which light of any channel falls to 1/e; 1 where none does.
double GetFadingLength(const airlight::f64::AirlightMedia& media)
{
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3 * media.count; ++i)
  {
    const double sigmaT = media.item[i / 3].sigmaT[i % 3];
    least = sigmaT > 0.0 ? std::min(least, sigmaT) : least;
  }
  return std::isinf(least) ? 1.0 : 1.0 / least;
}
}

namespace airlight
{
//------------------------------------------------------------------------------
// Null where nothing casts shadows in this light.
ShadowMap* Frame::GetMap(int index) const
{
  const bool used = this->Lamps[index].CastsShadows && this->Maps[index];
  return used && this->Maps[index]->HasCasters() ? this->Maps[index].get() : nullptr;
}

//------------------------------------------------------------------------------
bool Frame::ScatterLight(int index)
{
  const bool shadows = this->Lamps[index].CastsShadows;
  const ShadowMethod method = this->Settings.Shadows;
  if (shadows && method == ShadowMethod::Planes && this->Volumes[index].HasPlanes())
  {
    return this->ScatterWithLists(index);
  }
  const bool map = method == ShadowMethod::March ||
    (shadows && method == ShadowMethod::Map && this->GetMap(index));
  return this->Resolve(index, map ? Lists::Map : Lists::None, 0, this->Height);
}

//------------------------------------------------------------------------------
// The airlight once more, by the ray march.
bool Frame::ScatterReference()
{
  const ShadowMethod method = this->Settings.Shadows;
  const bool dimmed = this->Dimmed;
  this->TakesReference = true;
  this->Settings.Shadows = ShadowMethod::March;
  this->Dimmed = false; // maps know of light and dark only
  bool ok = this->Textures.Bind(this->GetScatterTargets(), nullptr) ||
    this->Fail(this->Textures.GetError());
  if (ok)
  {
    this->ClearTarget(0.0f);
  }
  for (size_t k = 0; k < this->Lamps.size() && ok; ++k)
  {
    const Lamp& lamp = this->Lamps[k];
    const int index = static_cast<int>(k);
    const bool casts = lamp.CastsShadows;
    ok = !lamp.Scatters() ||
      ((!casts || this->UpdateShadows(index, this->OpaqueCasters)) &&
        this->Resolve(index, Lists::Map, 0, this->Height));
  }
  this->Settings.Shadows = method;
  this->Dimmed = dimmed;
  this->TakesReference = !ok;
  return ok;
}

//------------------------------------------------------------------------------
bool Frame::ScatterWithLists(int index)
{
  const ShadowVolumes& volumes = this->Volumes[index];
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
      this->OverBudget = this->Boundaries.IsOverBudget();
      return this->Fail(this->Boundaries.GetError());
    }
    // The composition can resolve what lies in slots, where they hold all of the picture's.
    this->Joined = rows == this->Height && this->MayJoin(index) ? index : -1;
    if (this->Joined < 0 && !this->Resolve(index, Lists::Short, row, rows))
    {
      return false;
    }
    if (!this->ResolveLong(index, row, rows))
    {
      return false;
    }
    row += rows;
  }
  return true;
}

//------------------------------------------------------------------------------
// The pixels whose lists are long, the closed form in several draws.
bool Frame::ResolveLong(int index, int row, int rows)
{
  const int draws = this->Boundaries.GetLongDraws();
  this->LeftOver = draws > 0;
  if (draws > 0 && !this->Boundaries.Sort())
  {
    return this->Fail(this->Boundaries.GetError());
  }
  const bool turned = this->IsTurned(index, Lists::Long);
  bool ok = draws == 0 || !turned || this->DrawResolve(index, Lists::Long, false, row, rows);
  for (int draw = 0; draw < draws && ok && (!turned || this->Settings.LayerRecords); ++draw)
  {
    ok = this->DrawResolve(index, draw == 0 ? Lists::Long : Lists::LongRest, turned, row, rows);
  }
  return ok;
}

//------------------------------------------------------------------------------
std::string Frame::GetResolveSource(int index, Lists lists, bool layersOnly) const
{
  const bool records = this->Settings.LayerRecords;
  if (this->IsTurned(index, lists) && !layersOnly)
  {
    return this->GetTurnedSource(index, lists);
  }
  const bool planes = lists != Lists::None && lists != Lists::Map;
  const bool march = this->Settings.Shadows == ShadowMethod::March;
  const std::string layers =
    records ? std::string(AirlightLayers) + AirlightResolveLayers : std::string();
  std::string boundaries = AirlightNoBoundaries + layers;
  if (planes)
  {
    boundaries = this->Boundaries.GetBoundariesSource(lists != Lists::Short) + layers;
  }
  else if (lists == Lists::Map)
  {
    boundaries = std::string(AirlightMapMarch) +
      (march ? AirlightNoBoundaries + layers + AirlightRayMarch : AirlightMapBoundaries + layers);
  }
  return this->GetResolveHead(index, planes || records || this->Dimmed) +
    (records ? "#define AIRLIGHT_LAYER_RECORDS\n" : "") +
    (march ? "#define AIRLIGHT_RAY_MARCH\n" : "") + GivenUniforms +
    (this->Dimmed ? AirlightDimmed : "") + AirlightShadowCounts + boundaries +
    AirlightResolveOutputs + AirlightResolveFS;
}

//------------------------------------------------------------------------------
// What the sources of a light's airlight begin with.
std::string Frame::GetResolveHead(int index, bool storage) const
{
  const f64::AirlightLight& light = this->Lamps[index].Values;
  return std::string(storage ? "#version 430\n" : "#version 330\n") +
    BoundaryStore::DefineNodes(this->Dimmed) + (this->Settings.Record ? RecordDefinition : "") +
    "#define AIRLIGHT_FULL_SCREEN\n#define AIRLIGHT_FRAGMENT_IS_PIXEL\n#define AIRLIGHT_PARALLEL " +
    std::to_string(this->Rays->IsParallel()) + "\n" +
    (light.cosCone > 0.0 ? "" : "#define AIRLIGHT_NO_CONE\n") +
    GetScatteringSource(this->Media, light.kind, light.goniometric != 0) + AirlightViewShader;
}

//------------------------------------------------------------------------------
// Of a light's airlight, relative to that without shadows.
double Frame::GetIntegralError(int index) const
{
  const Lamp& lamp = this->Lamps[index];
  double error = lamp.GridError + (IsQuadrature(lamp.Values) ? QuadratureError : ClosedFormError);
  if (this->Dimmed && this->Lamps[index].CastsShadows)
  {
    double thickness = 0.0;
    for (const ShadowLayer& layer : this->Volumes[index].GetLayers())
    {
      thickness = std::max(thickness, GetThicknessError(layer));
    }
    error += thickness;
  }
  return error;
}

//------------------------------------------------------------------------------
void Frame::SetResolveUniforms(vtkShaderProgram* program, int index, Lists lists, bool layersOnly)
{
  this->Rays->SetUniforms(program, 0, 0);
  const bool turned = this->IsTurned(index, lists) && !layersOnly;
  if (turned)
  {
    SetMediaUniforms(program, "givenMedia", this->Media);
    SetLightUniforms(program, "givenLight", this->Lamps[index].Values);
    this->SetTurnedConstants(program, { index });
  }
  else
  {
    SetMediaUniforms(program, "media", this->Media);
    SetLightUniforms(program, "light", this->Lamps[index].Values);
  }
  if (f64::airlightIsDirectional(this->Lamps[index].Values))
  {
    program->SetUniformi("lightHasPixel", 0);
  }
  else
  {
    this->Rays->SetFootUniforms(program, this->Lamps[index].Values.position);
  }
  const bool planes = lists != Lists::None && lists != Lists::Map;
  this->SetStartUniforms(program, index, planes);
  glm::vec4 bit(0.0f);
  if (index < MaximumShadowingLights)
  {
    bit[index / BitsPerChannel] = std::ldexp(1.0f, index % BitsPerChannel);
  }
  program->SetUniform4f("litBit", &bit.x);
  if (this->Settings.Record)
  {
    program->SetUniformf("phaseError", static_cast<float>(this->Settings.PhaseErrorBound));
    program->SetUniformf("error", static_cast<float>(this->GetIntegralError(index)));
  }
  if (this->Settings.LayerRecords && !turned)
  {
    this->LayerLists.Use(program);
    program->SetUniformi("layerBit", index < MaximumShadowingLights ? index : -1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  if (planes)
  {
    this->Boundaries.Use(program);
    program->SetUniformi("resume", lists == Lists::LongRest ? 1 : 0);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  if (lists == Lists::Map)
  {
    this->SetMapUniforms(program, index);
  }
}

//------------------------------------------------------------------------------
void Frame::SetMapUniforms(vtkShaderProgram* program, int index)
{
  const ShadowMap* map = this->GetMap(index);
  double scale = 0.0;
  if (map)
  {
    map->SetUniforms(program, *this->Rays);
    scale = map->GetExtent();
  }
  else
  {
    program->SetUniformi("mapKind", 0);
  }
  if (this->Settings.Shadows == ShadowMethod::March)
  {
    scale = GetFadingLength(this->Media);
  }
  program->SetUniformi("marchSteps", this->Settings.Steps);
  program->SetUniformf("marchScale", static_cast<float>(scale));
}

//------------------------------------------------------------------------------
// The records of translucent fragments take the closed form. What is behind them does not, so that it is
// the same to the last bit with and without them.
bool Frame::Resolve(int index, Lists lists, int row, int rows)
{
  return this->DrawResolve(index, lists, false, row, rows) &&
    (!this->Settings.LayerRecords || !this->IsTurned(index, lists) ||
      this->DrawResolve(index, lists, true, row, rows));
}

//------------------------------------------------------------------------------
bool Frame::DrawResolve(int index, Lists lists, bool layersOnly, int row, int rows)
{
  const size_t own = lists == Lists::Map
    ? 3
    : std::min<size_t>(static_cast<size_t>(lists), static_cast<size_t>(Lists::Long));
  Quad& quad = this->ResolveQuads[layersOnly ? 4 : own];
  vtkShaderProgram* program =
    quad.Ready(this->Window, this->GetResolveSource(index, lists, layersOnly));
  if (!program)
  {
    return this->Fail(std::string("the airlight shader") + ProgramMaker::GetReason());
  }
  if (!this->Textures.Bind(this->GetScatterTargets(), nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->SetResolveUniforms(program, index, lists, layersOnly);

  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  if (layersOnly)
  {
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, row, this->Width, rows);
  ShadowMap* map = lists == Lists::Map ? this->GetMap(index) : nullptr;
  quad.Draw(
    { { "distances", this->Textures.Distances }, { "airlightData", this->Data.GetTexture() },
      { "shadowMap", map ? map->GetTexture() : this->Textures.Distances.Get() } });
  state->vtkglScissor(0, 0, this->Width, this->Height);
  return true;
}

}
