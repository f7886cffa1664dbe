// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Trilinear interpolation of values on a grid, x fastest.
 */

#ifndef AirlightTrilinear_h
#define AirlightTrilinear_h

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace airlight
{
// At a place in units of the grid's steps. There are at least two values a side; beyond the grid
// its outer cells go on.
template <typename Sum = double, typename Value>
Sum InterpolateTrilinearly(
  const std::vector<Value>& values, const glm::ivec3& size, const glm::dvec3& place)
{
  const glm::ivec3 cell = glm::clamp(glm::ivec3(place), glm::ivec3(0), size - 2);
  const glm::dvec3 f = place - glm::dvec3(cell);
  Sum sum(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 far(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 share = glm::mix(1.0 - f, f, glm::bvec3(far));
    const glm::ivec3 at = cell + far;
    sum += share.x * share.y * share.z *
      Sum(values[(static_cast<std::size_t>(at.z) * size.y + at.y) * size.x + at.x]);
  }
  return sum;
}
}

#endif
