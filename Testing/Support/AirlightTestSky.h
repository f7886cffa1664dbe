// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Skies, and what a phase function scatters of them into a ray by quadrature over all directions.
 * Nothing here calls the library.
 */

#ifndef AirlightTestSky_h
#define AirlightTestSky_h

#include "AirlightTestQuadrature.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace airlight_test
{
// Radiance by direction.
struct SkyRadiance
{
  glm::dvec3 Above{ 0.0 };
  glm::dvec3 Below{ 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  std::array<double, 27> Harmonics{};

  glm::dvec3 GetRadiance(const glm::dvec3& w) const
  {
    const double first = std::sqrt(3.0 / (4.0 * Pi));
    const double second = std::sqrt(15.0 / (4.0 * Pi));
    const double basis[9] = { std::sqrt(1.0 / (4.0 * Pi)), first * w.y, first * w.z, first * w.x,
      second * w.x * w.y, second * w.y * w.z,
      std::sqrt(5.0 / (16.0 * Pi)) * (3.0 * w.z * w.z - 1.0), second * w.x * w.z,
      0.5 * second * (w.x * w.x - w.y * w.y) };
    glm::dvec3 sum = glm::dot(w, this->Up) > 0.0 ? this->Above : this->Below;
    for (int i = 0; i < 27; ++i)
    {
      sum[i % 3] += basis[i / 3] * this->Harmonics[i];
    }
    return sum;
  }
};

// Gauss and Legendre's nodes and weights on the panels between sorted ends, none of them wider than
// `widest`.
inline std::vector<glm::dvec2> MakeNodes(std::vector<long double> ends, double widest)
{
  static const GaussRule rule = MakeGaussRule();
  const std::vector<long double> given = ends;
  for (size_t i = 1; i < given.size(); ++i)
  {
    const long double width = given[i] - given[i - 1];
    const int parts = static_cast<int>(width / widest) + 1;
    for (int part = 1; part < parts; ++part)
    {
      ends.push_back(given[i - 1] + part * width / parts);
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<glm::dvec2> nodes;
  for (size_t i = 1; i < ends.size(); ++i)
  {
    const double middle = static_cast<double>(0.5L * (ends[i] + ends[i - 1]));
    const double half = static_cast<double>(0.5L * (ends[i] - ends[i - 1]));
    for (int k = 0; k < GaussCount && half > 0.0; ++k)
    {
      nodes.emplace_back(middle + half * rule.X[k], half * rule.W[k]);
    }
  }
  return nodes;
}

// The integral of radiance times phase(1 - cosTheta, 1 + cosTheta) over all directions, for a ray
// of unit direction d. In elevation and azimuth about the sky's axis, where the horizon is the end
// of a panel, with panels that become finer towards d. `widest`: for tables, which are smooth in
// parts.
template <typename Phase>
glm::dvec3 ScatterSky(
  const Phase& phase, const SkyRadiance& sky, const glm::dvec3& d, double widest = 4.0)
{
  const glm::dvec3 y = sky.Up;
  const glm::dvec3 side = std::abs(y.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 flat = d - glm::dot(d, y) * y;
  const glm::dvec3 x =
    glm::normalize(glm::length(flat) > 1e-6 ? flat : side - glm::dot(side, y) * y);
  const glm::dvec3 z = glm::cross(x, y);
  const double elevation = std::atan2(glm::dot(d, y), glm::length(flat));
  std::vector<long double> ends = PeakPanels(-0.5L * Pi - elevation, 0.5L * Pi - elevation, 1e-3L);
  ends.push_back(-elevation);
  std::sort(ends.begin(), ends.end());
  const std::vector<glm::dvec2> azimuths = MakeNodes(PeakPanels(-Pi, Pi, 1e-3L), widest);
  glm::dvec3 sum(0.0);
  for (const glm::dvec2& row : MakeNodes(ends, widest))
  {
    const double sine = std::sin(elevation + row.x);
    const double cosine = std::cos(elevation + row.x);
    for (const glm::dvec2& azimuth : azimuths)
    {
      const glm::dvec3 w = cosine * (std::cos(azimuth.x) * x + std::sin(azimuth.x) * z) + sine * y;
      const glm::dvec3 apart = w - d;
      const glm::dvec3 together = w + d;
      sum += row.y * azimuth.y * cosine *
        phase(0.5 * glm::dot(apart, apart), 0.5 * glm::dot(together, together)) *
        sky.GetRadiance(w);
    }
  }
  return sum;
}
}

#endif
