// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceVolumes.h"

#include "Integration/AirlightMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr double StepsPerPoint = 8.0;

// Keeps of [range.x, range.y] of a line what is in the volume of so many points.
glm::dvec2 Clip(
  glm::dvec2 range, const glm::dvec3& origin, const glm::dvec3& slope, const glm::ivec3& size)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = size[axis] - 1.0;
    if (slope[axis] == 0.0)
    {
      const bool inside = origin[axis] >= 0.0 && origin[axis] <= last;
      range.y = inside ? range.y : range.x;
      continue;
    }
    const double a = -origin[axis] / slope[axis];
    const double b = (last - origin[axis]) / slope[axis];
    range = { std::max(range.x, std::min(a, b)), std::min(range.y, std::max(a, b)) };
  }
  return range;
}
}

//------------------------------------------------------------------------------
void ReferenceVolumes::Add(vtkVolume* volume, vtkMatrix4x4* toWorld)
{
  std::string reason;
  const VolumeScalars scalars = FindVolumeScalars(volume, reason);
  if (!scalars.Values)
  {
    this->Errors.push_back(DescribeNoShadow(volume, reason));
    return;
  }
  VolumeOpacity opacity(volume, scalars, toWorld);
  const glm::dmat4 toPlaces = glm::inverse(opacity.GetToWorld());
  this->Volumes.push_back({ std::move(opacity), toPlaces });
}

//------------------------------------------------------------------------------
double ReferenceVolumes::GetDepth(const HomogeneousPoint& light, const glm::dvec3& point) const
{
  glm::dvec3 way(light);
  double length = AIRLIGHT_FAR;
  if (light.w != 0.0)
  {
    way -= point;
    length = glm::length(way);
    way /= std::max(length, 1e-300);
  }
  double depth = 0.0;
  for (const Volume& volume : this->Volumes)
  {
    const glm::dvec3 origin(volume.ToPlaces * glm::dvec4(point, 1.0));
    const glm::dvec3 slope = glm::dmat3(volume.ToPlaces) * way;
    const glm::dvec2 range = Clip({ 0.0, length }, origin, slope, volume.Opacity.GetSize());
    const double reach = range.y - range.x;
    if (!(reach > 0.0))
    {
      continue;
    }
    const int steps =
      1 + static_cast<int>(std::min(StepsPerPoint * reach * glm::length(slope), 1e5));
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      sum += volume.Opacity.GetExtinction(origin + (range.x + (i + 0.5) / steps * reach) * slope);
    }
    depth += sum * reach / steps;
  }
  return depth;
}
}
