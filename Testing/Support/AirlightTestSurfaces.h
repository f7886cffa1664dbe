// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Closed surfaces whose inside is known otherwise: where an odd number of boxes holds a point.
 */

#ifndef AirlightTestSurfaces_h
#define AirlightTestSurfaces_h

#include "AirlightTestTools.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <array>
#include <string>
#include <vector>

namespace airlight_test
{
using Box = std::array<double, 6>; // as vtkParticipatingMedium::SetBounds()
using Mesh = vtkSmartPointer<vtkPolyData>;

struct Solid
{
  std::string Name;
  std::vector<Box> Boxes; // the first one and one that adds to it or, within it, is taken from it
  bool Taken;
  Mesh Surface;
};

Mesh MakeBoxMesh(const Box& box);

Mesh Join(const std::vector<Mesh>& meshes);

// Polygons of any number of corners.
Mesh MakeMesh(
  const std::vector<glm::dvec3>& corners, const std::vector<std::vector<vtkIdType>>& polygons);

// About z, of ring radius 1, each circle of `resolution` corners.
Mesh MakeTorus(double tube, int resolution);

// All lie within 4 of the origin and hold or surround it.
std::vector<Solid> MakeSolids();

// The length of the line within the box, as (from, to); to <= from where there is none.
glm::dvec2 ClipToBox(const Box& box, const glm::dvec3& o, const glm::dvec3& d);

// The length of the ray up to l that is inside the solid: its intervals are what an odd number of
// the boxes' intervals covers.
double LengthInside(
  const std::vector<Box>& boxes, const glm::dvec3& o, const glm::dvec3& d, double l);

// The triangles and polygons in another orientation: all of them, or a random half.
Mesh Flip(vtkPolyData* mesh, bool all, Random& random);
}

#endif
