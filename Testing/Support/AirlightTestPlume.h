// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A plume of smoke for the tests: a column that rises along y, widens, and breaks into billows.
 */

#ifndef AirlightTestPlume_h
#define AirlightTestPlume_h

#include "AirlightTestOpenVDB.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace airlight_test
{
// In voxels, of 0.05 each: 2.4 wide and deep, 4.8 high.
constexpr int PlumeSize[3] = { 48, 96, 48 };
constexpr double PlumeVoxel = 0.05;

inline double SmoothStep(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Smooth noise around 0, in [-0.5, 0.5), whose features are 1 wide.
inline double SmoothNoise(const std::array<double, 3>& p)
{
  std::array<std::int64_t, 3> low;
  std::array<double, 3> t;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = static_cast<std::int64_t>(std::floor(p[axis]));
    t[axis] = SmoothStep(0.0, 1.0, p[axis] - static_cast<double>(low[axis]));
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int i = corner & 1;
    const int j = (corner >> 1) & 1;
    const int k = corner >> 2;
    const double weight =
      (i ? t[0] : 1.0 - t[0]) * (j ? t[1] : 1.0 - t[1]) * (k ? t[2] : 1.0 - t[2]);
    sum += weight * (Noise(low[0] + i, low[1] + j, low[2] + k) - 1.0);
  }
  return sum;
}

// Noise of four scales, each half as wide and half as strong as the one before.
inline double Turbulence(double x, double y, double z)
{
  double sum = 0.0;
  double scale = 1.0;
  for (int octave = 0; octave < 4; ++octave)
  {
    sum += SmoothNoise({ x * scale + 17.0 * octave, y * scale, z * scale - 5.0 * octave }) / scale;
    scale *= 2.0;
  }
  return sum;
}

// Density in [0, 1] in the middle of a voxel. x and z are counted from the axis in widths of the
// whole, y from the ground in heights.
inline double Plume(double x, double y, double z)
{
  // The air's own motion drags the smoke along, the more the higher it has risen.
  const double drag = 0.04 + 0.22 * y;
  const double dx = x + drag * Turbulence(4.0 * x, 7.0 * y, 4.0 * z);
  const double dz = z + drag * Turbulence(4.0 * x + 31.0, 7.0 * y, 4.0 * z);
  const double radius = 0.07 + 0.24 * std::pow(y, 0.8);
  const double distance = std::hypot(dx, dz) / radius;
  const double billows = Turbulence(9.0 * dx, 13.0 * y, 9.0 * dz);
  const double edge = SmoothStep(1.15, 0.35, distance + 1.1 * billows);
  const double top = SmoothStep(0.95, 0.7, y + 0.12 * billows + 0.5 * std::hypot(x, z) * y);
  return edge * top * (0.08 + 0.92 * std::exp(-2.5 * y));
}
}

#endif
