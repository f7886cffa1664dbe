// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points that are even in five dimensions at once: a place in the pixel and a point of a lamp for
 * each frame of a mean. Sobol's sequence with the direction numbers of S. Joe and F. Y. Kuo
 * (Constructing Sobol sequences with better two-dimensional projections, 2008), scrambled as A. B.
 * Owen does (Scrambled net variance for integrals of smooth functions, 1997), by a hash in place
 * of random digits: the same numbers each time, on each machine. Means of smooth functions of 2^m
 * points are off by about N^-1.5, and of functions with edges in d dimensions by N^-(d + 1)/(2 d).
 */

#ifndef AirlightScrambledNet_h
#define AirlightScrambledNet_h

#include "vtkAirlightModule.h" // for export macro

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace airlight
{
// Of point `number`, 0 to 2^32 - 1 in place of 0 to 1. `dimension`: 0 to 4. Each `seed` has other
// points.
VTKAIRLIGHT_EXPORT std::uint32_t GetNetDigits(
  std::uint32_t number, int dimension, std::uint32_t seed);

// By how many pixels frame `number` is moved, at most half a one; the first is not.
VTKAIRLIGHT_EXPORT glm::dvec2 GetPixelOffset(int number);

// Numbers from 0 to 1 for the lamp of a light in frame `number`, which are even together with the
// offsets of the pixel. Each light has others.
VTKAIRLIGHT_EXPORT glm::dvec3 GetLampNumbers(int number, int light);
}

#endif
