// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomGroup.h"

#include "AirlightTestTools.h"

#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <array>

namespace airlight_test
{
//------------------------------------------------------------------------------
const char* GetLightName(int kind)
{
  static const char* const names[] = { "point", "spot", "soft spot", "attenuated", "sun",
    "headlight", "headlamp", "camera light", "camera sun" };
  return names[kind];
}

//------------------------------------------------------------------------------
namespace
{
// One of the values, each once in as many groups as there are, in an order that changes.
template <typename T, size_t N>
T TakeInTurn(const std::array<T, N>& values, std::uint64_t group, std::uint64_t salt)
{
  std::array<T, N> deck = values;
  Random random(Mix(salt, group / N));
  for (size_t i = N - 1; i > 0; --i)
  {
    std::swap(deck[i], deck[static_cast<size_t>(random.Index(static_cast<int>(i) + 1))]);
  }
  return deck[group % N];
}

using Medium = vtkParticipatingMedium;

const std::array<int, 8> Phases = { Medium::ISOTROPIC, Medium::HENYEY_GREENSTEIN, Medium::RAYLEIGH,
  Medium::SCHLICK, Medium::CORNETTE_SHANKS, Medium::MIE_HAZY, Medium::MIE_MURKY,
  Medium::TABULATED };
const std::array<int, 6> RegionKinds = { Medium::UNBOUNDED, Medium::UNBOUNDED, Medium::BOX,
  Medium::BOX, Medium::SPHERE, Medium::SURFACE };
const std::array<int, 8> Densities = { Medium::UNIFORM, Medium::UNIFORM, Medium::UNIFORM,
  Medium::UNIFORM, Medium::UNIFORM, Medium::EXPONENTIAL_HEIGHT, Medium::EXPONENTIAL_HEIGHT,
  Medium::IMAGE };
const std::array<double, 6> Anisotropies = { 0.3, 0.6, 0.76, 0.85, 0.9, 0.95 };
const std::array<int, 12> FirstLights = { LIGHT_POINT, LIGHT_POINT, LIGHT_POINT, LIGHT_SPOT,
  LIGHT_SOFT_SPOT, LIGHT_ATTENUATED, LIGHT_SUN, LIGHT_SUN, LIGHT_HEADLIGHT, LIGHT_HEADLAMP,
  LIGHT_CAMERA, LIGHT_CAMERA_SUN };
const std::array<int, 6> Counts = { 1, 1, 1, 1, 1, 2 };

const char* GetPhaseName(int phase)
{
  static const char* const names[] = { "isotropic", "Henyey-Greenstein", "Rayleigh", "Schlick",
    "Cornette-Shanks", "hazy", "murky", "table" };
  return names[phase];
}

const char* GetRegionName(int region)
{
  static const char* const names[] = { "everywhere", "box", "sphere", "surface" };
  return names[region];
}
}

//------------------------------------------------------------------------------
RandomGroup::RandomGroup(std::uint64_t number)
  : Number(number)
  , Phase(TakeInTurn(Phases, number, 1))
  , Anisotropy(TakeInTurn(Anisotropies, number, 2))
  , Density(TakeInTurn(Densities, number, 3))
  , Grey(TakeInTurn(std::array<int, 4>{ 0, 0, 0, 1 }, number, 4) == 1)
  , Parallel(TakeInTurn(std::array<int, 3>{ 0, 0, 1 }, number, 5) == 1)
{
  Random random(Mix(7, number));
  this->Regions.push_back(TakeInTurn(RegionKinds, number, 8));
  this->Lights.push_back(TakeInTurn(FirstLights, number, 9));
  // Images are alone, and in no surface.
  const bool image = this->Density == Medium::IMAGE;
  if (image && this->Regions[0] == Medium::SURFACE)
  {
    this->Regions[0] = Medium::UNBOUNDED;
  }
  const int media = image ? 1 : TakeInTurn(Counts, number, 10);
  while (static_cast<int>(this->Regions.size()) < media)
  {
    this->Regions.push_back(random.Index(3)); // surfaces take compilers long
  }
  const int lights = TakeInTurn(Counts, number, 11);
  while (static_cast<int>(this->Lights.size()) < lights)
  {
    this->Lights.push_back(random.Index(LIGHT_KINDS));
  }
}

//------------------------------------------------------------------------------
std::string RandomGroup::Describe() const
{
  static const char* const densities[] = { "uniform", "height", "image" };
  std::string text = airlight_test::Text("group ", this->Number, ": ", GetPhaseName(this->Phase),
    " ", this->Anisotropy, ", ", densities[this->Density], this->Grey ? ", grey" : ", coloured",
    this->Parallel ? ", parallel" : ", perspective");
  for (int region : this->Regions)
  {
    text += std::string(", ") + GetRegionName(region);
  }
  for (int light : this->Lights)
  {
    text += std::string(", ") + GetLightName(light);
  }
  return text;
}
}
