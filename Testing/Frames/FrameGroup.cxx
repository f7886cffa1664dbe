// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameGroup.h"

#include "AirlightTestTools.h"

#include "vtkAirlightPass.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <array>

namespace airlight_test
{
//------------------------------------------------------------------------------
const char* GetFrameLightName(int kind)
{
  static const char* const names[] = { "point", "spot", "soft spot", "attenuated", "sun",
    "headlight", "headlamp", "camera light", "camera sun", "photometric" };
  return names[kind];
}

//------------------------------------------------------------------------------
const char* GetFramePartName(int kind)
{
  static const char* const names[] = { "sphere", "cone", "plane", "soup", "strips", "mixed",
    "degenerate", "ground", "translucent", "glass", "cell opacity", "table opacity", "assembly",
    "prop assembly", "follower", "LOD actor", "LOD prop", "glyphs", "gaussians", "lines",
    "wireframe", "points", "edges", "volume", "composite", "clipped", "culled", "backface",
    "cube axes", "axes", "text", "textured", "grid", "unlit", "image", "nothing" };
  return names[kind];
}

//------------------------------------------------------------------------------
namespace
{
// Takes each value once in as many groups as there are values, in an order that changes from round to
// round: so a few groups have all values, and many have all pairs of two settings.
template <typename Values>
auto TakeInTurn(const Values& values, std::uint64_t turn, std::uint64_t salt)
{
  Values deck = values;
  const size_t n = deck.size();
  Random random(Mix(salt, turn / n));
  for (size_t i = n - 1; i > 0; --i)
  {
    std::swap(deck[i], deck[static_cast<size_t>(random.Index(static_cast<int>(i) + 1))]);
  }
  return deck[turn % n];
}

using Medium = vtkParticipatingMedium;
using Pass = vtkAirlightPass;

const std::array<int, 8> Phases = { Medium::ISOTROPIC, Medium::HENYEY_GREENSTEIN, Medium::RAYLEIGH,
  Medium::SCHLICK, Medium::CORNETTE_SHANKS, Medium::MIE_HAZY, Medium::MIE_MURKY,
  Medium::TABULATED };
const std::array<double, 5> Anisotropies = { 0.0, 0.3, 0.6, 0.85, 0.95 };
const std::array<int, 7> Densities = { Medium::UNIFORM, Medium::UNIFORM, Medium::UNIFORM,
  Medium::EXPONENTIAL_HEIGHT, Medium::EXPONENTIAL_HEIGHT, Medium::EXPONENTIAL_HEIGHT,
  Medium::IMAGE };
const std::array<int, 8> Techniques = { Pass::NONE, Pass::SHADOW_PLANES, Pass::SHADOW_PLANES,
  Pass::SHADOW_PLANES, Pass::AUTOMATIC, Pass::AUTOMATIC, Pass::SHADOW_MAP, Pass::RAY_MARCH };
const std::array<int, 6> RegionKinds = { Medium::UNBOUNDED, Medium::UNBOUNDED, Medium::UNBOUNDED,
  Medium::BOX, Medium::SPHERE, Medium::SURFACE };
const std::array<int, 12> LightCounts = { 0, 1, 1, 1, 1, 1, 1, 2, 2, 3, 6, 35 };
const std::array<int, 6> MediumCounts = { 1, 1, 1, 1, 2, 3 };
const std::array<int, 11> FirstLights = { FRAME_POINT, FRAME_POINT, FRAME_SPOT, FRAME_SOFT_SPOT,
  FRAME_ATTENUATED, FRAME_SUN, FRAME_HEADLIGHT, FRAME_HEADLAMP, FRAME_CAMERA, FRAME_CAMERA_SUN,
  FRAME_PHOTOMETRIC };

bool OneOf(int count, std::uint64_t turn, std::uint64_t salt)
{
  std::vector<int> deck(static_cast<size_t>(count), 0);
  deck[0] = 1;
  return TakeInTurn(deck, turn, salt) == 1;
}

std::vector<int> Range(int first, int last)
{
  std::vector<int> values;
  for (int i = first; i < last; ++i)
  {
    values.push_back(i);
  }
  return values;
}
}

//------------------------------------------------------------------------------
FrameGroup::FrameGroup(std::uint64_t number)
  : Number(number)
  , Phase(TakeInTurn(Phases, number, 1))
  , Anisotropy(TakeInTurn(Anisotropies, number, 2))
  , Density(TakeInTurn(Densities, number, 3))
  , Technique(TakeInTurn(Techniques, number, 4))
  , Parallel(OneOf(4, number, 5))
  , Grey(OneOf(5, number, 6))
  , ScatteredSurfaceLight(OneOf(11, number, 7))
  , LinearInput(!OneOf(7, number, 8))
  , Peeling(OneOf(3, number, 9))
  , Fxaa(OneOf(10, number, 10))
  , Layered(OneOf(9, number, 18))
  , Recent(number >= FirstRecentFrameGroup)
{
  Random random(Mix(11, number));
  // Earlier groups know no image in a closed surface.
  const bool image = this->Density == Medium::IMAGE && !this->Recent;
  const int media = TakeInTurn(MediumCounts, number, 12);
  for (int i = 0; i < media; ++i)
  {
    const int region = TakeInTurn(RegionKinds, number + static_cast<std::uint64_t>(i), 13);
    const bool fits = region != Medium::SURFACE || (!image && i == 0);
    this->Regions.push_back(fits ? region : Medium::BOX);
  }
  const int lights = TakeInTurn(LightCounts, number, 14);
  const int first = TakeInTurn(FirstLights, number, 15);
  for (int i = 0; i < lights; ++i)
  {
    // Many lights are of one kind: each kind has lines of its own in the shaders.
    this->Lights.push_back(i == 0 || lights > 3 ? first : random.Index(FRAME_LIGHT_KINDS));
  }
  this->Parts.push_back(TakeInTurn(Range(0, FRAME_MESH_KINDS), number, 16));
  const std::vector<int> others = Range(FRAME_MESH_KINDS, FRAME_PART_KINDS);
  this->Parts.push_back(TakeInTurn(others, 2 * number, 17));
  this->Parts.push_back(TakeInTurn(others, 2 * number + 1, 17));
}

//------------------------------------------------------------------------------
std::string FrameGroup::Describe() const
{
  std::string text = airlight_test::Text("group ", this->Number, ": phase ", this->Phase, " ",
    this->Anisotropy, ", density ", this->Density, ", technique ", this->Technique,
    this->Parallel ? ", parallel" : "", this->Grey ? ", grey" : "",
    this->ScatteredSurfaceLight ? ", scattered surface light" : "",
    this->LinearInput ? "" : ", encoded", this->Peeling ? ", peeling" : "",
    this->Fxaa ? ", FXAA" : "", this->Layered ? ", layered" : "", ", regions");
  for (int region : this->Regions)
  {
    text += airlight_test::Text(" ", region);
  }
  text += airlight_test::Text("; ", this->Lights.size(), " lights");
  for (size_t i = 0; i < std::min<size_t>(this->Lights.size(), 3); ++i)
  {
    text += std::string(", ") + GetFrameLightName(this->Lights[i]);
  }
  text += "; parts";
  for (int part : this->Parts)
  {
    text += std::string(", ") + GetFramePartName(part);
  }
  return text;
}
}
