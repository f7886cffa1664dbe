// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangle strips of fewer than three points, which have no triangles: they change nothing.

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"
#include "Occlusion/AirlightOccluders.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSilhouetteEdgesFilter.h"

#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
// A tetrahedron as one strip, behind strips of so many points each.
vtkSmartPointer<vtkPolyData> MakeTetrahedron(const std::vector<int>& shortStrips)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  constexpr vtkIdType ids[] = { 0, 1, 2, 3, 0, 1 };
  vtkNew<vtkCellArray> strips;
  for (int size : shortStrips)
  {
    strips->InsertNextCell(size, ids);
  }
  strips->InsertNextCell(6, ids);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetStrips(strips);
  return mesh;
}

void TestOccluder(vtkPolyData* mesh, long long cell)
{
  airlight::Occluders occluders;
  occluders.Add(mesh, nullptr, 0);
  occluders.Build();
  airlight::Occluders::Hit hit{};
  Check(occluders.FirstHit({ 0.2, 0.2, -1.0 }, { 0.0, 0.0, 1.0 }, 0.0, 10.0, hit), "the ray hits");
  Check(std::abs(hit.T - 1.0) < 1e-12, Text("at distance ", hit.T));
  Check(occluders.GetTriangles()[hit.Triangle].Cell == cell, "the cell is the long strip");
}

// Seen from far along z, the silhouette is the triangle's outline: three edges.
void TestSilhouette(vtkPolyData* mesh)
{
  vtkNew<vtkSilhouetteEdgesFilter> filter;
  filter->SetInputData(mesh);
  filter->SetLightPosition(0.1, 0.1, 100.0);
  filter->Update();
  Check(filter->GetOutput()->GetNumberOfLines() == 3,
    Text("silhouette of ", filter->GetOutput()->GetNumberOfLines(), " edges"));
}

void TestSurface(vtkPolyData* mesh)
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetSurface(mesh);
  Check(medium->GetSurface() == mesh, "the tetrahedron is a closed surface");
}
}

//------------------------------------------------------------------------------
int TestTriangleStrips(int, char*[])
{
  for (const std::vector<int>& sizes :
    { std::vector<int>{}, std::vector<int>{ 0 }, std::vector<int>{ 2, 0, 1 } })
  {
    const auto mesh = MakeTetrahedron(sizes);
    TestOccluder(mesh, static_cast<long long>(sizes.size()));
    TestSilhouette(mesh);
    TestSurface(mesh);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
