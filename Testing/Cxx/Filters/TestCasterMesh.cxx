// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes prepared for shadows from cells as VTK keeps them: 32 or 64 bits an id, triangles alone or among
// others, and from points that several cells have of their own.

#include "AirlightTestCheck.h"
#include "Silhouette/AirlightCasterMesh.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
bool Same(const airlight::CasterMesh& a, const airlight::CasterMesh& b)
{
  return a.Points == b.Points && a.Triangles == b.Triangles && a.PairEnds == b.PairEnds &&
    a.PairUses == b.PairUses && a.OtherEnds == b.OtherEnds && a.OtherUses == b.OtherUses;
}

//------------------------------------------------------------------------------
// Two triangles whose common points are given twice, with 0 once of either sign: their common edge is one.
void TestSignsOfZero()
{
  for (int i = 0; i < 64; ++i)
  {
    const double x = 0.1 + i;
    const double corners[6][3] = { { x, 0.0, 1.0 }, { 0.0, x, 2.0 }, { 5.0, 5.0, x },
      { x, -0.0, 1.0 }, { -0.0, x, 2.0 }, { -5.0, 5.0, x } };
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const double* corner : corners)
    {
      points->InsertNextPoint(corner);
    }
    vtkNew<vtkCellArray> cells;
    const vtkIdType triangles[2][3] = { { 0, 1, 2 }, { 4, 3, 5 } };
    cells->InsertNextCell(3, triangles[0]);
    cells->InsertNextCell(3, triangles[1]);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    const airlight::CasterMesh mesh(data);
    Check(mesh.Points.size() == 4 && mesh.PairEnds.size() == 1 && mesh.OtherEnds.size() == 4,
      "zeros of either sign, " + std::to_string(i));
  }
}
}

//------------------------------------------------------------------------------
int TestCasterMesh(int, char*[])
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkPolyData* data = sphere->GetOutput();
  data->GetPolys()->ConvertTo64BitStorage();
  const airlight::CasterMesh expected(data);
  Check(expected.Triangles.size() == 96 && expected.PairEnds.size() == 144,
    "8 x 8: 96 triangles, half as many edges again");

  vtkNew<vtkPolyData> narrow;
  narrow->DeepCopy(data);
  narrow->GetPolys()->ConvertTo32BitStorage();
  Check(Same(airlight::CasterMesh(narrow), expected), "32 bits an id");

  // A quad that shares no edge: two triangles, one edge between and four around.
  vtkNew<vtkPolyData> mixed;
  vtkNew<vtkPoints> points;
  points->DeepCopy(data->GetPoints());
  const vtkIdType first = points->GetNumberOfPoints();
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(5.0 + (i == 1 || i == 2), i / 2, 0.0);
  }
  mixed->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  const vtkIdType quad[4] = { first, first + 1, first + 2, first + 3 };
  cells->InsertNextCell(4, quad);
  cells->Append(data->GetPolys());
  mixed->SetPolys(cells);
  const airlight::CasterMesh both(mixed);
  Check(both.Triangles.size() == 98 && both.PairEnds.size() == 145 && both.OtherEnds.size() == 4,
    "a quad among triangles");
  TestSignsOfZero();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
