// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of OpenVDB for the tests, and what is in them. The source file is the only one of the tests
 * that includes OpenVDB.
 */

#ifndef AirlightTestOpenVDB_h
#define AirlightTestOpenVDB_h

#include <cmath>
#include <cstdint>
#include <string>

namespace airlight_test
{
// Noise in [0.5, 1.5) without a pattern, exact in half precision: multiples of 1/1024.
inline double Noise(std::int64_t i, std::int64_t j, std::int64_t k)
{
  std::uint64_t hash = static_cast<std::uint64_t>(i * 73856093 ^ j * 19349663 ^ k * 83492791);
  hash = (hash ^ (hash >> 13)) * 0x9E3779B97F4A7C15u;
  return 0.5 + static_cast<double>(hash >> 54) / 1024.0;
}

// The voxels of noise.vdb, from the first to the last.
constexpr int NoiseLow[3] = { -7, 3, -2 };
constexpr int NoiseHigh[3] = { 12, 18, 9 };

// A smooth cloud around a point of the world.
inline double Cloud(const double world[3], const double centre[3], double width)
{
  double r2 = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    r2 += (world[axis] - centre[axis]) * (world[axis] - centre[axis]);
  }
  return std::exp(-r2 / (2.0 * width * width));
}
constexpr double CloudCentre[3] = { 0.4, -0.3, 6.0 };
constexpr double CloudWidth = 0.8;

// Writes into the folder, which ends with a slash:
//   noise.vdb      "noise" (float), voxels of 0.25
//   half.vdb       the same in half precision
//   stream.vdb     "first" (double: i + 100 j), "noise": without offsets
//   types.vdb      "velocity" (vec3s), "points" (ptdataidx32), "fog": a fog sphere of radius 1.5
//                  around (1, 2, 3), voxels of 0.1
//   levelset.vdb   "ball": a level set sphere of radius 2 around (0.3, 0, 0), voxels of 0.1, band 0.3
//   rotated.vdb    "red" and "green": single voxels of scaled, rotated and moved grids, see the source
//   mirrored.vdb   "mirrored": voxels (1, 2, 3) = 5 and (4, 2, 3) = 7, at (-0.5 i, k, j)
//   sheared.vdb    "cloud": Cloud() where x is 0.1 (i + 0.5 j), the others are 0.1 j and 0.1 k
//   frustum.vdb    "cloud": Cloud() in a frustum that opens towards +z
//   background.vdb "haze": voxels (0, 0, 0) = 1 and (3, 0, 0) = 2 of background 0.25
//   tiles.vdb      "tiles": 2 in (0, 0, 0)...(63, 31, 15), 1 in (64, 0, 0)
//   sparse.vdb     "specks": -2e9 = 3 and 2e9 = 5 on the diagonal, and 7 from 2e9 - 7 to 2e9 in x
//   names.vdb      "twin" = 1, "twin" = 2, "" = 3, "shared": the voxels of the first, elsewhere
//   nan.vdb        "bad": 1, not a number, infinite, 4 from (0, 0, 0) in x
//   empty.vdb      "nothing" (float): without active voxels
//   nogrids.vdb    no grids
//   vectors.vdb    "velocity" (vec3s)
//   onlypoints.vdb "points" (ptdataidx32)
//   plume.vdb      "density": smoke that rises along y, see AirlightTestPlume.h
void WriteOpenVDBFiles(const std::string& folder);
}

#endif
