// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A triangle soup prepared for shadows: what depends on the mesh alone, built once per change of
 * the mesh and shared by all lights, actors and frames. Built by as many threads as vtkSMPTools
 * has, and the same whatever their number.
 *
 * Nothing is assumed of the mesh: it may be open, flipped, non-manifold, self-intersecting, or
 * have every vertex twice. Vertices are merged by position, and every edge keeps the list of its
 * triangles and of the directions in which they run along it.
 *
 * Not installed; exported for the module's own tests and benchmarks.
 */

#ifndef AirlightCasterMesh_h
#define AirlightCasterMesh_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkType.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

class vtkPolyData;

namespace airlight
{
class VTKAIRLIGHT_EXPORT CasterMesh
{
public:
  // Called with the progress, from 0 to 1, a few times by the thread that builds. Returning false
  // stops the work and leaves an empty mesh.
  using Progress = std::function<bool(double)>;

  // An empty mesh where the data holds no polygons. Triangles with vertices that are not finite
  // and triangles of fewer than three positions are left out: they cast nothing.
  explicit CasterMesh(vtkPolyData* data, const Progress& progress = {});

  // The two ends of an edge, the lower vertex index first.
  using EdgeEnds = std::array<int, 2>;

  // One triangle at an edge: 2 triangle + 1 where it runs from the lower end to the higher one,
  // 2 triangle otherwise.
  using EdgeUse = int;

  std::vector<glm::dvec3> Points;
  std::vector<vtkIdType> SourcePoints; // of the data: the first one at each position
  std::vector<std::array<int, 3>> Triangles;
  std::vector<glm::dvec4> Planes; // normal and offset: dot(normal, x) + offset = 0

  // Edges of two triangles, almost all of most meshes. Apart from their ends, which are needed for
  // silhouettes only, so that looking for those reads little.
  std::vector<EdgeEnds> PairEnds;
  std::vector<std::array<EdgeUse, 2>> PairUses;

  // All other edges. Edge i has the uses from FirstUse[i] to before FirstUse[i + 1].
  std::vector<EdgeEnds> OtherEnds;
  std::vector<int> FirstUse;
  std::vector<EdgeUse> OtherUses;

  glm::dvec3 BoundsMin{ 0.0 };
  glm::dvec3 BoundsMax{ 0.0 };

private:
  bool Build(vtkPolyData* data, const Progress& progress);
  bool ReadTriangles(vtkPolyData* data, const Progress& progress);
  void AddPoints(const std::vector<glm::dvec3>& positions, std::vector<vtkIdType>& vertices);
  void BuildPlanes();
};
}

#endif
