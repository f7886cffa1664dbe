// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Samples at the points of a grid as shaders read them (airlightLayer()): a texel has four
 * samples of a row along x, and the next texel begins with the last of these. So one texel has any
 * two neighbours, and all texels together a third more than the samples.
 */

#ifndef AirlightPackedSamples_h
#define AirlightPackedSamples_h

#include "Density/AirlightDensityGrid.h"

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
// Density that single precision can reckon with, and through which nothing is seen: larger ones
// become it.
constexpr double OpaqueDensity = 1e25;

// `size`: numbers of samples.
size_t CountTexels(const glm::ivec3& size);
// Into texels of four floats or, where samples are such, of whole numbers of 8 or 16 bits.
template <typename Texel>
void PackSamples(const DensitySamples& samples, const glm::ivec3& size, Texel* texels);
void PackSamples(const std::vector<double>& samples, const glm::ivec3& size, glm::vec4* texels);
}

#endif
