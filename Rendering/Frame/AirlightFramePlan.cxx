// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightFramePlan.h"

#include "Integration/AirlightMath.h"
#include "MapperShaders/AirlightSpecialization.h"
#include "MapperShaders/AirlightVolumeShader.h"
#include "Scene/AirlightUnshadowedLights.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
namespace
{
// Shaders take time to compile for each light that they integrate: MaximumUnshadowedLights of a
// closed form in the composite, one of any other kind.
bool HasClosedForm(int kind)
{
  return kind == AIRLIGHT_POINT_CLOSED || kind == AIRLIGHT_DIRECTIONAL_CLOSED;
}

bool HasShadowing(const SceneFacts& scene)
{
  return std::any_of(scene.Lights.begin(), scene.Lights.end(),
    [](const LightFacts& light) { return light.Shadows(); });
}

//------------------------------------------------------------------------------
void ChooseTechnique(FramePlan& plan, const PassProperties& properties, const SceneFacts& scene,
  const FrameLimits& limits)
{
  const bool automatic = properties.Technique == ShadowTechnique::Automatic;
  plan.Technique = properties.Technique;
  if (!automatic && properties.Technique != ShadowTechnique::Planes)
  {
    return;
  }
  plan.Technique = ShadowTechnique::Planes;
  plan.LimitPlanes = automatic;
  if (automatic)
  {
    plan.MaximumBoundaries = properties.MaximumBoundaries;
  }
  const bool casts = (!scene.Clear || properties.SurfaceShadows) && HasShadowing(scene);
  if (!limits.StorageBuffers)
  {
    plan.Technique = ShadowTechnique::Map;
    plan.Reason = TechniqueReason::NoStorageBuffers;
  }
  else if (limits.PlanesOverMemory)
  {
    plan.Technique = ShadowTechnique::Map;
    plan.Reason = TechniqueReason::PlanesOverMemory;
  }
  else if (scene.NonPolygonalCasters && casts)
  {
    // Requested planes are drawn without those. Maps know of light and dark only.
    const bool transmits = properties.TranslucentShadows && scene.TranslucentCasters;
    plan.MapNonPolygonal = automatic && !transmits;
    plan.Technique = automatic && transmits ? ShadowTechnique::Map : ShadowTechnique::Planes;
    plan.Reason = TechniqueReason::NonPolygonalCasters;
  }
}

//------------------------------------------------------------------------------
ShadowMethod GetMethod(ShadowTechnique technique)
{
  switch (technique)
  {
    case ShadowTechnique::Planes:
      return ShadowMethod::Planes;
    case ShadowTechnique::Map:
      return ShadowMethod::Map;
    case ShadowTechnique::March:
      return ShadowMethod::March;
    default:
      return ShadowMethod::None;
  }
}

//------------------------------------------------------------------------------
// What is encoded for display has to be encoded again.
ColorSpace GetColorSpace(const PassProperties& properties)
{
  const ColorSpace space = properties.Display.Space;
  return !properties.LinearInput && space == ColorSpace::Linear ? ColorSpace::Gamma22 : space;
}

// Whether VTK's own picture is what the display would make of it.
bool IsShownAsDrawn(const PassProperties& properties)
{
  const ColorSpace input = properties.LinearInput ? ColorSpace::Linear : ColorSpace::Gamma22;
  return properties.Display.Curve == ToneMapping::Clamp && GetColorSpace(properties) == input &&
    properties.Display.Exposure == 1.0 && !properties.AutomaticExposure;
}

//------------------------------------------------------------------------------
bool IsPlain(const FramePlan& plan, const PassProperties& properties, const SceneFacts& scene)
{
  const bool shadows = plan.Shadows != ShadowMethod::None && properties.SurfaceShadows;
  return scene.Clear && !scene.VisibleLamps && properties.View == DebugView::Shaded &&
    !properties.RecordBuffers && (!properties.LinearFrame || properties.EdgeSample) &&
    properties.Annotations && IsShownAsDrawn(properties) &&
    std::none_of(scene.Lights.begin(), scene.Lights.end(), [shadows](const LightFacts& light) {
      return light.Photometric || (shadows && light.Shadows());
    });
}

//------------------------------------------------------------------------------
int CountDimmed(const SceneFacts& scene)
{
  return static_cast<int>(std::count_if(scene.Lights.begin(), scene.Lights.end(),
    [](const LightFacts& light) { return light.Scatters; }));
}

// More rows are beyond some graphics cards' textures.
int CountLightLayers(const SceneFacts& scene)
{
  constexpr int MostRows = 8192;
  constexpr int MostLayers = 8;
  constexpr double MostBytes = 268435456.0;
  constexpr double BytesOfPixel = 16.0;
  const double room = MostBytes / (BytesOfPixel * scene.Width * scene.Height);
  return std::min({ CountDimmed(scene), MostLayers, MostRows / std::max(scene.Height, 1),
    static_cast<int>(std::min(room, 1.0 * MostLayers)) });
}

// Shadows on surfaces, and what media leave of lights where that takes long, are known only after
// the distances. Where a single light casts shadows, colours are drawn with and without it.
void PlanGeometryPasses(FramePlan& plan, const SceneFacts& scene)
{
  plan.LightLayers = scene.LongWays ? CountLightLayers(scene) : 0;
  plan.AllLightLayers = plan.LightLayers == CountDimmed(scene);
  plan.SingleGeometryPass = plan.AllShadersInjectable && plan.LightLayers == 0;
  if (plan.LightLayers > 0 || !plan.AllShadersInjectable || plan.Shadows == ShadowMethod::None ||
    !plan.SurfaceShadows)
  {
    return;
  }
  const auto shadows = [](const LightFacts& light) { return light.Shadows(); };
  const auto first = std::find_if(scene.Lights.begin(), scene.Lights.end(), shadows);
  if (first == scene.Lights.end())
  {
    return;
  }
  const bool transmits =
    plan.Shadows == ShadowMethod::Planes && plan.TranslucentShadows && scene.TranslucentCasters;
  plan.SingleGeometryPass = plan.AllOpaque && !transmits &&
    scene.Lights.size() <= MaximumSpecializedLights &&
    std::count_if(scene.Lights.begin(), scene.Lights.end(), shadows) == 1;
  if (plan.SingleGeometryPass)
  {
    plan.ShadowingLight = static_cast<int>(first - scene.Lights.begin());
  }
}

//------------------------------------------------------------------------------
std::vector<LightFacts> GetScatteringLights(const SceneFacts& scene)
{
  std::vector<LightFacts> lights;
  std::copy_if(scene.Lights.begin(), scene.Lights.end(), std::back_inserter(lights),
    [](const LightFacts& light) { return light.Scatters && light.HasPower; });
  return lights;
}

//------------------------------------------------------------------------------
// The composite's shader is compiled for one kind of light without photometry. It makes frames
// without shadows a fifth shorter (Documentation/benchmarks.md).
bool IsUnshadowedInComposite(const FramePlan& plan, const SceneFacts& scene)
{
  if (plan.Record || plan.TranslucentFragments || plan.Froxels || plan.View != DebugView::Shaded ||
    plan.Shadows == ShadowMethod::March || scene.DensityImage)
  {
    return false;
  }
  if (plan.Shadows != ShadowMethod::None && HasShadowing(scene))
  {
    return false;
  }
  const std::vector<LightFacts> lights = GetScatteringLights(scene);
  return std::all_of(lights.begin(), lights.end(), [&](const LightFacts& light) {
    return light.Kind == lights[0].Kind && !light.Photometric &&
      lights.size() <= (HasClosedForm(light.Kind) ? MaximumUnshadowedLights : 1);
  });
}

// Without shadows one closed form in the fragments' own shader takes a fraction of the time of
// records (Documentation/benchmarks.md). Quadrature would take long to compile there. Volumes,
// which need it at several places on each ray, gain nothing.
bool IsUnshadowedInFragments(const FramePlan& plan, const SceneFacts& scene)
{
  const std::vector<LightFacts> lights = GetScatteringLights(scene);
  return plan.Shadows == ShadowMethod::None && !scene.DensityImage && scene.Volumes == 0 &&
    lights.size() <= MaximumUnshadowedLights &&
    std::all_of(lights.begin(), lights.end(), [&lights](const LightFacts& light) {
      return HasClosedForm(light.Kind) && light.Kind == lights[0].Kind && !light.Photometric;
    });
}

//------------------------------------------------------------------------------
// Volumes have nodes of their own on each ray.
bool IsInFroxels(const FramePlan& plan, const SceneFacts& scene)
{
  return plan.Shadows == ShadowMethod::Planes && scene.TranslucentBoundaries >= 0.0 &&
    plan.GetTranslucentCost() > plan.MaximumBoundaries && scene.Volumes == 0;
}
}

