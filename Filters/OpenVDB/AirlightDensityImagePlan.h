// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The regular image that a sparse grid becomes: where its points lie.
 *
 * A block of factor^3 voxels becomes one point with their mean, so that the sum over all points is
 * the sum over all voxels divided by factor^3, and optical depths stay. One more block on every
 * side holds the background: linear interpolation then falls to it where the grid ends, and the
 * trapezoidal integral through the image is the sum of the voxels times their size.
 */

#ifndef AirlightDensityImagePlan_h
#define AirlightDensityImagePlan_h

#include "OpenVDB/AirlightOpenVDBFile.h"

#include <cstdint>

namespace airlight
{
struct DensityImagePlan
{
  std::int64_t Lowest[3]; // index of the first active voxel
  std::int64_t Voxels[3]; // number of voxels from the first active one to the last
  std::int64_t Factor;    // voxels per block and axis
  int Blocks[3];          // those around included
  bool Resampled;         // no point per block, but a grid of points along the axes of the world
  int Dimensions[3];
  double Origin[3];
  double Spacing[3];
  double Direction[9]; // as vtkMatrix3x3: rows of columns, which are the axes
};

// Index coordinates of a block's middle; block 0 is the one before the first voxel.
inline double BlockCentre(const DensityImagePlan& plan, int axis, double block)
{
  const auto factor = static_cast<double>(plan.Factor);
  return static_cast<double>(plan.Lowest[axis]) + (block - 1.0) * factor + 0.5 * (factor - 1.0);
}

// The image of at most `maximum` points in each direction. Throws std::runtime_error where the grid
// holds no active voxel, or its transform cannot be inverted.
DensityImagePlan PlanDensityImage(const OpenVDBGrid& grid, int maximum);
}

#endif
