// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenVDB/AirlightDensityImagePlan.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace airlight
{
namespace
{
// Axes are orthogonal where the cosine of their angle is below this: over the 4096 voxels that an
// axis may have, points stay within a thousandth of a voxel.
constexpr double Orthogonal = 1e-7;
// A parallelepiped of unit edges with a smaller volume is taken for flat.
constexpr double Flat = 1e-9;

std::int64_t DivideUp(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

bool IsFinite(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

[[noreturn]] void FailTransform()
{
  throw std::runtime_error("its transform is not finite or cannot be inverted");
}

void PlanVoxels(const OpenVDBGrid& grid, DensityImagePlan& plan)
{
  std::int64_t highest[3];
  if (!grid.GetBounds(plan.Lowest, highest))
  {
    throw std::runtime_error("it has no active voxels");
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    plan.Voxels[axis] = highest[axis] - plan.Lowest[axis] + 1;
  }
}

// False where one of the blocks' numbers is above the limit.
bool PlanBlocks(std::int64_t factor, int maximum, DensityImagePlan& plan)
{
  plan.Factor = factor;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::int64_t blocks = DivideUp(plan.Voxels[axis], factor) + 2;
    if (blocks > maximum)
    {
      return false;
    }
    plan.Blocks[axis] = static_cast<int>(blocks);
  }
  return true;
}

std::int64_t LeastFactor(std::int64_t voxels, int maximum) { return DivideUp(voxels, maximum - 2); }

//------------------------------------------------------------------------------
// One point per block, where the three steps are at right angles.
bool PlanAligned(const OpenVDBGrid& grid, int maximum, DensityImagePlan& plan)
{
  double steps[3][3];
  double origin[3];
  if (!grid.GetLinearTransform(steps, origin))
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    plan.Spacing[axis] = vtkMath::Normalize(steps[axis]);
    if (!IsFinite(steps[axis]) || !IsFinite(origin) ||
      !(plan.Spacing[axis] >= std::numeric_limits<double>::min()))
    {
      FailTransform();
    }
  }
  if (!(std::abs(vtkMath::Determinant3x3(steps)) > Flat))
  {
    FailTransform();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(vtkMath::Dot(steps[axis], steps[(axis + 1) % 3])) > Orthogonal)
    {
      return false;
    }
  }
  PlanBlocks(LeastFactor(*std::max_element(plan.Voxels, plan.Voxels + 3), maximum), maximum, plan);
  std::copy_n(plan.Blocks, 3, plan.Dimensions);
  for (int row = 0; row < 3; ++row)
  {
    plan.Origin[row] = origin[row];
    for (int axis = 0; axis < 3; ++axis)
    {
      plan.Origin[row] += BlockCentre(plan, axis, 0.0) * plan.Spacing[axis] * steps[axis][row];
      plan.Direction[3 * row + axis] = steps[axis][row];
    }
  }
  for (double& spacing : plan.Spacing)
  {
    spacing *= static_cast<double>(plan.Factor);
  }
  plan.Resampled = false;
  return true;
}

//------------------------------------------------------------------------------
// The box of the world that the voxels fill, and the smallest step from one to the next at its
// corners, where a frustum's are the smallest and the largest.
struct WorldBox
{
  double Low[3] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, VTK_DOUBLE_MAX };
  double High[3] = { -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  double Step = VTK_DOUBLE_MAX;
};

WorldBox MeasureWorld(const OpenVDBGrid& grid, const DensityImagePlan& plan)
{
  WorldBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    double index[3];
    double here[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::int64_t voxel = ((corner >> axis) & 1) != 0 ? plan.Voxels[axis] - 1 : 0;
      index[axis] = static_cast<double>(plan.Lowest[axis] + voxel);
    }
    grid.IndexToWorld(index, here);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], here[axis]);
      box.High[axis] = std::max(box.High[axis], here[axis]);
      double next[3] = { index[0], index[1], index[2] };
      double there[3];
      next[axis] += ((corner >> axis) & 1) != 0 ? -1.0 : 1.0; // inwards
      grid.IndexToWorld(next, there);
      box.Step = std::min(box.Step, std::sqrt(vtkMath::Distance2BetweenPoints(here, there)));
      if (!IsFinite(here) || !IsFinite(there))
      {
        FailTransform();
      }
    }
  }
  return box;
}

void PlanResampled(const OpenVDBGrid& grid, int maximum, DensityImagePlan& plan)
{
  const WorldBox box = MeasureWorld(grid, plan);
  std::int64_t factor = LeastFactor(*std::max_element(plan.Voxels, plan.Voxels + 3), maximum);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double points = (box.High[axis] - box.Low[axis]) / box.Step;
    if (!(box.Step > 0.0 && points < 1e15))
    {
      FailTransform();
    }
    factor = std::max(
      factor, static_cast<std::int64_t>(std::ceil(points / static_cast<double>(maximum - 4))));
  }
  PlanBlocks(factor, maximum, plan);
  const double spacing = box.Step * static_cast<double>(factor);
  constexpr double identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  std::copy_n(identity, 9, plan.Direction);
  for (int axis = 0; axis < 3; ++axis)
  {
    // One more point on either side holds the background.
    const double points = std::ceil((box.High[axis] - box.Low[axis]) / spacing) + 3.0;
    plan.Dimensions[axis] = static_cast<int>(points);
    plan.Spacing[axis] = spacing;
    plan.Origin[axis] = 0.5 * (box.Low[axis] + box.High[axis]) - 0.5 * (points - 1.0) * spacing;
  }
  plan.Resampled = true;
}
}

//------------------------------------------------------------------------------
DensityImagePlan PlanDensityImage(const OpenVDBGrid& grid, int maximum)
{
  DensityImagePlan plan{};
  PlanVoxels(grid, plan);
  if (!PlanAligned(grid, maximum, plan))
  {
    PlanResampled(grid, maximum, plan);
  }
  return plan;
}
}
