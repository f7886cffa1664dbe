// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightCasterBox.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// The upper one of two in the middle.
double GetMedian(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The box around a caster, along the world's axes.
struct Box
{
  explicit Box(const Caster& caster)
  {
    const std::array<glm::dvec3, 8> corners = GetCorners(caster);
    this->Low = this->High = corners[0];
    for (const glm::dvec3& corner : corners)
    {
      this->Low = glm::min(this->Low, corner);
      this->High = glm::max(this->High, corner);
    }
  }

  glm::dvec3 GetMiddle() const { return 0.5 * (this->Low + this->High); }
  double GetExtent() const
  {
    const glm::dvec3 size = this->High - this->Low;
    return std::max({ size.x, size.y, size.z });
  }

  glm::dvec3 Low{ 0.0 };
  glm::dvec3 High{ 0.0 };
};
}

//------------------------------------------------------------------------------
std::array<glm::dvec3, 8> GetCorners(const Caster& caster)
{
  const glm::dvec3& low = caster.Mesh->BoundsMin;
  const glm::dvec3& high = caster.Mesh->BoundsMax;
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 local(
      i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z, 1.0);
    corners[i] = glm::dvec3(caster.ToWorld * local);
  }
  return corners;
}

//------------------------------------------------------------------------------
glm::dvec3 FindAnchor(const std::vector<Caster>& casters)
{
  std::vector<Box> boxes;
  std::vector<double> coordinates[3];
  for (const Caster& caster : casters)
  {
    const Box box(caster);
    const glm::dvec3 middle = box.GetMiddle();
    if (std::isfinite(middle.x + middle.y + middle.z) && std::isfinite(box.GetExtent()))
    {
      boxes.push_back(box);
      for (int axis = 0; axis < 3; ++axis)
      {
        coordinates[axis].push_back(middle[axis]);
      }
    }
  }
  if (boxes.empty())
  {
    return glm::dvec3(0.0);
  }
  const glm::dvec3 anchor(
    GetMedian(coordinates[0]), GetMedian(coordinates[1]), GetMedian(coordinates[2]));
  std::vector<double> reaches;
  reaches.reserve(boxes.size());
  for (const Box& box : boxes)
  {
    reaches.push_back(box.GetExtent() + glm::distance(box.GetMiddle(), anchor));
  }
  const double cell = std::exp2(std::ceil(std::log2(GetMedian(reaches))) - 3.0);
  return cell > 0.0 ? cell * glm::round(anchor / cell) : anchor;
}
}
