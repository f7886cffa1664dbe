// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Medium/AirlightConvertSky.h"

#include "Medium/AirlightMediumSky.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
SkyHarmonics GetAllHarmonics(vtkParticipatingMedium* medium, const SkyHarmonics* environment)
{
  double own[27];
  medium->GetSkyHarmonics(own);
  SkyHarmonics sum{};
  for (int i = 0; i < 27; ++i)
  {
    sum[i / 3][i % 3] = own[i] + (environment ? (*environment)[i / 3][i % 3] : 0.0);
  }
  return sum;
}

// A sky that is the same in all directions is ambient light, and no sky.
bool DependsOnDirection(const SkyHarmonics& harmonics)
{
  return std::any_of(harmonics.begin() + 1, harmonics.end(),
    [](const glm::dvec3& harmonic) { return harmonic != glm::dvec3(0.0); });
}

void ConvertHarmonics(
  const SkyHarmonics& harmonics, const MediumSky& scattering, f64::AirlightSky& sky)
{
  const auto scattered = [&](int i) {
    return harmonics[i] * (HarmonicNorms[i] * scattering.GetMoment(i < 4 ? 1 : 2));
  };
  sky.linear[0] = scattered(3);
  sky.linear[1] = scattered(1);
  sky.linear[2] = scattered(2);
  sky.quadratic[0] = scattered(4);
  sky.quadratic[1] = scattered(5);
  sky.quadratic[2] = scattered(7);
  sky.quadratic[3] = scattered(8);
  sky.quadratic[4] = scattered(6);
}

void ConvertHemisphere(const HemisphereFit& fit, f64::AirlightSky& sky)
{
  sky.angle = glm::dvec2(1.0 / fit.Width, 1.0 / std::atan(1.0 / fit.Width));
  for (int k = 0; k < 12; ++k)
  {
    sky.odd[k / 4][k % 4] = fit.Odd[k];
  }
}
}

//------------------------------------------------------------------------------
void ConvertAmbient(
  vtkParticipatingMedium* medium, const SkyHarmonics* environment, f64::AirlightMedium& result)
{
  glm::dvec3 above;
  glm::dvec3 below;
  medium->GetAmbientRadiance(&result.ambient.x);
  medium->GetSkyRadiance(&above.x);
  medium->GetGroundRadiance(&below.x);
  const SkyHarmonics harmonics = GetAllHarmonics(medium, environment);
  result.ambient += 0.5 * (above + below) + HarmonicNorms[0] * harmonics[0];
  const bool byDirection = DependsOnDirection(harmonics);
  if (above == below && !byDirection)
  {
    result.ambient = glm::max(result.ambient, glm::dvec3(0.0));
    return;
  }
  f64::AirlightSky& sky = result.sky;
  sky.on = 1;
  sky.contrast = 0.5 * (above - below);
  medium->GetUp(&sky.up.x);
  const MediumSky& scattering = medium->UpdateSky(above != below);
  if (above != below)
  {
    ConvertHemisphere(scattering.GetHemisphere(), sky);
  }
  if (byDirection)
  {
    ConvertHarmonics(harmonics, scattering, sky);
  }
}
}
