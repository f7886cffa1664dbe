// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/SolidMesh.h"

#include "formats/Vector3.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkIdTypeArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <cmath>

namespace airlight
{

namespace
{
// In diagonals of the box around all points.
constexpr double TubeRadius = 0.003;
constexpr double SmallestBead = 0.001, LargestBead = 0.02;

constexpr int Sides = 8;           // of a tube
constexpr vtkIdType Round = 10000; // more beads have fewer triangles

// Lines that stand still have no direction: their points are joined.
vtkSmartPointer<vtkPolyData> MakeTubes(vtkPolyData* mesh, double diagonal)
{
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(mesh->GetPoints());
  lines->SetLines(mesh->GetLines());
  lines->GetPointData()->SetScalars(mesh->GetPointData()->GetScalars());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(lines);
  clean->SetTolerance(0.0);
  clean->ConvertLinesToPointsOff();
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(clean->GetOutputPort());
  tubes->SetRadius(TubeRadius * diagonal);
  tubes->SetNumberOfSides(Sides);
  tubes->CappingOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(tubes->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

// The points of vertices; all where there is no cell.
vtkSmartPointer<vtkPolyData> GetPoints(vtkPolyData* mesh)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  if (mesh->GetNumberOfCells() == 0)
  {
    cloud->SetPoints(mesh->GetPoints());
    cloud->GetPointData()->ShallowCopy(mesh->GetPointData());
    return cloud;
  }
  vtkIdType count = 0;
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  cloud->GetPointData()->CopyAllocate(mesh->GetPointData());
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < mesh->GetNumberOfVerts(); ++i)
  {
    mesh->GetVerts()->GetCellAtId(i, cell);
    for (const vtkIdType id : *cell)
    {
      points->InsertNextPoint(mesh->GetPoint(id));
      cloud->GetPointData()->CopyData(mesh->GetPointData(), id, count++);
    }
  }
  cloud->SetPoints(points);
  return cloud;
}

// Where points have normals, their beads are shaded with these.
void TakeNormals(vtkPolyData* beads, vtkDataArray* normals)
{
  vtkDataArray* own = beads->GetPointData()->GetNormals();
  auto* origins = vtkIdTypeArray::SafeDownCast(beads->GetPointData()->GetArray("InputPointIds"));
  for (vtkIdType i = 0; i < origins->GetNumberOfTuples(); ++i)
  {
    Vector3 normal;
    normals->GetTuple(origins->GetValue(i), normal.data());
    const double length = vtkMath::Normalize(normal.data());
    if (std::isfinite(length) && length > 0.0)
    {
      own->SetTuple(i, normal.data());
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeBeads(vtkPolyData* mesh, double diagonal)
{
  const vtkSmartPointer<vtkPolyData> cloud = GetPoints(mesh);
  const vtkIdType count = cloud->GetNumberOfPoints();
  const int parts = count > Round ? 4 : 8;
  vtkNew<vtkSphereSource> bead;
  bead->SetThetaResolution(parts);
  bead->SetPhiResolution(parts / 2 + 1);
  const double apart = 1.0 / std::sqrt(static_cast<double>(std::max<vtkIdType>(count, 1)));
  bead->SetRadius(diagonal * std::clamp(0.8 * apart, SmallestBead, LargestBead));
  vtkNew<vtkGlyph3D> beads;
  beads->SetInputData(cloud);
  beads->SetSourceConnection(bead->GetOutputPort());
  beads->ScalingOff();
  beads->OrientOff();
  beads->SetColorModeToColorByScalar();
  beads->GeneratePointIdsOn();
  beads->Update();
  if (vtkDataArray* normals = cloud->GetPointData()->GetNormals())
  {
    TakeNormals(beads->GetOutput(), normals);
  }
  return beads->GetOutput();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSolid(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0)
  {
    return mesh;
  }
  const double diagonal = mesh->GetLength();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(MakeTubes(mesh, diagonal));
  both->AddInputData(MakeBeads(mesh, diagonal));
  both->Update();
  return both->GetOutput();
}

}
