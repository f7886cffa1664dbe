// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The meshes of random scenes.

#include "FrameParts.h"

#include "RandomParts.h"

#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"

namespace airlight_test
{
namespace
{
vtkSmartPointer<vtkPolyData> Copy(vtkPolyDataAlgorithm* source)
{
  source->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(source->GetOutput());
  return data;
}

// A band around the axis, of one or several strips, closed or not.
vtkSmartPointer<vtkPolyData> MakeStrips(Random& random)
{
  const int count = 4 + random.Index(12);
  vtkNew<vtkPoints> points;
  points->SetDataType(random.Index(2) ? VTK_FLOAT : VTK_DOUBLE);
  const double top = random.Uniform(0.3, 1.0);
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 6.0 * i / count;
    points->InsertNextPoint(std::cos(angle), -top, std::sin(angle));
    points->InsertNextPoint(0.7 * std::cos(angle), top, 0.7 * std::sin(angle));
  }
  vtkNew<vtkCellArray> strips;
  const int length = random.Index(2) ? 2 * (count + 1) : 4;
  for (int first = 0; first + length <= 2 * (count + 1); first += length)
  {
    strips->InsertNextCell(length);
    for (int i = 0; i < length; ++i)
    {
      strips->InsertCellPoint(first + i);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetStrips(strips);
  return data;
}

// All four kinds of cells, and points that none of them has.
vtkSmartPointer<vtkPolyData> MakeMixed(Random& random)
{
  vtkSmartPointer<vtkPolyData> data = MakeStrips(random);
  const vtkIdType count = data->GetNumberOfPoints();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  for (vtkIdType i = 0; i + 4 < count; i += 3)
  {
    const vtkIdType ids[5] = { i, i + 1, i + 2, i + 3, i + 4 };
    vertices->InsertNextCell(1, ids);
    lines->InsertNextCell(3, ids);
    polygons->InsertNextCell(3 + random.Index(3), ids); // neither flat nor convex
  }
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  return data;
}

vtkSmartPointer<vtkPolyData> MakeBody(int kind, Random& random)
{
  if (kind == FRAME_CONE)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(3 + random.Index(10));
    cone->SetHeight(random.Uniform(0.5, 2.0));
    cone->SetCapping(random.Index(2));
    return Copy(cone);
  }
  if (kind == FRAME_PLANE)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetResolution(1 + random.Index(3), 1);
    return Copy(plane);
  }
  if (kind == FRAME_GROUND)
  {
    vtkNew<vtkPlaneSource> plane;
    const double reach = random.Index(3) ? 6.0 : random.LogUniform(10.0, 1e4);
    plane->SetOrigin(-reach, -1.0, reach);
    plane->SetPoint1(reach, -1.0, reach);
    plane->SetPoint2(-reach, -1.0, -reach);
    return Copy(plane);
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(3 + random.Index(10));
  sphere->SetPhiResolution(3 + random.Index(8));
  sphere->SetEndPhi(random.Index(4) ? 180.0 : 100.0);
  return Copy(sphere);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFrameMesh(int kind, Random& random)
{
  const bool shared = random.Index(2) == 0;
  const bool single = random.Index(2) == 0;
  switch (kind)
  {
    case FRAME_STRIPS:
      return MakeStrips(random);
    case FRAME_MIXED:
      return MakeMixed(random);
    case FRAME_DEGENERATE:
      return MakeMesh(MakePart(PART_DEGENERATE, random), 1.0, shared, single);
    case FRAME_SOUP:
    {
      const int part = random.Index(PART_FLOOR);
      return MakeMesh(MakePart(part, random), 1.0, shared, single);
    }
    default:
      return MakeBody(kind, random);
  }
}
}
