// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestLines.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Polyline>& lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Polyline& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const glm::dvec3& p : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(&p.x));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}
}
