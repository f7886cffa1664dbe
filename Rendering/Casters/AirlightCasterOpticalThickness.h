// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a layer of a caster does to the light that goes through it. n layers of opacity a let
 * (1 - a)^n through, whatever their order: their optical thickness -ln(1 - a) adds. It is kept in
 * integers, so that sums in which all layers have gone again are 0 to the last bit (as weights:
 * B. Kim, K. Kim and G. Turk, "A Shadow-Volume Algorithm for Opaque and Transparent Nonmanifold
 * Casters", Journal of Graphics Tools 13(3), 2008).
 */

#ifndef AirlightCasterOpticalThickness_h
#define AirlightCasterOpticalThickness_h

#include <glm/glm.hpp>

namespace airlight
{
// One layer, or the sum of several; as glsl/AirlightShadowCounts.glsl adds them up.
struct CasterOpticalThickness
{
  glm::ivec3 Blocks{ 0 };    // layers that let nothing of a channel through
  glm::ivec3 Thickness{ 0 }; // optical thickness of the others, in units of 2^-20

  bool operator==(const CasterOpticalThickness& other) const
  {
    return this->Blocks == other.Blocks && this->Thickness == other.Thickness;
  }
};

// Opacities from 1 - 1e-6 on block.
CasterOpticalThickness GetOpticalThickness(const glm::dvec3& opacity);

// The largest error that rounding the thickness makes in what any number of layers of this kind
// lets through: n layers are off by n u/2 exp(-n thickness), which is at most u / (2 e thickness).
double GetThicknessError(const CasterOpticalThickness& layer);
}

#endif
