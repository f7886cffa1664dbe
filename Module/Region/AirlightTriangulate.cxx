// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Region/AirlightTriangulate.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

namespace airlight
{
namespace
{
// vtkTriangleFilter reads three points of strips that have fewer. In their place, so that cells
// keep their numbers, comes one that has no area.
vtkSmartPointer<vtkCellArray> MendStrips(vtkCellArray* strips)
{
  auto fixed = vtkSmartPointer<vtkCellArray>::New();
  const auto strip = vtk::TakeSmartPointer(strips->NewIterator());
  for (strip->GoToFirstCell(); !strip->IsDoneWithTraversal(); strip->GoToNextCell())
  {
    constexpr vtkIdType flat[3] = { 0, 0, 0 };
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    strip->GetCurrentCell(count, ids);
    fixed->InsertNextCell(count < 3 ? 3 : count, count < 3 ? flat : ids);
  }
  return fixed;
}

bool HasShortStrips(vtkPolyData* mesh)
{
  vtkCellArray* strips = mesh->GetStrips();
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    if (strips->GetCellSize(i) < 3)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* mesh, vtkDataArray* cells)
{
  vtkNew<vtkPolyData> copy; // keeps the pipeline from touching the caller's data
  if (mesh->GetNumberOfPoints() > 0)
  {
    copy->CopyStructure(mesh);
    if (HasShortStrips(mesh))
    {
      copy->SetStrips(MendStrips(mesh->GetStrips()));
    }
    if (cells)
    {
      copy->GetCellData()->AddArray(cells);
    }
  }
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(copy);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  return triangulate->GetOutput();
}
}
