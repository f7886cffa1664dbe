// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lines for vtkLitIntervalsFilter, and what comes out.
 */

#ifndef AirlightTestLines_h
#define AirlightTestLines_h

#include "AirlightTestSoup.h"

#include "vtkCellData.h"
#include "vtkLitIntervalsFilter.h"

namespace airlight_test
{
using Polyline = std::vector<glm::dvec3>;

inline vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Polyline>& lines)
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

// The filter with what it needs, and its output's arrays.
struct Run
{
  explicit Run(const std::vector<Polyline>& lines)
  {
    this->Filter->SetInputData(MakeLines(lines));
    this->Medium->SetScattering(0.3, 0.2, 0.1);
    this->Medium->SetAbsorption(0.1, 0.0, 0.05);
    this->Filter->SetMedium(this->Medium);
  }
  double Get(const char* name, vtkIdType cell, int component = 0)
  {
    return this->Filter->GetOutput()->GetCellData()->GetArray(name)->GetComponent(cell, component);
  }
  vtkIdType Count() { return this->Filter->GetOutput()->GetNumberOfCells(); }

  vtkNew<vtkLitIntervalsFilter> Filter;
  vtkNew<vtkParticipatingMedium> Medium;
};
}

#endif
