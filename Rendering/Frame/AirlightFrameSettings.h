// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is asked of a frame of vtkAirlightPass, and what follows from the scene.
 */

#ifndef AirlightFrameSettings_h
#define AirlightFrameSettings_h

#include "Scene/AirlightLamps.h"
#include "ShadowMaps/AirlightShadowMap.h"

#include <cstdint>
#include <vector>

class vtkProp;

namespace airlight
{
// How shadows are found.
enum class ShadowMethod
{
  None,
  Planes,
  Map,  // boundaries from shadow maps
  March // shadow maps and a ray march
};

struct FrameSettings
{
  ShadowMethod Shadows = ShadowMethod::None;
  int MapResolution = 1024;
  int Steps = 64;
  bool SurfaceShadows = false;
  bool TranslucentShadows = false;   // casters dim light by their opacity
  bool SurfaceGlow = false;          // surfaces are lit by scattered light, too
  bool Translucent = false;          // translucent surfaces or volumes are drawn over the medium
  bool TranslucentFragments = false; // and their fragments have records
  bool KnowsAll = false;             // shaders that the pass adds to draw all that is opaque
  bool Once = false;                 // opaque surfaces are drawn once: steps 1 and 3 are one
  int Apart = -1;                    // then: the light whose shadows fall on them; none below 0
  bool Whole = false;                // no light's airlight has shadows: steps 2 and 4 are one
  bool Solid = false;                // each fragment of opaque surfaces hides all behind it
  std::vector<vtkProp*> Solids; // the props of which that is true and that are drawn as they are
  int VolumeNodes = 2;          // on the rays through volumes
  bool Record = false;
  bool EncodedInput = false;     // the scene's colours are encoded for display
  bool EncodedOutput = false;    // the picture is
  int DebugView = 0;             // vtkAirlightPass::DebugViewType
  double PhaseErrorBound = 0.0;  // the largest of the media, relative
  std::uint64_t MemoryLimit = 0; // bytes
  bool PlaneBudget = false;      // too many shadow boundaries are an error: IsOverBudget()
  DrawActors Draw;               // for casters that are not polygons
};

// The numbers of the lights that the medium scatters.
std::vector<int> FindScattering(const std::vector<Lamp>& lamps);

// Whether FrameSettings::Whole may be true, with the others as they are.
bool MayBeWhole(
  const FrameSettings& settings, const f64::AirlightMedia& media, const std::vector<Lamp>& lamps);
}

#endif
