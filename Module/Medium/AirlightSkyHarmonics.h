// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Radiance by direction in real spherical harmonics to order 2, as of Ramamoorthi and Hanrahan, An
 * Efficient Representation for Irradiance Environment Maps, 2001: orthonormal, of a unit vector (x,
 * y, z) in the order 1, y, z, x, xy, yz, 3 z^2 - 1, xz, x^2 - y^2. Not installed.
 */

#ifndef AirlightSkyHarmonics_h
#define AirlightSkyHarmonics_h

#include <glm/glm.hpp>

#include <array>

namespace airlight
{
using SkyHarmonics = std::array<glm::dvec3, 9>; // red, green and blue of each

// What each is multiplied by to be orthonormal.
constexpr double HarmonicNorms[9] = { 0.28209479177387814, 0.48860251190291992, 0.48860251190291992,
  0.48860251190291992, 1.0925484305920792, 1.0925484305920792, 0.31539156525252005,
  1.0925484305920792, 0.54627421529603959 };

inline std::array<double, 9> GetHarmonics(const glm::dvec3& w)
{
  const double polynomials[9] = { 1.0, w.y, w.z, w.x, w.x * w.y, w.y * w.z, 3.0 * w.z * w.z - 1.0,
    w.x * w.z, w.x * w.x - w.y * w.y };
  std::array<double, 9> values;
  for (int i = 0; i < 9; ++i)
  {
    values[i] = HarmonicNorms[i] * polynomials[i];
  }
  return values;
}
}

#endif
