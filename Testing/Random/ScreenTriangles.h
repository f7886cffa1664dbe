// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All triangles of a scene where a picture shows them, in double precision: slivers are far thinner
 * than any pattern of places around a pixel.
 */

#ifndef ScreenTriangles_h
#define ScreenTriangles_h

#include <glm/glm.hpp>

#include <vector>

class vtkRenderer;

namespace airlight_test
{
class ScreenTriangles
{
public:
  // Of the visible actors; the picture has width x height pixels.
  ScreenTriangles(vtkRenderer* renderer, int width, int height);

  // Two places in each triangle that comes nearer to `pixel` than `reach` and does not hold it. In pixels
  // from the picture's lower left corner.
  std::vector<glm::dvec2> FindPlaces(const glm::dvec2& pixel, double reach) const;

  // Whether a triangle ends nearer to `pixel` than `reach`.
  bool IsNearBorder(const glm::dvec2& pixel, double reach) const;

private:
  using Polygon = std::vector<glm::dvec2>; // what lies before the eye of a triangle

  std::vector<Polygon> Polygons;
};
}

#endif
