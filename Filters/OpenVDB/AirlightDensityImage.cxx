// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenVDB/AirlightDensityImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace airlight
{
namespace
{
// The difference of two such values is finite in single precision.
constexpr double Largest = 0.25 * std::numeric_limits<float>::max();

//------------------------------------------------------------------------------
// How many of the voxels from `low` to `high` are in one block.
std::int64_t CountShared(
  std::int64_t low, std::int64_t high, std::int64_t block, std::int64_t factor)
{
  return std::min(high, (block + 1) * factor - 1) - std::max(low, block * factor) + 1;
}

// Adds to the means of the blocks what a box of equal voxels gives to them.
class BlockMeans
{
public:
  BlockMeans(const DensityImagePlan& plan, double background, float* values)
    : Plan(plan)
    , Background(background)
    , Values(values)
  {
  }

  void Add(const std::int64_t lowest[3], const std::int64_t highest[3], double value)
  {
    const std::int64_t factor = this->Plan.Factor;
    std::int64_t low[3];
    std::int64_t high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = lowest[axis] - this->Plan.Lowest[axis];
      high[axis] = highest[axis] - this->Plan.Lowest[axis];
    }
    for (std::int64_t z = low[2] / factor; z <= high[2] / factor; ++z)
    {
      const double nz = this->Share(low[2], high[2], z);
      for (std::int64_t y = low[1] / factor; y <= high[1] / factor; ++y)
      {
        const double ny = nz * this->Share(low[1], high[1], y);
        float* row = this->Values + this->Row(y, z);
        for (std::int64_t x = low[0] / factor; x <= high[0] / factor; ++x)
        {
          const double share = ny * this->Share(low[0], high[0], x);
          row[x] += static_cast<float>((value - this->Background) * share);
        }
      }
    }
  }

private:
  double Share(std::int64_t low, std::int64_t high, std::int64_t block) const
  {
    return static_cast<double>(CountShared(low, high, block, this->Plan.Factor)) /
      static_cast<double>(this->Plan.Factor);
  }

  std::ptrdiff_t Row(std::int64_t y, std::int64_t z) const
  {
    return ((z + 1) * this->Plan.Blocks[1] + y + 1) * this->Plan.Blocks[0] + 1;
  }

  const DensityImagePlan& Plan;
  double Background;
  float* Values;
};

std::size_t FillBlocks(const OpenVDBGrid& grid, const DensityImagePlan& plan, float* values)
{
  const auto count = static_cast<std::size_t>(plan.Blocks[0]) *
    static_cast<std::size_t>(plan.Blocks[1]) * static_cast<std::size_t>(plan.Blocks[2]);
  std::size_t bad = 0;
  double background = grid.GetBackground();
  if (!(std::abs(background) <= Largest))
  {
    background = 0.0;
    ++bad;
  }
  std::fill_n(values, count, static_cast<float>(background));
  BlockMeans means(plan, background, values);
  grid.VisitActive(
    [&means, &bad](const std::int64_t lowest[3], const std::int64_t highest[3], double value) {
      if (std::abs(value) <= Largest) // false for NaN
      {
        means.Add(lowest, highest, value);
      }
      else
      {
        ++bad;
      }
    });
  return bad;
}

//------------------------------------------------------------------------------
// Linear interpolation between the middles of the blocks, and the background around them.
class BlockSampler
{
public:
  BlockSampler(const DensityImagePlan& plan, const float* values)
    : Plan(plan)
    , Values(values)
  {
  }

  float Sample(const double index[3]) const
  {
    int first[3];
    double fraction[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double block =
        (index[axis] - BlockCentre(this->Plan, axis, 0.0)) / static_cast<double>(this->Plan.Factor);
      const int last = this->Plan.Blocks[axis] - 1;
      if (!(block > 0.0 && block < last))
      {
        return this->Values[0]; // a corner is background
      }
      first[axis] = static_cast<int>(block);
      fraction[axis] = block - first[axis];
    }
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      int at[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const int bit = (corner >> axis) & 1;
        weight *= bit != 0 ? fraction[axis] : 1.0 - fraction[axis];
        at[axis] = first[axis] + bit;
      }
      sum += weight * this->At(at);
    }
    return static_cast<float>(sum);
  }

private:
  double At(const int block[3]) const
  {
    const std::ptrdiff_t row =
      static_cast<std::ptrdiff_t>(block[2]) * this->Plan.Blocks[1] + block[1];
    return this->Values[row * this->Plan.Blocks[0] + block[0]];
  }

  const DensityImagePlan& Plan;
  const float* Values;
};

void Resample(
  const OpenVDBGrid& grid, const DensityImagePlan& plan, const float* blocks, float* values)
{
  const BlockSampler sampler(plan, blocks);
  double world[3];
  double index[3];
  for (int z = 0; z < plan.Dimensions[2]; ++z)
  {
    world[2] = plan.Origin[2] + z * plan.Spacing[2];
    for (int y = 0; y < plan.Dimensions[1]; ++y)
    {
      world[1] = plan.Origin[1] + y * plan.Spacing[1];
      for (int x = 0; x < plan.Dimensions[0]; ++x)
      {
        world[0] = plan.Origin[0] + x * plan.Spacing[0];
        grid.WorldToIndex(world, index);
        *values++ = sampler.Sample(index);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::size_t FillDensityImage(const OpenVDBGrid& grid, const DensityImagePlan& plan, float* values)
{
  if (!plan.Resampled)
  {
    return FillBlocks(grid, plan, values);
  }
  std::vector<float> blocks(static_cast<std::size_t>(plan.Blocks[0]) *
    static_cast<std::size_t>(plan.Blocks[1]) * static_cast<std::size_t>(plan.Blocks[2]));
  const std::size_t bad = FillBlocks(grid, plan, blocks.data());
  Resample(grid, plan, blocks.data(), values);
  return bad;
}
}
