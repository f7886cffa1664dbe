// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh as VTK's mappers draw it: its polygons as fans and its strips as triangles, with what they
 * interpolate between the corners.
 */

#ifndef AirlightReferenceMesh_h
#define AirlightReferenceMesh_h

#include "Occlusion/AirlightOccluders.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <glm/glm.hpp>

#include <vector>

class vtkMapper;
class vtkMatrix4x4;

namespace airlight
{
// Whether a ray meets the side from which the corners run counter-clockwise, which is the front to
// VTK's mappers, of a mirrored mesh, too.
inline bool IsSeenFromFront(const OccluderTriangle& t, const glm::dvec3& direction)
{
  return glm::dot(glm::cross(t.B - t.A, t.C - t.A), direction) < 0.0;
}

class ReferenceMesh
{
public:
  ReferenceMesh(vtkPolyData* data, vtkMatrix4x4* toWorld);

  // Where a corner of a triangle comes from.
  struct Corner
  {
    vtkIdType Point;
    vtkIdType Cell;
  };

  // Three for each triangle.
  const std::vector<Corner>& GetCorners() const { return this->Corners; }

  // The triangles alone, in the world.
  vtkPolyData* GetTriangles() const { return this->Triangles; }

  // Unit vectors of the world at the corners: the points' normals, unless the shading is flat, else
  // the cells'; none where there are neither.
  std::vector<glm::dvec3> GetNormals(bool flat) const;

  // RGBA of the mapper's scalars at the corners; none without.
  std::vector<glm::dvec4> GetColours(vtkMapper* mapper) const;

  // Texture coordinates at the corners; none without.
  std::vector<glm::dvec2> GetTextureCoordinates() const;

private:
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell);

  vtkPolyData* Data;
  glm::dmat3 NormalToWorld;
  std::vector<Corner> Corners;
  vtkNew<vtkPolyData> Triangles;
};
}

#endif
