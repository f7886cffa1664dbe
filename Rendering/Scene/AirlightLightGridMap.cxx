// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLightGridMap.h"

#include "Scene/AirlightLightWays.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// Lengths of the image's sides.
glm::dvec3 GetSides(const DensityGrid& grid)
{
  const glm::dmat3 steps = glm::inverse(grid.GetAxes());
  return grid.GetLast() *
    glm::dvec3(glm::length(steps[0]), glm::length(steps[1]), glm::length(steps[2]));
}

// Between points.
double GetSpacing(const glm::dvec3& sides, double longest)
{
  return std::max({ sides.x, sides.y, sides.z }) / (longest - 1.0);
}

// As many points as make cells about as long as wide, `spacing` apart.
glm::ivec3 CountPointsAlong(const glm::dvec3& lengths, double spacing)
{
  // Rounding adds none.
  return glm::max(glm::ivec3(glm::ceil(lengths / spacing * (1.0 - 1e-9))), 1) + 1;
}
}

//------------------------------------------------------------------------------
LightGridMap LightGridMap::BuildEven(const DensityGrid& grid, double longest)
{
  const glm::dvec3 sides = GetSides(grid);
  const glm::ivec3 size = CountPointsAlong(sides, GetSpacing(sides, longest));
  return { size, glm::scale(glm::dmat4(1.0), glm::dvec3(size - 1)) };
}

//------------------------------------------------------------------------------
LightGridMap LightGridMap::BuildAlong(
  const DensityGrid& grid, const glm::dvec3& towards, double longest)
{
  const glm::dvec3 sides = GetSides(grid);
  const glm::dvec3 way = grid.GetAxes() * towards / grid.GetLast();
  const glm::dvec3 size = glm::abs(way);
  const int along = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  // Rays are known by where they meet the face at 0 along that axis: at
  // place - slope * place[along].
  const glm::dvec3 slope = way / way[along];
  const glm::dvec3 inset = LightWays::Inset / grid.GetLast();
  const glm::dvec3 low = glm::min(-slope, 0.0) + inset;
  const glm::dvec3 widths = glm::max(1.0 - slope, 1.0) - inset - low;
  const int axes[] = { (along + 1) % 3, (along + 2) % 3 };
  const glm::ivec3 points = CountPointsAlong(
    { widths[axes[0]] * sides[axes[0]], widths[axes[1]] * sides[axes[1]], sides[along] },
    GetSpacing(sides, longest));
  glm::dmat4 rows(1.0);
  for (int i = 0; i < 2; ++i)
  {
    const double scale = (points[i] - 1.0) / widths[axes[i]];
    rows[i] = glm::dvec4(0.0, 0.0, 0.0, -low[axes[i]] * scale);
    rows[i][axes[i]] = scale;
    rows[i][along] = -slope[axes[i]] * scale;
  }
  const double away = way[along] > 0.0 ? -1.0 : 1.0;
  rows[2] = glm::dvec4(0.0, 0.0, 0.0, away > 0.0 ? 0.0 : points.z - 1.0);
  rows[2][along] = away * (points.z - 1.0);
  return { points, glm::transpose(rows) };
}

//------------------------------------------------------------------------------
LightGridMap::LightGridMap(const glm::ivec3& size, const glm::dmat4& matrix)
  : Size(size)
  , Matrix(matrix)
  , Inverse(glm::inverse(matrix))
{
}

//------------------------------------------------------------------------------
double LightGridMap::CountPoints() const
{
  const glm::dvec3 size(this->Size);
  return size.x * size.y * size.z;
}

//------------------------------------------------------------------------------
glm::dvec3 LightGridMap::ToPlace(const glm::dvec3& point) const
{
  return this->Inverse * glm::dvec4(point, 1.0);
}

//------------------------------------------------------------------------------
glm::dvec3 LightGridMap::ToPoints(const glm::dvec3& place) const
{
  return this->Matrix * glm::dvec4(place, 1.0);
}
}
