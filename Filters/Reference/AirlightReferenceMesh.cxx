// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceMesh.h"

#include "Integration/AirlightMatrix.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace airlight
{
namespace
{
// Calls visit(size, ids, cell) for each cell; `first` is the number of the array's first cell.
template <typename Visit>
void VisitCells(vtkCellArray* cells, vtkIdType first, const Visit& visit)
{
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    visit(size, ids, first + it->GetCurrentCellId());
  }
}
}

//------------------------------------------------------------------------------
ReferenceMesh::ReferenceMesh(vtkPolyData* data, vtkMatrix4x4* toWorld)
  : Data(data)
{
  const glm::dmat4 matrix = ToGlm(toWorld);
  this->NormalToWorld = glm::transpose(glm::inverse(glm::dmat3(matrix)));
  if (!data->GetPoints())
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    glm::dvec4 p(0.0, 0.0, 0.0, 1.0);
    data->GetPoint(i, &p.x);
    p = matrix * p;
    points->SetPoint(i, p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> triangles;
  this->Triangles->SetPoints(points);
  this->Triangles->SetPolys(triangles);
  const vtkIdType before = data->GetNumberOfVerts() + data->GetNumberOfLines();
  VisitCells(data->GetPolys(), before, [&](vtkIdType size, const vtkIdType* ids, vtkIdType cell) {
    for (vtkIdType i = 2; i < size; ++i)
    {
      this->AddTriangle(ids[0], ids[i - 1], ids[i], cell);
    }
  });
  VisitCells(data->GetStrips(), before + data->GetNumberOfPolys(),
    [&](vtkIdType size, const vtkIdType* ids, vtkIdType cell) {
      for (vtkIdType i = 2; i < size; ++i)
      {
        const vtkIdType odd = i % 2;
        this->AddTriangle(ids[i - 2], ids[i - 1 + odd], ids[i - odd], cell);
      }
    });
}

//------------------------------------------------------------------------------
void ReferenceMesh::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
{
  const vtkIdType count = this->Data->GetNumberOfPoints();
  for (vtkIdType id : { a, b, c })
  {
    if (id < 0 || id >= count)
    {
      return;
    }
  }
  const vtkIdType ids[3] = { a, b, c };
  this->Triangles->GetPolys()->InsertNextCell(3, ids);
  for (vtkIdType id : ids)
  {
    this->Corners.push_back({ id, cell });
  }
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> ReferenceMesh::GetNormals(bool flat) const
{
  vtkDataArray* ofPoints = flat ? nullptr : this->Data->GetPointData()->GetNormals();
  vtkDataArray* normals = ofPoints ? ofPoints : this->Data->GetCellData()->GetNormals();
  std::vector<glm::dvec3> result;
  for (size_t i = 0; normals && i < this->Corners.size(); ++i)
  {
    const vtkIdType id = ofPoints ? this->Corners[i].Point : this->Corners[i].Cell;
    glm::dvec3 normal(0.0);
    if (id < normals->GetNumberOfTuples() && normals->GetNumberOfComponents() == 3)
    {
      normals->GetTuple(id, &normal.x);
    }
    result.push_back(this->NormalToWorld * normal);
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> ReferenceMesh::GetColours(vtkMapper* mapper) const
{
  int kind = 0; // 0: for points, 1: for cells, 2: field data, for cells or one for all
  vtkUnsignedCharArray* colours = mapper->MapScalars(this->Data, 1.0, kind);
  const vtkIdType common = kind == 2 ? mapper->GetFieldDataTupleId() : -1;
  std::vector<glm::dvec4> result;
  for (size_t i = 0; colours && i < this->Corners.size(); ++i)
  {
    const vtkIdType own = kind == 0 ? this->Corners[i].Point : this->Corners[i].Cell;
    const vtkIdType id = common >= 0 ? common : own;
    glm::dvec4 colour(0.0, 0.0, 0.0, 255.0);
    if (id < colours->GetNumberOfTuples())
    {
      for (int c = 0; c < colours->GetNumberOfComponents() && c < 4; ++c)
      {
        colour[c] = colours->GetComponent(id, c);
      }
    }
    result.push_back(colour / 255.0);
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec2> ReferenceMesh::GetTextureCoordinates() const
{
  vtkDataArray* coordinates = this->Data->GetPointData()->GetTCoords();
  std::vector<glm::dvec2> result;
  if (coordinates && coordinates->GetNumberOfComponents() >= 2)
  {
    for (const Corner& corner : this->Corners)
    {
      result.emplace_back(
        coordinates->GetComponent(corner.Point, 0), coordinates->GetComponent(corner.Point, 1));
    }
  }
  return result;
}
}
