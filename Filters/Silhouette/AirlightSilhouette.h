// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadow volumes of a mesh seen from a light: the silhouette edges that bound them, and the number
 * of volumes that hold a point. Each triangle has its own volume, whichever way it is wound.
 */

#ifndef AirlightSilhouette_h
#define AirlightSilhouette_h

#include "Silhouette/AirlightCasterMesh.h"
#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
// A light or a viewpoint: w = 1 at xyz, w = 0 at infinity in direction xyz.
using HomogeneousPoint = glm::dvec4;

// An edge from which a shadow plane of `Weight` extends away from the light: a ray that crosses
// the plane towards the left of the edge A to B, as seen from the light, enters Weight volumes.
struct SilhouetteEdge
{
  int A; // vertex indices
  int B;
  int Weight; // above 0
};

// The weight of an edge is the sum of the directions in which its triangles, each turned to face
// the light, run along it; edges of weight 0 bound nothing. Their sum is a closed chain whatever
// the mesh, so that shadow planes never leak. The edges of pairs come first, each list in the
// mesh's order.
VTKAIRLIGHT_EXPORT std::vector<SilhouetteEdge> FindSilhouette(
  const CasterMesh& mesh, const HomogeneousPoint& light);

// How each triangle is turned: 1 where the light is in front of it, -1 behind, 0 in its plane. The
// last casts nothing.
VTKAIRLIGHT_EXPORT std::vector<signed char> FindFacings(
  const CasterMesh& mesh, const HomogeneousPoint& light);

// A triangle that holds the point but for rounding, -1 where there is none. A light there has no
// defined shadows.
VTKAIRLIGHT_EXPORT int FindTriangleAt(const CasterMesh& mesh, const glm::dvec3& point);

// Number of triangles crossed by the straight way from the light to the point, that is the number
// of shadow volumes that hold the point. Consistent along shared edges.
VTKAIRLIGHT_EXPORT int CountShadowsAt(
  const CasterMesh& mesh, const HomogeneousPoint& light, const HomogeneousPoint& point);
}

#endif
