// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The shader of one light's airlight: what it is put together from, and its uniforms.

#include "Frame/AirlightFrame.h"

#include "AirlightCameraShader.h"
#include "AirlightEquiangularFS.h"
#include "AirlightEquiangularRay.h"
#include "AirlightMapBoundaries.h"
#include "AirlightMapMarch.h"
#include "AirlightNoBoundaries.h"
#include "AirlightNoPackedBoundaries.h"
#include "AirlightRayMarch.h"
#include "AirlightResolveFS.h"
#include "AirlightResolveOutputs.h"
#include "AirlightResolveTranslucent.h"
#include "AirlightShadowCounts.h"
#include "AirlightTranslucentLists.h"
#include "AirlightTransmittanceBuffer.h"
#include "Integration/AirlightIntegrate.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Scene/AirlightEquiangularLights.h"

#include "vtkShaderProgram.h"

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
bool Frame::ResolvesEquiangular(int index, Lists lists)
{
  return IsEquiangular(this->GetScene(), index) && !this->TransmitsShadows && lists != Lists::Map &&
    (lists == Lists::None || this->Boundaries.HasKBuffer());
}

//------------------------------------------------------------------------------
std::string Frame::GetEquiangularResolveSource(int index, Lists lists) const
{
  const bool planes = lists != Lists::None;
  // AirlightConstants.glsl sets a part of the light.
  return this->GetResolveHead(index, planes) +
    "uniform AirlightLight givenLight;\nAirlightLight light;\n" + GetEquiangularSource() +
    AirlightShadowCounts +
    (planes ? this->Boundaries.GetPackedSource(lists != Lists::Short)
            : AirlightNoPackedBoundaries) +
    AirlightEquiangularRay + AirlightResolveOutputs + AirlightEquiangularFS;
}

//------------------------------------------------------------------------------
std::string Frame::GetResolveSource(int index, Lists lists, bool fragmentsOnly)
{
  const bool records = this->Plan.TranslucentFragments;
  if (this->ResolvesEquiangular(index, lists) && !fragmentsOnly)
  {
    return this->GetEquiangularResolveSource(index, lists);
  }
  const bool planes = lists != Lists::None && lists != Lists::Map;
  const bool march = this->Plan.Shadows == ShadowMethod::March;
  const std::string layers =
    records ? std::string(AirlightTranslucentLists) + AirlightResolveTranslucent : std::string();
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
  return this->GetResolveHead(index, planes || records || this->TransmitsShadows) +
    (records ? "#define AIRLIGHT_TRANSLUCENT_FRAGMENTS\n" : "") +
    (march ? "#define AIRLIGHT_RAY_MARCH\n" : "") + GivenUniforms +
    (this->TransmitsShadows ? AirlightTransmittanceBuffer : "") + AirlightShadowCounts +
    boundaries + AirlightResolveOutputs + AirlightResolveFS;
}

//------------------------------------------------------------------------------
// What the sources of a light's airlight begin with.
std::string Frame::GetResolveHead(int index, bool storage) const
{
  const f64::AirlightLight& light = this->SceneLights[index].Values;
  return GetShaderVersion(storage) + BoundaryBuffer::DefineNodes(this->TransmitsShadows) +
    (this->Plan.Record ? RecordDefinition : "") + "#define AIRLIGHT_MORE_LIT " +
    std::to_string(this->HasMoreLit()) + "\n" +
    "#define AIRLIGHT_FULL_SCREEN\n#define AIRLIGHT_FRAGMENT_IS_PIXEL\n#define AIRLIGHT_PARALLEL " +
    std::to_string(this->Rays->IsParallel()) + "\n" +
    (light.cosCone > 0.0 ? "" : "#define AIRLIGHT_NO_CONE\n") +
    GetScatteringSource(this->Media, light.kind, light.goniometric != 0) + AirlightCameraShader;
}

//------------------------------------------------------------------------------
// Of a light's airlight, relative to that without shadows.
double Frame::GetIntegralError(int index) const
{
  const SceneLight& sceneLight = this->SceneLights[index];
  const bool cut =
    HasGrid(this->Media) && this->Media.item[0].region.kind != AIRLIGHT_REGION_UNBOUNDED;
  double error = sceneLight.GridError +
    (cut                                  ? CutImageError
        : IsQuadrature(sceneLight.Values) ? QuadratureError
                                          : ClosedFormError);
  if (this->TransmitsShadows && this->SceneLights[index].CastsShadows)
  {
    double thickness = 0.0;
    for (const CasterOpticalThickness& layer : this->Volumes[index].GetLayers())
    {
      thickness = std::max(thickness, GetThicknessError(layer));
    }
    error += thickness;
  }
  return error;
}

//------------------------------------------------------------------------------
void Frame::SetResolveUniforms(
  vtkShaderProgram* program, int index, Lists lists, bool fragmentsOnly)
{
  this->Rays->SetUniforms(program, 0, 0);
  const bool equiangular = this->ResolvesEquiangular(index, lists) && !fragmentsOnly;
  if (equiangular)
  {
    SetMediaUniforms(program, "givenMedia", this->Media);
    SetLightUniforms(program, "givenLight", this->SceneLights[index].Values);
    SetEquiangularConstants(program, this->GetScene(), { index });
  }
  else
  {
    SetMediaUniforms(program, "media", this->Media);
    SetLightUniforms(program, "light", this->SceneLights[index].Values);
  }
  if (f64::airlightIsDirectional(this->SceneLights[index].Values))
  {
    program->SetUniformi("lightHasPixel", 0);
  }
  else
  {
    this->Rays->SetFootUniforms(program, this->SceneLights[index].Values.position);
  }
  const bool planes = lists != Lists::None && lists != Lists::Map;
  this->SetStartUniforms(program, index, planes);
  glm::vec4 bit(0.0f);
  if (index < MaximumShadowingLights)
  {
    bit[index / BitsPerChannel] = std::ldexp(1.0f, index % BitsPerChannel);
  }
  program->SetUniform4f("litBit", &bit.x);
  if (this->Plan.Record)
  {
    program->SetUniformf("phaseError", static_cast<float>(this->Plan.PhaseErrorBound));
    program->SetUniformf("error", static_cast<float>(this->GetIntegralError(index)));
  }
  if (this->Plan.TranslucentFragments && !equiangular)
  {
    this->FragmentLists.Use(program);
    program->SetUniformi("lightBit", index < MaximumShadowingLights ? index : -1);
    // No test fails without it, see AirlightOpenGL.h.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  if (planes)
  {
    this->Boundaries.Use(program);
    program->SetUniformi("resume", lists == Lists::LongRest ? 1 : 0);
    // No test fails without it, see AirlightOpenGL.h.
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
  if (this->Plan.Shadows == ShadowMethod::March)
  {
    scale = GetFadingLength(this->Media);
  }
  program->SetUniformi("marchSteps", this->Plan.Steps);
  program->SetUniformf("marchScale", static_cast<float>(scale));
}
}