//------------------------------------------------------------------------------
// Clear air is shown in VTK's own colours.
DisplayStage GetDisplay(const PassProperties& properties, bool clear)
{
  DisplayStage display = properties.Display;
  display.Space = GetColorSpace(properties);
  display.Dithering = display.Dithering && !(clear && IsShownAsDrawn(properties));
  return display;
}

bool MeasuresExposure(const PassProperties& properties)
{
  return properties.AutomaticExposure && properties.View == DebugView::Shaded;
}

//------------------------------------------------------------------------------
FramePlan MakeFramePlan(
  const PassProperties& properties, const SceneFacts& scene, const FrameLimits& limits)
{
  FramePlan plan;
  ChooseTechnique(plan, properties, scene, limits);
  plan.Shadows = GetMethod(plan.Technique);
  plan.Plain = IsPlain(plan, properties, scene);
  plan.MapResolution = properties.MapResolution;
  plan.Steps = properties.Steps;
  plan.SurfaceShadows = properties.SurfaceShadows;
  plan.TranslucentShadows = properties.TranslucentShadows;
  plan.ScatteredSurfaceLight = properties.ScatteredSurfaceLight && !scene.DensityImage;
  plan.MultipleErrorBound = scene.MultipleErrorBound;
  plan.MemoryLimit = properties.MemoryLimit;
  plan.Translucent = properties.View == DebugView::Shaded && scene.DrawsOverMedium;
  plan.TranslucentBoundaries = std::max(scene.TranslucentBoundaries, 0.0);
  plan.GaussianFragments = plan.Translucent ? scene.GaussianFragments : 0.0;
  plan.Froxels = IsInFroxels(plan, scene);
  plan.CastersInFroxels = plan.Froxels && plan.TranslucentShadows && scene.TranslucentCasters;
  plan.NeedsRecords = limits.StorageBuffers && !limits.RecordsOverMemory && !plan.Froxels &&
    !IsUnshadowedInFragments(plan, scene);
  plan.RecordsOverMemory = plan.Translucent && limits.RecordsOverMemory && !plan.Froxels;
  plan.TranslucentFragments = plan.Translucent && plan.NeedsRecords;
  plan.VolumeNodes =
    GetVolumeNodeCount(scene.Volumes, scene.Width, scene.Height, properties.MemoryLimit);
  const bool gaussians = scene.PointGaussians && !plan.Translucent; // among the opaque surfaces
  plan.AllShadersInjectable = scene.AllShadersInjectable && !gaussians;
  plan.AllOpaque = scene.AllOpaque && !gaussians;
  plan.View = properties.View;
  plan.KeepBuffers = properties.RecordBuffers;
  plan.Annotations = properties.Annotations;
  plan.Record = properties.RecordBuffers || properties.View == DebugView::BoundaryCount;
  plan.EncodedInput = !properties.LinearInput;
  plan.LinearFrame = properties.LinearFrame;
  plan.Display = plan.LinearFrame ? DisplayStage() : GetDisplay(properties, scene.Clear);
  plan.MeasuresExposure = !plan.LinearFrame && MeasuresExposure(properties);
  plan.PhaseErrorBound = scene.PhaseErrorBound;
  PlanGeometryPasses(plan, scene);
  plan.UnshadowedInComposite = IsUnshadowedInComposite(plan, scene);
  return plan;
}
}
