// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What shaders are compiled for, which is the same in the 50 scenes of a group: the kinds of lights, of
 * regions, densities and phase functions, the projection. Each of these goes round all its kinds in
 * turn, in an order of its own that changes from round to round, so that a few groups have all kinds
 * and many have all pairs of them.
 */

#ifndef RandomGroup_h
#define RandomGroup_h

#include "RandomSeeds.h"

#include <cstdint>
#include <string>
#include <vector>

namespace airlight_test
{
constexpr std::uint64_t GroupSize = 50;

enum RandomLight
{
  LIGHT_POINT,
  LIGHT_SPOT,
  LIGHT_SOFT_SPOT,  // with an exponent
  LIGHT_ATTENUATED, // otherwise than by the inverse square
  LIGHT_SUN,
  LIGHT_HEADLIGHT, // directional, as VTK's first light
  LIGHT_HEADLAMP,  // a positional headlight
  LIGHT_CAMERA,    // a point light fixed to the camera
  LIGHT_CAMERA_SUN,
  LIGHT_KINDS
};

struct RandomGroup
{
  explicit RandomGroup(std::uint64_t number);

  std::uint64_t Number;
  int Phase; // vtkParticipatingMedium::PhaseFunctionType
  double Anisotropy;
  int Density;
  bool Grey;
  bool Parallel;
  std::vector<int> Regions; // one for each medium
  std::vector<int> Lights;

  std::string Describe() const;
};

const char* GetLightName(int kind);
}

#endif
