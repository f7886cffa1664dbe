// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightCasterNumbers.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleStrip.h"

#include <algorithm>
#include <iterator>

namespace airlight
{
//------------------------------------------------------------------------------
void AppendCaster(vtkActor* actor, vtkPolyData* data, CasterNumbers& mesh)
{
  if (data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    return;
  }
  const auto first = static_cast<int>(mesh.Points.size() / 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    data->GetPoint(i, point);
    actor->GetMatrix()->MultiplyPoint(point, point);
    mesh.Points.insert(mesh.Points.end(), point, point + 3);
  }
  vtkNew<vtkCellArray> polygons;
  auto cell = vtk::TakeSmartPointer(data->GetStrips()->NewIterator());
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    cell->GetCurrentCell(count, ids);
    vtkTriangleStrip::DecomposeStrip(static_cast<int>(count), ids, polygons);
  }
  for (vtkCellArray* cells : { polygons.Get(), data->GetPolys() })
  {
    cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      cell->GetCurrentCell(count, ids);
      mesh.Polygons.push_back(static_cast<int>(count));
      std::transform(ids, ids + count, std::back_inserter(mesh.Polygons),
        [first](vtkIdType id) { return first + static_cast<int>(id); });
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePolyData(
  const double* points, vtkIdType pointCount, const int* polygons, vtkIdType polygonsLength)
{
  vtkNew<vtkPoints> array;
  array->SetDataTypeToDouble();
  array->SetNumberOfPoints(pointCount);
  for (vtkIdType i = 0; i < pointCount; ++i)
  {
    array->SetPoint(i, points + 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  for (const int* place = polygons; place != polygons + polygonsLength; place += *place + 1)
  {
    cells->InsertNextCell(*place);
    std::for_each(place + 1, place + 1 + *place, [&cells](int id) { cells->InsertCellPoint(id); });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(array);
  data->SetPolys(cells);
  return data;
}
}
