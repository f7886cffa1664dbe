// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The ways of a light through a medium whose density is an image: the mean density on them.
 */

#ifndef AirlightLightWays_h
#define AirlightLightWays_h

#include "Integration/AirlightMath.h"

#include <functional>
#include <limits>

namespace airlight
{
// Medium and light are relative to the world's origin; the medium outlives this.
class LightWays
{
public:
  // Ways along the image's faces are inside it by so much, in samples.
  static constexpr double Inset = 1e-6;
  // The mean where nothing of a way is in the closed surface that the medium fills.
  static constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

  LightWays(const f64::AirlightMedium& medium, const f64::AirlightLight& light);

  // Of the way from a place in samples: the mean, and how long the way is in the medium.
  glm::dvec2 Measure(const glm::dvec3& samples) const;

  // Gives `keep` the means of the ways from `count` points, from a on the light's side to b, which
  // are in samples and on one ray from the light. Points before the medium have the density where
  // it begins; those behind it have the mean of all of the ray in it. For AreParallel() alone.
  void MeasureRay(const glm::dvec3& a, const glm::dvec3& b, int count,
    const std::function<void(int, double)>& keep) const;

  // Whether something is scattered there, in samples.
  bool Scatters(const glm::dvec3& samples) const;

  const DensityGrid& GetGrid() const { return this->Grid; }
  bool IsInSurface() const { return this->IsSurface; }
  // Those of the sun, but in closed surfaces, which rays enter and leave several times.
  bool AreParallel() const { return this->Directional && !this->IsSurface; }
  // As AirlightLight::position.
  const glm::dvec3& GetLight() const { return this->Light; }

private:
  double GetMeanAt(const glm::dvec3& point) const;
  bool Holds(const glm::dvec3& point) const;

  const f64::AirlightMedium& Medium;
  const DensityGrid& Grid;
  glm::dvec3 Light;
  bool Directional;
  bool IsSurface;
};
}

#endif
