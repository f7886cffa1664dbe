// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The grids of all lights in one image, kept from frame to frame while light, image and region
 * rest.
 */

#ifndef AirlightLightGrids_h
#define AirlightLightGrids_h

#include "Scene/AirlightLightGrid.h"

#include <memory>
#include <vector>

namespace airlight
{
class SurfaceTree;

// What the last frames needed of one image.
class LightGrids
{
public:
  // The grid of a light; medium and light relative to `eye`. `surface`: that of the medium's
  // region, or null.
  const LightGrid& GetLight(const f64::AirlightMedium& medium,
    const std::shared_ptr<const SurfaceTree>& surface, const f64::AirlightLight& light,
    const glm::dvec3& eye, bool everywhere, double seconds);

  // Forgets what was not used in the last few frames: renderers may share a pass. True where that
  // is all.
  bool Forget();

private:
  struct Entry
  {
    std::shared_ptr<const SurfaceTree> Surface;
    f64::AirlightRegion Region; // of the world
    glm::dvec3 SigmaT;
    glm::dvec3 Position;
    bool Directional;
    bool Everywhere;
    int Age; // calls of Forget() since it was used
    LightGrid Values;
  };

  std::vector<std::unique_ptr<Entry>> Entries;
};
}

#endif
