// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random directions, all alike.
 */

#ifndef AirlightTestDirections_h
#define AirlightTestDirections_h

#include "AirlightTestTools.h"

#include <glm/glm.hpp>

namespace airlight_test
{
inline glm::dvec3 RandomUnit(Random& random)
{
  glm::dvec3 v;
  do
  {
    v = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) };
  } while (glm::length(v) < 0.1 || glm::length(v) > 1.0);
  return glm::normalize(v);
}
}

#endif
