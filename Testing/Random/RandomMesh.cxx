// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomParts.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMesh(
  const TriangleList& triangles, double normals, bool shared, bool single)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> directions;
  directions->SetNumberOfComponents(3);
  std::map<Position, vtkIdType> known;
  for (const auto& t : triangles)
  {
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k)
    {
      const auto found = known.find(ToPosition(t[k]));
      ids[k] = shared && found != known.end() ? found->second : points->InsertNextPoint(&t[k].x);
      known[ToPosition(t[k])] = ids[k];
    }
    cells->InsertNextCell(3, ids);
    // Of lengths that neither overflow nor vanish.
    const double size = std::max(
      { glm::length(t[1] - t[0]), glm::length(t[2] - t[0]), glm::length(t[2] - t[1]), 1e-300 });
    const glm::dvec3 normal = glm::cross((t[1] - t[0]) / size, (t[2] - t[0]) / size);
    const double length = glm::length(normal);
    const glm::dvec3 unit = length > 0.0 ? normals * normal / length : glm::dvec3(0.0, 0.0, 1.0);
    directions->InsertNextTuple(&unit.x);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetNormals(directions);
  return data;
}
}
