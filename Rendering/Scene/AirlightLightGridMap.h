// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the points of a light's grid (AirlightLightGrid.h) are in an image.
 *
 * For the sun they are in rows along its rays. One walk through the image serves a whole row. For
 * lamps they are evenly spread.
 */

#ifndef AirlightLightGridMap_h
#define AirlightLightGridMap_h

#include "Integration/AirlightMath.h"

namespace airlight
{
// Places in an image are from 0 to 1 along each of its sides.
class LightGridMap
{
public:
  // `longest`: points along the image's longest side.
  static LightGridMap BuildEven(const DensityGrid& grid, double longest);
  // `towards`: the sun. Rows along z lead away from it.
  static LightGridMap BuildAlong(
    const DensityGrid& grid, const glm::dvec3& towards, double longest);

  // Numbers of points.
  const glm::ivec3& GetSize() const { return this->Size; }
  double CountPoints() const;

  // Points are at integers.
  glm::dvec3 ToPlace(const glm::dvec3& point) const;
  glm::dvec3 ToPoints(const glm::dvec3& place) const;
  const glm::dmat4& GetMatrix() const { return this->Matrix; }

private:
  LightGridMap(const glm::ivec3& size, const glm::dmat4& matrix);

  glm::ivec3 Size;
  glm::dmat4 Matrix; // from places to points
  glm::dmat4 Inverse;
};
}

#endif
