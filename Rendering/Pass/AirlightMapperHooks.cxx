// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightMapperHooks.h"

#include "MapperShaders/AirlightVolumeShader.h"
#include "Pass/AirlightScenePass.h"

#include "vtkAbstractMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkVolume.h"

namespace airlight
{
//------------------------------------------------------------------------------
void MapperHooks::Update(const FramePlan& plan, const f64::AirlightMedia& media,
  const std::vector<SceneLight>& sceneLights, const FrameInput& input)
{
  this->Window = input.Window;
  this->NotCompiled.clear();
  this->UpdateOptions(plan, media, sceneLights, input);
  if (this->Materials.Update(input.Actors, plan.AllShadersInjectable))
  {
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
// Translucency stays: surfaces that become translucent for a moment shall not rebuild all shaders
// each time.
void MapperHooks::UpdateOptions(const FramePlan& plan, const f64::AirlightMedia& media,
  const std::vector<SceneLight>& sceneLights, const FrameInput& input)
{
  SurfaceShaderOptions& options = this->Options;
  // Where nothing is translucent now, none are needed: those that there were stay.
  const bool records = input.StorageBuffers &&
    (plan.NeedsRecords || (!plan.Translucent && options.TranslucentFragments));
  const bool translucent = plan.Translucent || options.Translucent;
  const bool hides = options.Hides || input.Delegate;
  const bool reads =
    !plan.SingleGeometryPass && plan.Shadows != ShadowMethod::None && plan.SurfaceShadows;
  const KnownWays ways = plan.LightLayers == 0 ? KnownWays::None
    : plan.AllLightLayers                      ? KnownWays::All
                                               : KnownWays::Some;
  // Shadow maps may be drawn with the same shaders.
  const bool known = plan.SingleGeometryPass &&
    (plan.Shadows == ShadowMethod::None ||
      (plan.Shadows == ShadowMethod::Planes && !plan.MapNonPolygonal));
  const bool other = records != options.TranslucentFragments || hides != options.Hides ||
    reads != options.ReadsLit || ways != options.Ways ||
    plan.SingleGeometryPass != options.SingleGeometryPass ||
    plan.ShadowingLight != options.ShadowingLight || known != options.ViewportIsTarget ||
    plan.Froxels != options.Froxels || plan.EncodedInput != options.EncodedInput ||
    (known && input.Parallel != options.Parallel);
  options.TranslucentFragments = records;
  options.Froxels = plan.Froxels;
  options.EncodedInput = plan.EncodedInput;
  options.ViewportIsTarget = known;
  options.Parallel = known && input.Parallel;
  options.Hides = hides;
  options.ReadsLit = reads;
  options.Ways = ways;
  options.SingleGeometryPass = plan.SingleGeometryPass;
  options.ShadowingLight = plan.ShadowingLight;
  if (UpdateSurfaceShaderOptions(
        options, media, sceneLights, plan.ScatteredSurfaceLight, translucent) ||
    other)
  {
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
// It stays, as translucency does.
void MapperHooks::AddShadowTransmittance()
{
  if (!this->Options.TransmitsShadows)
  {
    this->Options.TransmitsShadows = true;
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
void MapperHooks::MarkShader(std::string& fragment, vtkProp* prop)
{
  if (vtkVolume::SafeDownCast(prop))
  {
    MarkVolumeShader(fragment);
  }
}

//------------------------------------------------------------------------------
// VTK's mappers do not survive a shader that does not compile. So it is compiled before they do it;
// they find it compiled in the window's cache.
void MapperHooks::ChangeShader(const std::string& vertex, std::string& geometry,
  std::string& fragment, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (!this->NotCompiled.empty())
  {
    return;
  }
  std::string changed = fragment;
  std::string changedGeometry = geometry;
  if (vtkVolume::SafeDownCast(prop))
  {
    InjectVolumeShader(changed, this->Options);
  }
  else
  {
    SpecializeShader(changed, { this->Options.Lights, this->Materials.Compile(prop) });
    const bool splats = AirlightScenePass::IsPointGaussians(prop);
    this->ChangeSurfaceShader(changed, splats);
    if (splats)
    {
      KeepSplatDepth(changedGeometry);
    }
  }
  if (this->Window && IsLastToChange(this->Pass, prop) &&
    !this->Programs.GetOrCompile(this->Window, vertex, changed, changedGeometry))
  {
    this->NotCompiled = mapper->GetClassName();
    return;
  }
  fragment = changed;
  geometry = changedGeometry;
}

//------------------------------------------------------------------------------
void MapperHooks::ChangeSurfaceShader(std::string& shader, bool splats)
{
  const vtkMTimeType time = this->ShaderTime;
  const bool records = this->Options.TranslucentFragments;
  Change& last = this->LastChange;
  if (last.Time != time || last.PointGaussians != splats || last.Records != records ||
    last.Source != shader)
  {
    last = { shader, shader, splats, records, time };
    InjectSurfaceShader(last.After, this->Options, splats);
  }
  shader = last.After;
}

//------------------------------------------------------------------------------
bool MapperHooks::CheckCompiled(std::string& error)
{
  if (this->NotCompiled.empty())
  {
    return true;
  }
  this->ShaderTime.Modified();
  error = "the shader of a " + this->NotCompiled + " with the medium" + ProgramMaker::GetReason();
  return false;
}
}
