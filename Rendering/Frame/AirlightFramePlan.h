// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The plan of a frame: which steps it takes, and how. It follows from the properties of the pass,
 * the scene and the limits of OpenGL alone. No OpenGL is called.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightFramePlan_h
#define AirlightFramePlan_h

#include "Composite/AirlightDisplayStage.h"
#include "Inscatter/AirlightShadowMethod.h"
#include "vtkAirlightModule.h" // for export macro

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace airlight
{
// As vtkAirlightPass numbers them.
enum class ShadowTechnique
{
  None = 0,
  Planes = 1,
  Automatic = 2,
  Map = 3,
  March = 4,
  Froxels = 5 // of a frame or a light, never requested
};
enum class DebugView
{
  Shaded = 0,
  AirlightOnly = 1,
  BoundaryCount = 2,
  Outlines = 3
};

// The properties of vtkAirlightPass, with its defaults.
struct PassProperties
{
  ShadowTechnique Technique = ShadowTechnique::Automatic;
  DebugView View = DebugView::Shaded;
  double MaximumBoundaries = 16.0;
  int MapResolution = 1024;
  int Steps = 64;
  bool SurfaceShadows = true;
  bool TranslucentShadows = true;
  bool VolumeShadows = false;
  bool ScatteredSurfaceLight = false;
  bool LinearInput = true;
  DisplayStage Display;
  bool AutomaticExposure = false;
  bool LinearFrame = false; // one of a mean: its radiance is kept, and nothing drawn over it
  bool EdgeSample = false;  // of one mean at edges alone
  bool Annotations = true;
  bool RecordBuffers = false;
  std::uint64_t MemoryLimit = std::uint64_t(1) << 30; // bytes
};

// A light, as far as the plan depends on it.
struct LightFacts
{
  bool Scatters = false; // it lights surfaces through the medium
  bool CastsShadows = false;
  int Kind = 0; // f64::AirlightLight::kind: the method of integration
  bool Photometric = false;
  bool HasPower = true; // for the medium, which scatters it

  bool Shadows() const { return this->Scatters && this->CastsShadows; }
};

// A scene, as far as the plan depends on it.
struct SceneFacts
{
  bool Clear = false;           // no medium scatters or absorbs
  bool DensityImage = false;    // the density of a medium comes from an image
  bool LongWays = false;        // to be walked through images, volumes or closed surfaces
  double PhaseErrorBound = 0.0; // the largest of the media, relative
  double MultipleErrorBound = 0.0;
  std::vector<LightFacts> Lights;
  bool AllShadersInjectable = false; // all opaque props have shaders that the pass can add to
  bool PointGaussians = false;       // there are, and those are left out of account above
  bool AllOpaque = false;            // each fragment of an opaque prop hides what is behind it
  bool DrawsOverMedium = false; // there may be translucent surfaces, volumes or point Gaussians
  bool NonPolygonalCasters = false;
  bool TranslucentCasters = false; // among those that cast
  // Boundaries of translucent casters on a pixel, in the light with the most; below 0 if they
  // cannot be in a froxel grid.
  double TranslucentBoundaries = -1.0;
  double GaussianFragments = 0.0; // of a pixel, likewise
  std::size_t Volumes = 0;
  bool VisibleLamps = false; // which the renderer itself does not draw
  int Width = 1;
  int Height = 1;
};

struct FrameLimits
{
  bool StorageBuffers = true;     // OpenGL 4.3
  bool PlanesOverMemory = false;  // this frame's shadow planes have exceeded the memory limit
  bool RecordsOverMemory = false; // so have the records of translucent fragments the card's buffers
};

// Why the shadow technique is not the requested one.
enum class TechniqueReason
{
  AsAsked,
  NoStorageBuffers,
  NonPolygonalCasters,
  PlanesOverMemory
};

// The record of a translucent fragment takes as long as so many boundaries.
constexpr double BoundariesPerFragment = 8.0;

struct FramePlan
{
  // VTK's own picture: the medium is clear, and there are no shadows on surfaces. VTK then draws
  // the scene, with its own roundings and multisampling.
  bool Plain = false;

  ShadowTechnique Technique = ShadowTechnique::None; // never Automatic
  TechniqueReason Reason = TechniqueReason::AsAsked;
  ShadowMethod Shadows = ShadowMethod::None;
  bool LimitPlanes = false; // too many shadow boundaries are an error; the frame takes maps instead
  // Casters whose planes would give a pixel more boundaries have maps.
  double MaximumBoundaries = std::numeric_limits<double>::infinity();
  // Where translucent casters would give a pixel too many boundaries, or point Gaussians too many
  // fragments, a froxel grid takes the place of the planes of translucent casters and of the
  // records of fragments.
  bool Froxels = false;
  double TranslucentBoundaries = 0.0; // that a pixel would have
  double GaussianFragments = 0.0;
  bool CastersInFroxels = false; // there are some

  // What all that would cost, in boundaries.
  double GetTranslucentCost() const
  {
    return this->TranslucentBoundaries + BoundariesPerFragment * this->GaussianFragments;
  }
  bool MapNonPolygonal = false; // casters without planes have maps beside the planes of others
  int MapResolution = 1024;
  int Steps = 64;
  bool SurfaceShadows = false;
  bool TranslucentShadows = false;    // casters dim light by their opacity
  bool ScatteredSurfaceLight = false; // scattered light lights surfaces
  double MultipleErrorBound = 0.0;    // of what was scattered more than once, relative; 0: none

  bool Translucent = false;          // translucent surfaces or volumes are drawn over the medium
  bool NeedsRecords = false;         // their fragments have records, if there are any
  bool RecordsOverMemory = false;    // they should, but there is no room: no shadows before them
  bool TranslucentFragments = false; // there are, and they have
  int VolumeNodes = 2;               // on the rays through volumes

  bool AllShadersInjectable = false;
  bool AllOpaque = false;
  // Colours and distances of opaque surfaces are drawn at once. With shadows on them, the light
  // that casts them is this one, -1 if there is none: the scene is drawn with and without it.
  bool SingleGeometryPass = false;
  int ShadowingLight = -1;
  // For the step that walks the lights' ways to opaque surfaces (AirlightLightWaysPass.h): as many
  // of the lights that media dim as there is memory for; 0 where ways are short.
  int LightLayers = 0;
  bool AllLightLayers = false;
  // No light's airlight has shadows: the composite integrates it, without a step of its own.
  bool UnshadowedInComposite = false;

  DebugView View = DebugView::Shaded;
  bool Record = false;           // the shaders write what GetBuffer() gives
  bool KeepBuffers = false;      // and it is kept
  bool Annotations = true;       // drawn over the frame
  bool EncodedInput = false;     // the scene's colours are encoded for display
  bool MeasuresExposure = false; // which the display multiplies
  bool LinearFrame = false;
  double PhaseErrorBound = 0.0;
  std::uint64_t MemoryLimit = 0; // bytes
  DisplayStage Display;
};

// How pictures with these properties are shown, of clear air or not.
DisplayStage GetDisplay(const PassProperties& properties, bool clear);
bool MeasuresExposure(const PassProperties& properties);

VTKAIRLIGHT_EXPORT FramePlan MakeFramePlan(
  const PassProperties& properties, const SceneFacts& scene, const FrameLimits& limits);
}

#endif
