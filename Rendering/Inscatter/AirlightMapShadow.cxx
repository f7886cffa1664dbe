// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightMapShadow.h"

#include "AirlightMapBoundaries.h"
#include "AirlightMapLookup.h"
#include "AirlightMapMarch.h"
#include "AirlightRayMarch.h"
#include "AirlightSliceLayout.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// A step of a ray march is so many columns of a slice.
constexpr int ColumnsPerStep = 16;

// The longest way on which light of any channel falls to 1/e; 1 where none does.
double GetFadingLength(const f64::AirlightMedia& media)
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

//------------------------------------------------------------------------------
MapShadow::MapShadow(MapPrograms& programs, bool march)
  : Programs(programs)
  , March(march)
{
}

//------------------------------------------------------------------------------
bool MapShadow::Update(
  const FrameScene& scene, int light, const ShadowCasters& casters, const InscatterTargets& targets)
{
  if (this->Map.Update(
        casters.Polygonal, casters.NonPolygonal, scene.Lights[light], casters.MapResolution) &&
    !this->DrawMap(scene.Window, casters, targets))
  {
    return false;
  }
  return this->March || !this->Map.HasCasters() || this->DrawSlices(scene, targets);
}

//------------------------------------------------------------------------------
bool MapShadow::DrawSlices(const FrameScene& scene, const InscatterTargets& targets)
{
  const auto bind = [&targets](
                      vtkTextureObject* texture) { return targets.Bind({ texture }, nullptr); };
  const int columns = ColumnsPerStep * this->Steps;
  const bool ok =
    this->Slices.Draw(scene.Window, this->Map, scene.Rays, columns, this->Programs.Slices, bind);
  scene.Window->GetState()->vtkglViewport(0, 0, scene.Width, scene.Height);
  return ok || this->Fail(this->Slices.GetError());
}

//------------------------------------------------------------------------------
bool MapShadow::BindTarget(const InscatterTargets& targets, vtkTextureObject* texture)
{
  const std::string reason = targets.Bind({ texture }, nullptr);
  return reason.empty() || this->Fail(reason);
}

//------------------------------------------------------------------------------
bool MapShadow::DrawMap(
  vtkOpenGLRenderWindow* window, const ShadowCasters& casters, const InscatterTargets& targets)
{
  if (!this->Map.Prepare(window))
  {
    return this->Fail(this->Map.GetError());
  }
  if (!this->BindTarget(targets, this->Map.GetTexture()))
  {
    return false;
  }
  if (!this->Map.Draw(window, this->Programs.Casters))
  {
    return this->Fail(this->Map.GetError());
  }
  if (!this->Map.HasNonPolygonal())
  {
    return true;
  }
  if (!this->BindTarget(targets, this->Map.GetNonPolygonalTexture()))
  {
    return false;
  }
  this->Map.DrawNonPolygonal(window, casters.DrawNonPolygonal);
  if (!this->BindTarget(targets, this->Map.GetTexture()))
  {
    return false;
  }
  return this->Map.MergeNonPolygonal(window, this->Programs.Merge) ||
    this->Fail(this->Map.GetError());
}

//------------------------------------------------------------------------------
std::string MapShadow::GetBoundarySource(const InscatterDraw&, bool) const
{
  return this->March ? std::string("#define AIRLIGHT_RAY_MARCH\n") + AirlightMapLookup +
      AirlightMapMarch + AirlightRayMarch
                     : std::string(AirlightMapLookup) + AirlightSliceLayout + AirlightMapBoundaries;
}

//------------------------------------------------------------------------------
LightShadow::Textures MapShadow::GetTextures()
{
  vtkTextureObject* map = this->Map.HasCasters() ? this->Map.GetTexture() : nullptr;
  if (this->March)
  {
    return { { "shadowMap", map } };
  }
  return { { "shadowMap", map }, { "slices", this->Slices.GetTexture() },
    { "sliceRanges", this->Slices.GetRanges() } };
}

//------------------------------------------------------------------------------
std::string MapShadow::GetLookupSource() { return AirlightMapLookup; }

//------------------------------------------------------------------------------
void MapShadow::SetLookup(vtkShaderProgram* program, const FrameScene& scene) const
{
  this->Map.GetProjection().SetUniforms(program, scene.Rays);
}

//------------------------------------------------------------------------------
void MapShadow::Release(vtkWindow* window)
{
  this->Map.Release(window);
  this->Slices.Release(window);
}

//------------------------------------------------------------------------------
void MapShadow::Bind(vtkShaderProgram* program, const FrameScene& scene, const InscatterDraw&)
{
  if (this->Map.HasCasters())
  {
    this->Map.GetProjection().SetUniforms(program, scene.Rays);
  }
  else
  {
    program->SetUniformi("mapKind", 0);
  }
  if (!this->March)
  {
    this->Slices.SetUniforms(program);
    return;
  }
  const double scale = GetFadingLength(scene.Media);
  program->SetUniformi("marchSteps", this->Steps);
  program->SetUniformf("marchScale", static_cast<float>(scale));
}
}
