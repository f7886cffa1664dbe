// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A triangle soup prepared for shadows: what depends on the mesh alone, built once per change of
 * the mesh and shared by all lights, actors and frames.
 *
 * Nothing is assumed of the mesh: it may be open, flipped, non-manifold, self-intersecting, or
 * have every vertex twice. Vertices are merged by position, and every edge keeps the list of its
 * triangles and of the directions in which they run along it.
 */

#ifndef AirlightCasterMesh_h
#define AirlightCasterMesh_h

#include <glm/glm.hpp>

#include <array>
#include <vector>

class vtkPolyData;

namespace airlight
{
class CasterMesh
{
public:
  // An empty mesh where the data holds no polygons. Triangles with vertices that are not finite
  // and triangles without area are left out: they cast nothing.
  explicit CasterMesh(vtkPolyData* data);

  struct Edge
  {
    int Low; // vertex indices, Low < High
    int High;
    int FirstUse; // into Uses; the last one is before the next edge's first
  };

  // One triangle at an edge: 2 triangle + 1 where it runs from Low to High, 2 triangle otherwise.
  using EdgeUse = int;

  std::vector<glm::dvec3> Points;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<glm::dvec4> Planes; // normal and offset: dot(normal, x) + offset = 0
  std::vector<Edge> Edges;
  std::vector<EdgeUse> Uses;
  glm::dvec3 BoundsMin{ 0.0 };
  glm::dvec3 BoundsMax{ 0.0 };

  int EndOfUses(size_t edge) const
  {
    return edge + 1 < this->Edges.size() ? this->Edges[edge + 1].FirstUse
                                         : static_cast<int>(this->Uses.size());
  }

private:
  void ReadTriangles(vtkPolyData* data);
  void BuildPlanes();
  void BuildEdges();
};
}

#endif
