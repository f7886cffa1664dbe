// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Mood.h"

#include "formats/UserError.h"

#include <vtkMath.h>
#include <vtkParticipatingMedium.h>

#include <algorithm>
#include <array>

namespace airlight
{

namespace
{
constexpr Vector3 White{ 1.0, 1.0, 1.0 };
constexpr Vector3 Warm{ 1.0, 0.86, 0.68 };
constexpr Vector3 Sky{ 0.75, 0.87, 1.0 };

// Chosen by looking at pictures of many models.
constexpr std::array<Mood, 6> Moods = { {
  { "haze", 45.0, 0.6, White, White, { 0.02, 0.028, 0.04 }, { 1.0, 0.92, 0.8 }, 2.5, Sky, 0.8,
    0.8 },
  { "mist", 20.0, 0.5, White, White, { 0.012, 0.018, 0.03 }, Warm, 3.5, Sky, 0.8, 1.0 },
  { "fog", 10.0, 0.4, White, White, { 0.14, 0.147, 0.157 }, { 1.0, 0.95, 0.88 }, 4.0,
    { 0.92, 0.97, 1.0 }, 2.5, 1.2 },
  { "smoke", 9.0, 0.3, { 0.7, 0.62, 0.55 }, { 0.9, 1.0, 1.1 }, { 0.012, 0.01, 0.008 },
    { 1.0, 0.75, 0.48 }, 5.0, { 0.9, 0.92, 1.0 }, 1.0, 0.9 },
  { "night", 25.0, 0.6, White, White, { 0.001, 0.0025, 0.007 }, { 0.5, 0.7, 1.0 }, 3.0,
    { 0.8, 0.88, 1.0 }, 0.25, 0.35 },
  { "underwater", 9.0, 0.7, { 0.3, 0.75, 0.8 }, { 2.0, 1.0, 0.8 }, { 0.004, 0.03, 0.045 },
    { 0.9, 1.0, 0.95 }, 5.0, { 0.7, 0.95, 1.0 }, 1.2, 0.9 },
} };
}

//------------------------------------------------------------------------------
const Mood& GetMood(const std::string& name)
{
  const auto* found = std::find_if(
    Moods.begin(), Moods.end(), [&name](const Mood& mood) { return mood.Name == name; });
  if (found == Moods.end())
  {
    throw UserError("unknown mood '" + name + "': expected " + ListNames(GetMoodNames()));
  }
  return *found;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetMoodNames()
{
  std::vector<std::string> names;
  names.reserve(Moods.size());
  for (const Mood& mood : Moods)
  {
    names.emplace_back(mood.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
void SetMood(vtkParticipatingMedium* medium, const Mood& mood, double diagonal, double ambient)
{
  Vector3 scattering;
  Vector3 absorption;
  for (std::size_t i = 0; i < 3; ++i)
  {
    scattering[i] = mood.Albedo[i] * mood.Extinction[i];
    absorption[i] = mood.Extinction[i] - scattering[i];
  }
  medium->SetScattering(scattering.data());
  medium->SetAbsorption(absorption.data());
  medium->SetVisibility(mood.Visibility * diagonal);
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(mood.Anisotropy);
  Vector3 radiance = mood.Ambient;
  vtkMath::MultiplyScalar(radiance.data(), ambient);
  medium->SetAmbientRadiance(radiance.data());
}

}
