// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan of a frame, without a window: each decision of its own, from a scene of balls in fog with one
// lamp that casts shadows.

#include "AirlightTestCheck.h"
#include "Frame/AirlightFramePlan.h"
#include "Integration/AirlightMath.h"

#include <cmath>
#include <cstdlib>

using namespace airlight;
using airlight_test::Check;

namespace
{
LightFacts MakeLamp(bool casts = true) { return { true, casts, AIRLIGHT_POINT_CLOSED, false }; }

struct Case
{
  PassProperties Properties;
  SceneFacts Scene;
  FrameLimits Limits;

  Case()
  {
    this->Scene.Lights = { MakeLamp() };
    this->Scene.AllShadersInjectable = true;
    this->Scene.AllOpaque = true;
    this->Scene.Width = 800;
    this->Scene.Height = 600;
  }
  FramePlan Make() const { return MakeFramePlan(this->Properties, this->Scene, this->Limits); }
};

//------------------------------------------------------------------------------
void TestTechnique()
{
  Case scene;
  FramePlan plan = scene.Make();
  Check(plan.Technique == ShadowTechnique::Planes && plan.Shadows == ShadowMethod::Planes &&
      plan.Reason == TechniqueReason::AsAsked && plan.LimitPlanes &&
      plan.MaximumBoundaries == scene.Properties.MaximumBoundaries,
    "polygons cast by planes, within the memory limit and that of boundaries");

  scene.Limits.StorageBuffers = false;
  plan = scene.Make();
  Check(plan.Shadows == ShadowMethod::Map && plan.Reason == TechniqueReason::NoStorageBuffers,
    "maps below OpenGL 4.3");
  scene.Limits.StorageBuffers = true;

  scene.Limits.PlanesOverMemory = true;
  plan = scene.Make();
  Check(plan.Shadows == ShadowMethod::Map && plan.Reason == TechniqueReason::PlanesOverMemory,
    "maps where planes need too much memory");
  scene.Scene.NonPolygonalCasters = true;
  Check(scene.Make().Shadows == ShadowMethod::Map, "with casters without polygons, too");
  scene.Limits.PlanesOverMemory = false;

  scene.Scene.NonPolygonalCasters = true;
  plan = scene.Make();
  Check(plan.Shadows == ShadowMethod::Planes && plan.MapNonPolygonal &&
      plan.Reason == TechniqueReason::NonPolygonalCasters,
    "maps for casters without polygons, beside the planes of others");
  scene.Scene.TranslucentCasters = true;
  plan = scene.Make();
  Check(plan.Shadows == ShadowMethod::Map && !plan.MapNonPolygonal, "or alone");
  scene.Scene.TranslucentCasters = false;
  scene.Properties.Technique = ShadowTechnique::Planes;
  plan = scene.Make();
  Check(plan.Shadows == ShadowMethod::Planes &&
      plan.Reason == TechniqueReason::NonPolygonalCasters && !plan.LimitPlanes &&
      !plan.MapNonPolygonal && std::isinf(plan.MaximumBoundaries),
    "requested planes leave them out, whatever memory they take");
  scene.Scene.Lights[0].CastsShadows = false;
  Check(scene.Make().Reason == TechniqueReason::AsAsked, "nothing casts: no reason");

  for (const ShadowTechnique technique :
    { ShadowTechnique::None, ShadowTechnique::Map, ShadowTechnique::March })
  {
    scene.Properties.Technique = technique;
    Check(scene.Make().Technique == technique, "a technique without conditions is taken");
  }
}

//------------------------------------------------------------------------------
void TestPlain()
{
  Case scene;
  scene.Scene.Clear = true;
  Check(!scene.Make().Plain, "clear air with shadows on surfaces is not plain");
  scene.Properties.SurfaceShadows = false;
  Check(scene.Make().Plain, "clear air without them is VTK's picture");
  scene.Scene.Lights[0].Photometric = true;
  Check(!scene.Make().Plain, "a photometric file changes surfaces");
  scene.Scene.Lights[0].Photometric = false;
  scene.Properties.RecordBuffers = true;
  Check(!scene.Make().Plain, "buffers are to be recorded");
  scene.Properties.RecordBuffers = false;
  scene.Properties.Annotations = false;
  Check(!scene.Make().Plain, "annotations are left out");
  scene.Properties.Annotations = true;
  scene.Properties.View = DebugView::AirlightOnly;
  Check(!scene.Make().Plain, "the airlight alone is shown");
}

//------------------------------------------------------------------------------
void TestGeometryPasses()
{
  Case scene;
  FramePlan plan = scene.Make();
  Check(plan.SingleGeometryPass && plan.ShadowingLight == 0,
    "one light casts: the scene is drawn once, with and without it");
  scene.Scene.Lights.insert(scene.Scene.Lights.begin(), MakeLamp(false));
  plan = scene.Make();
  Check(plan.SingleGeometryPass && plan.ShadowingLight == 1, "the second light casts");
  scene.Scene.Lights[0].CastsShadows = true;
  plan = scene.Make();
  Check(!plan.SingleGeometryPass && plan.ShadowingLight == -1, "two lights cast: two passes");
  scene.Properties.SurfaceShadows = false;
  plan = scene.Make();
  Check(plan.SingleGeometryPass && plan.ShadowingLight == -1, "no shadows on surfaces: one pass");

  Case other;
  other.Scene.AllOpaque = false;
  Check(!other.Make().SingleGeometryPass, "a surface that may let light through: two passes");
  other.Scene.AllOpaque = true;
  other.Scene.TranslucentCasters = true;
  Check(!other.Make().SingleGeometryPass, "glass that casts: two passes");
  other.Properties.TranslucentShadows = false;
  Check(other.Make().SingleGeometryPass, "glass that does not: one pass");
  other.Scene.Lights.resize(8, MakeLamp(false));
  Check(other.Make().SingleGeometryPass, "eight lights, as many as shaders are unrolled for");
  other.Scene.Lights.resize(9, MakeLamp(false));
  Check(!other.Make().SingleGeometryPass, "nine lights, more than that");
  other.Scene.AllShadersInjectable = false;
  other.Properties.Technique = ShadowTechnique::None;
  Check(!other.Make().SingleGeometryPass, "a shader that the pass cannot change: two passes");

  Case image;
  image.Scene.LongWays = true;
  FramePlan walked = image.Make();
  Check(!walked.SingleGeometryPass && walked.LightLayers == 1 && walked.AllLightLayers,
    "ways through an image are walked once distances are known");
  image.Scene.Lights.resize(9, MakeLamp(true));
  walked = image.Make();
  Check(walked.LightLayers == 8 && !walked.AllLightLayers, "those of eight lights at most");
  image.Scene.Width = 8000;
  image.Scene.Height = 1000;
  Check(image.Make().LightLayers == 2, "those of two in 256 MB");
  image.Scene.Height = 8000;
  Check(image.Make().LightLayers == 0, "there is no room for any");
  for (LightFacts& light : image.Scene.Lights)
  {
    light.Scatters = false;
  }
  Check(image.Make().LightLayers == 0, "no light scatters");

  Case gaussians;
  gaussians.Scene.PointGaussians = true;
  gaussians.Scene.DrawsOverMedium = true;
  Check(gaussians.Make().SingleGeometryPass, "Gaussians over the medium: one pass for the others");
  gaussians.Properties.View = DebugView::AirlightOnly;
  Check(!gaussians.Make().SingleGeometryPass, "Gaussians among the others: two passes");
  Check(!gaussians.Make().AllOpaque, "Gaussians among the others: they blend");
}

//------------------------------------------------------------------------------
void TestUnshadowedInComposite()
{
  Case scene;
  Check(!scene.Make().UnshadowedInComposite, "a light with shadows has a step of its own");
  scene.Properties.Technique = ShadowTechnique::None;
  Check(scene.Make().UnshadowedInComposite, "one without is integrated in the composite");
  scene.Scene.Lights.resize(4, MakeLamp());
  Check(scene.Make().UnshadowedInComposite, "so are four of a closed form");
  scene.Scene.Lights.resize(5, MakeLamp());
  Check(!scene.Make().UnshadowedInComposite, "five are not");
  scene.Scene.Lights.resize(1);
  scene.Scene.Lights[0].Kind = AIRLIGHT_POINT_QUADRATURE;
  Check(scene.Make().UnshadowedInComposite, "one by quadrature is");
  scene.Scene.Lights.resize(2, scene.Scene.Lights[0]);
  Check(!scene.Make().UnshadowedInComposite, "two by quadrature are not");
  scene.Scene.Lights[1].Kind = AIRLIGHT_POINT_CLOSED;
  Check(!scene.Make().UnshadowedInComposite, "nor are two kinds");
  scene.Scene.Lights[1].Scatters = false;
  Check(scene.Make().UnshadowedInComposite, "a light that does not scatter counts for nothing");
  scene.Scene.Lights[1].Scatters = true;
  scene.Scene.Lights[1].HasPower = false;
  Check(scene.Make().UnshadowedInComposite, "nor does one without power in the medium");
  scene.Properties.Technique = ShadowTechnique::Planes;
  Check(!scene.Make().UnshadowedInComposite, "but for its shadows on surfaces");
  scene.Properties.Technique = ShadowTechnique::None;
  scene.Scene.DensityImage = true;
  Check(!scene.Make().UnshadowedInComposite, "an image of density needs a step of its own");
  scene.Scene.DensityImage = false;
  scene.Scene.DrawsOverMedium = true;
  Check(!scene.Make().UnshadowedInComposite, "so do translucent surfaces");
}

//------------------------------------------------------------------------------
void TestFroxels()
{
  Case scene;
  scene.Scene.DrawsOverMedium = true;
  scene.Scene.TranslucentCasters = true;
  scene.Scene.TranslucentBoundaries = 16.0;
  FramePlan plan = scene.Make();
  Check(!plan.Froxels && plan.TranslucentFragments, "as many boundaries as there may be");
  scene.Scene.TranslucentBoundaries = 17.0;
  plan = scene.Make();
  Check(plan.Froxels && plan.CastersInFroxels && !plan.TranslucentFragments && !plan.NeedsRecords,
    "more are in a grid, and no fragment has a record");
  Check(plan.Shadows == ShadowMethod::Planes && !plan.SingleGeometryPass,
    "opaque casters keep their planes, surfaces wait for the grid");

  scene.Scene.Volumes = 1;
  Check(!scene.Make().Froxels, "volumes have nodes of their own");
  scene.Scene.Volumes = 0;
  scene.Properties.Technique = ShadowTechnique::Planes;
  Check(!scene.Make().Froxels, "not where planes are requested");
  scene.Properties.Technique = ShadowTechnique::Automatic;
  scene.Scene.NonPolygonalCasters = true;
  Check(!scene.Make().Froxels, "nor where maps are alone");
  scene.Scene.NonPolygonalCasters = false;

  scene.Scene.TranslucentCasters = false;
  scene.Scene.TranslucentBoundaries = 0.0;
  scene.Scene.GaussianFragments = 2.0;
  Check(!scene.Make().Froxels, "a fragment counts as eight boundaries");
  scene.Scene.GaussianFragments = 2.1;
  plan = scene.Make();
  Check(plan.Froxels && !plan.CastersInFroxels && plan.SingleGeometryPass,
    "more fragments read a grid; surfaces do not");
  scene.Scene.TranslucentBoundaries = -1.0;
  Check(!scene.Make().Froxels, "casters that cannot be in a grid keep records, too");
}

//------------------------------------------------------------------------------
void TestOutputs()
{
  Case scene;
  FramePlan plan = scene.Make();
  Check(!plan.Record && !plan.KeepBuffers && !plan.Translucent, "nothing is recorded");
  using airlight::ColorSpace;
  Check(
    !plan.EncodedInput && plan.Display.Space == ColorSpace::Linear, "linear colours stay linear");
  scene.Properties.Display.Space = ColorSpace::SRGB;
  Check(
    !scene.Make().EncodedInput && scene.Make().Display.Space == ColorSpace::SRGB, "or are encoded");
  scene.Properties.Display.Space = ColorSpace::Linear;
  scene.Properties.LinearInput = false;
  Check(scene.Make().EncodedInput && scene.Make().Display.Space == ColorSpace::Gamma22,
    "encoded colours are encoded again");
  scene.Properties.View = DebugView::BoundaryCount;
  scene.Scene.DrawsOverMedium = true;
  plan = scene.Make();
  Check(plan.Record && !plan.KeepBuffers, "counts of boundaries are recorded, and not kept");
  Check(!plan.Translucent, "debug views leave translucent surfaces out");
  scene.Properties.View = DebugView::Shaded;
  plan = scene.Make();
  Check(plan.Translucent && plan.TranslucentFragments, "fragments have records");
  scene.Properties.Technique = ShadowTechnique::None;
  Check(!scene.Make().TranslucentFragments, "without shadows closed forms need no records");
  scene.Scene.Lights[0].Photometric = true;
  Check(scene.Make().TranslucentFragments, "quadrature keeps them");
  scene.Scene.Lights[0].Photometric = false;
  scene.Properties.Technique = ShadowTechnique::Automatic;
  scene.Limits.StorageBuffers = false;
  Check(scene.Make().Translucent && !scene.Make().TranslucentFragments, "not below OpenGL 4.3");
  scene.Limits.StorageBuffers = true;
  Check(!scene.Make().RecordsOverMemory, "there is room for records");
  scene.Limits.RecordsOverMemory = true;
  plan = scene.Make();
  Check(plan.Translucent && !plan.TranslucentFragments && plan.RecordsOverMemory,
    "too many fragments have none");
  scene.Limits.RecordsOverMemory = false;

  scene.Properties.ScatteredSurfaceLight = true;
  Check(scene.Make().ScatteredSurfaceLight, "surfaces are lit by scattered light");
  scene.Scene.DensityImage = true;
  Check(!scene.Make().ScatteredSurfaceLight, "not in an image of density");

  Check(scene.Make().VolumeNodes == 2, "without volumes there are as few nodes as can be");
  scene.Scene.Volumes = 1;
  Check(scene.Make().VolumeNodes == 16, "rays through volumes have sixteen nodes");
  scene.Properties.MemoryLimit = 1;
  Check(scene.Make().VolumeNodes == 2, "rays through volumes have two nodes at least");
}
}

//------------------------------------------------------------------------------
int TestAirlightFramePlan(int, char*[])
{
  TestTechnique();
  TestPlain();
  TestGeometryPasses();
  TestUnshadowedInComposite();
  TestFroxels();
  TestOutputs();
  return airlight_test::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
