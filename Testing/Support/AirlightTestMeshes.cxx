// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestMeshes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Make(vtkPolyDataAlgorithm* source)
{
  source->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(source->GetOutput());
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSphere(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  return Make(sphere);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSoup(const std::vector<Triangle>& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : triangles)
  {
    vtkIdType ids[3];
    const glm::dvec3* corners[3] = { &t.A, &t.B, &t.C };
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = points->InsertNextPoint(corners[i]->x, corners[i]->y, corners[i]->z);
    }
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSphere(const glm::dvec3& centre, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(12);
  return Make(sphere);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePlate(const glm::dvec3& centre, double dx, double dz)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(centre.x - dx, centre.y, centre.z + dz);
  plane->SetPoint1(centre.x + dx, centre.y, centre.z + dz);
  plane->SetPoint2(centre.x - dx, centre.y, centre.z - dz);
  return Make(plane);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSheet(
  const glm::dvec3& corner, const glm::dvec3& along, const glm::dvec3& up)
{
  vtkNew<vtkPlaneSource> plane;
  const glm::dvec3 first = corner + along;
  const glm::dvec3 second = corner + up;
  plane->SetOrigin(corner.x, corner.y, corner.z);
  plane->SetPoint1(first.x, first.y, first.z);
  plane->SetPoint2(second.x, second.y, second.z);
  return Make(plane);
}

//------------------------------------------------------------------------------
glm::dvec3 TransformPoint(vtkMatrix4x4* matrix, const double p[3])
{
  const double in[4] = { p[0], p[1], p[2], 1.0 };
  glm::dvec4 out;
  matrix->MultiplyPoint(in, &out.x);
  return glm::dvec3(out);
}

//------------------------------------------------------------------------------
std::vector<Triangle> GetTriangles(vtkPolyData* data, vtkMatrix4x4* matrix)
{
  std::vector<Triangle> result;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  const auto corner = [&](int i) {
    double p[3];
    data->GetPoint(ids[i], p);
    return TransformPoint(matrix, p);
  };
  vtkCellArray* polygons = data->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids);)
  {
    for (int i = 2; i < size; ++i)
    {
      result.push_back({ corner(0), corner(i - 1), corner(i) });
    }
  }
  vtkCellArray* strips = data->GetStrips();
  for (strips->InitTraversal(); strips->GetNextCell(size, ids);)
  {
    for (int i = 2; i < size; ++i)
    {
      result.push_back({ corner(i - 2), corner(i - 1), corner(i) });
    }
  }
  return result;
}
}
