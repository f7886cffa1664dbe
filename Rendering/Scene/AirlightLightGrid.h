// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What light loses on its way through a medium whose density is an image, for the shaders.
 *
 * On a grid in the image (AirlightLightGridMap.h): the mean density of the way from each point to
 * the light, as far as it is in the medium. Unlike the optical depth, which is that times the way's
 * length, the mean is constant where the density is, and has no singularity at the light and no
 * kinks where ways begin to leave through another face; so a grid coarser than the image will do,
 * and linear interpolation.
 */

#ifndef AirlightLightGrid_h
#define AirlightLightGrid_h

#include "Scene/AirlightLightGridMap.h"

#include <memory>
#include <vector>

namespace airlight
{
struct LightGrid
{
  std::shared_ptr<const std::vector<glm::vec4>> Means; // AirlightPackedSamples.h
  glm::dvec3 Cells;
  glm::dmat4 ToCells; // of places in the image, as LightGridMap::GetMatrix()
  double Error;       // the largest of optical depths found between the points, where light is left
  bool IsFinest;

  // Of the light, for media and light relative to the world's origin. `everywhere`: also where the
  // image is empty, for the ways of light that begin in other media. A coarser one where a finer
  // one would take longer than this, in seconds.
  static LightGrid Build(const f64::AirlightMedium& medium, const f64::AirlightLight& light,
    bool everywhere, double seconds);

  // Of a light without power in the medium: shaders read it, and add nothing.
  static const LightGrid& GetDark();
};
}

#endif
