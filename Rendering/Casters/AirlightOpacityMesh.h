// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The opacity of an actor's mesh, from place to place: its property's, times the alpha of its
 * texture and of its scalars. Of what VTK draws as opaque, the texture's alpha alone counts.
 */

#ifndef AirlightOpacityMesh_h
#define AirlightOpacityMesh_h

#include "Scene/AirlightTextureColours.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <array>
#include <functional>

class vtkAbstractArray;
class vtkActor;
class vtkDataArray;
class vtkIdList;
class vtkMapper;

namespace airlight
{
struct OpacityCorner
{
  glm::dvec3 Position{ 0.0 };
  double Opacity = 1.0;
};

using OpacityTriangle = std::array<OpacityCorner, 3>;

// The scalars that a mapper maps to colours, and what they are for: 0: points, 1: cells, 2: others;
// null if there are none.
vtkAbstractArray* FindMappedScalars(vtkMapper* mapper, vtkPolyData* data, int& kind);

class OpacityMesh
{
public:
  OpacityMesh(vtkActor* actor, vtkPolyData* data);

  // Whether the opacity has any source but the property.
  bool Varies() const { return this->Coordinates || this->Alphas; }

  // Of a mesh under a texture, divided. Neighbours have the same points at the edge between them,
  // to the last bit.
  void VisitTriangles(const std::function<void(const OpacityTriangle&)>& visit) const;

private:
  struct Corner
  {
    vtkIdType Point = 0;
    glm::dvec3 Position{ 0.0 };
    glm::dvec2 Coordinates{ 0.0 };
    double Alpha = 1.0; // of scalars
  };

  void FindScalars(vtkMapper* mapper, vtkPolyData* data);
  int GetDivisions() const;
  Corner GetCorner(vtkIdType point, vtkIdType cell) const;
  std::array<Corner, 3> GetCorners(vtkIdList* points, vtkIdType cell) const;
  OpacityCorner Interpolate(const std::array<Corner, 3>& corners, const glm::dvec3& weights) const;

  double Opacity;
  TextureColours Texture;
  vtkNew<vtkPolyData> Triangles;
  vtkSmartPointer<vtkDataArray> Coordinates; // of the texture; null without
  vtkSmartPointer<vtkDataArray> Alphas;      // of scalars; null without
  bool AlphasOfCells = false;
};
}

#endif
