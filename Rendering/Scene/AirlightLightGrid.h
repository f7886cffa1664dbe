// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What light loses on its way through a medium whose density is an image, for the shaders.
 *
 * On a regular grid in the image: the mean density of the way from each point to the light, as far
 * as it is in the medium. Unlike the optical depth, which is that times the way's length, the mean
 * is constant where the density is, and has no singularity at the light and no kinks where ways
 * begin to leave through another face; so a grid coarser than the image will do, and linear
 * interpolation.
 */

#ifndef AirlightLightGrid_h
#define AirlightLightGrid_h

#include "Integration/AirlightMath.h"
#include "Scene/AirlightSceneData.h"

#include <memory>
#include <vector>

namespace airlight
{
struct LightGrid
{
  Texels Means; // as airlightCell() reads them
  glm::dvec3 Cells;
  double Error; // the largest of optical depths found between the points, where light is left

  // Of the light, for media and light relative to the world's origin.
  static LightGrid Build(const f64::AirlightMedium& medium, const f64::AirlightLight& light);
};

// Samples as airlightCell() reads them: 2 x 2 in x and y a texel.
Texels PackSamples(const std::vector<double>& samples, const glm::ivec3& size);

// Keeps what the last frame needed.
class LightGrids
{
public:
  // The image's samples, and the grid of a light; medium and light relative to `eye`.
  Texels GetSamples(const std::shared_ptr<const DensityGrid>& grid);
  const LightGrid& GetLight(
    const f64::AirlightMedium& medium, const f64::AirlightLight& light, const glm::dvec3& eye);

  // Forgets what was not used in the last few frames: renderers may share a pass.
  void Forget();

private:
  struct Entry
  {
    f64::AirlightRegion Region; // of the world
    glm::dvec3 SigmaT;
    glm::dvec3 Position;
    bool Directional;
    int Age; // calls of Forget() since it was used
    LightGrid Values;
  };

  std::shared_ptr<const DensityGrid> Grid;
  Texels Samples;
  std::vector<std::unique_ptr<Entry>> Entries; // of that grid
};
}

#endif
