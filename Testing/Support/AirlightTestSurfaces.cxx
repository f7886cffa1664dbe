// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestSurfaces.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>

namespace airlight_test
{
//------------------------------------------------------------------------------
Mesh MakeBoxMesh(const Box& box)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cube->SetBounds(box.data());
  cube->Update();
  return cube->GetOutput();
}

//------------------------------------------------------------------------------
Mesh Join(const std::vector<Mesh>& meshes)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const Mesh& mesh : meshes)
  {
    append->AddInputData(mesh);
  }
  append->Update();
  return append->GetOutput();
}

//------------------------------------------------------------------------------
Mesh MakeMesh(
  const std::vector<glm::dvec3>& corners, const std::vector<std::vector<vtkIdType>>& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& corner : corners)
  {
    points->InsertNextPoint(&corner.x);
  }
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  Mesh mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

//------------------------------------------------------------------------------
// An outline in x and y, from z0 to z1; its two ends are one polygon each, convex or not.
static Mesh MakePrism(const std::vector<glm::dvec2>& outline, double z0, double z1)
{
  const vtkIdType count = static_cast<vtkIdType>(outline.size());
  std::vector<glm::dvec3> corners;
  std::vector<std::vector<vtkIdType>> polygons(2);
  for (const glm::dvec2& p : outline)
  {
    corners.emplace_back(p, z0);
  }
  for (const glm::dvec2& p : outline)
  {
    corners.emplace_back(p, z1);
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType next = (i + 1) % count;
    polygons[0].push_back(i);
    polygons[1].push_back(count + i);
    polygons.push_back({ i, next, count + next, count + i });
  }
  return MakeMesh(corners, polygons);
}

//------------------------------------------------------------------------------
Mesh MakeTorus(double tube, int resolution)
{
  std::vector<glm::dvec3> corners;
  std::vector<std::vector<vtkIdType>> triangles;
  const auto corner = [&](vtkIdType i, vtkIdType j) {
    return i % resolution * resolution + j % resolution;
  };
  for (int i = 0; i < resolution; ++i)
  {
    for (int j = 0; j < resolution; ++j)
    {
      const double u = 2.0 * 3.14159265358979323846 * i / resolution;
      const double v = 2.0 * 3.14159265358979323846 * j / resolution;
      const double ring = 1.0 + tube * std::cos(v);
      corners.emplace_back(ring * std::cos(u), ring * std::sin(u), tube * std::sin(v));
      triangles.push_back({ corner(i, j), corner(i + 1, j), corner(i + 1, j + 1) });
      triangles.push_back({ corner(i, j), corner(i + 1, j + 1), corner(i, j + 1) });
    }
  }
  return MakeMesh(corners, triangles);
}

//------------------------------------------------------------------------------
std::vector<Solid> MakeSolids()
{
  const Box outer{ -2.0, 2.5, -1.5, 2.0, -2.5, 1.8 };
  const Box cavity{ -0.8, 1.1, -0.7, 0.9, -1.0, 0.6 };
  const Box notch{ -0.7, 1.0, -0.4, 2.0, -2.5, 1.8 };
  const Box corner{ 0.4, 2.5, 0.3, 2.0, -2.5, 1.8 };
  const Box left{ -2.0, -0.4, -1.5, 2.0, -2.5, 1.8 };
  const Box right{ 0.5, 2.5, -1.1, 1.7, -2.0, 1.2 };
  const Box lower{ -2.0, 2.5, -1.5, 0.1, -2.5, 1.8 };
  const Box upper{ -0.9, 1.2, 0.1, 1.6, -1.0, 1.1 };
  std::vector<Solid> solids;
  solids.push_back({ "box", { outer }, false, MakeBoxMesh(outer) });
  solids.push_back({ "box with a cavity", { outer, cavity }, true,
    Join({ MakeBoxMesh(outer), MakeBoxMesh(cavity) }) });
  solids.push_back({ "U", { outer, notch }, true,
    MakePrism({ { -2.0, -1.5 }, { 2.5, -1.5 }, { 2.5, 2.0 }, { 1.0, 2.0 }, { 1.0, -0.4 },
                { -0.7, -0.4 }, { -0.7, 2.0 }, { -2.0, 2.0 } },
      -2.5, 1.8) });
  solids.push_back({ "L", { outer, corner }, true,
    MakePrism(
      { { -2.0, -1.5 }, { 2.5, -1.5 }, { 2.5, 0.3 }, { 0.4, 0.3 }, { 0.4, 2.0 }, { -2.0, 2.0 } },
      -2.5, 1.8) });
  solids.push_back(
    { "two boxes", { left, right }, false, Join({ MakeBoxMesh(left), MakeBoxMesh(right) }) });
  solids.push_back({ "one box on another", { lower, upper }, false,
    Join({ MakeBoxMesh(lower), MakeBoxMesh(upper) }) });
  return solids;
}

//------------------------------------------------------------------------------
glm::dvec2 ClipToBox(const Box& box, const glm::dvec3& o, const glm::dvec3& d)
{
  glm::dvec2 range(-1e30, 1e30);
  for (int i = 0; i < 3; ++i)
  {
    if (d[i] == 0.0)
    {
      range = o[i] > box[2 * i] && o[i] < box[2 * i + 1] ? range : glm::dvec2(0.0);
      continue;
    }
    const double a = (box[2 * i] - o[i]) / d[i];
    const double b = (box[2 * i + 1] - o[i]) / d[i];
    range = { std::max(range.x, std::min(a, b)), std::min(range.y, std::max(a, b)) };
  }
  return range;
}

//------------------------------------------------------------------------------
double LengthInside(
  const std::vector<Box>& boxes, const glm::dvec3& o, const glm::dvec3& d, double l)
{
  std::vector<double> ends;
  for (const Box& box : boxes)
  {
    const glm::dvec2 range = ClipToBox(box, o, d);
    if (range.y > range.x)
    {
      ends.push_back(std::clamp(range.x, 0.0, l));
      ends.push_back(std::clamp(range.y, 0.0, l));
    }
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    sum += ends[i + 1] - ends[i];
  }
  return sum;
}

//------------------------------------------------------------------------------
Mesh Flip(vtkPolyData* mesh, bool all, Random& random)
{
  Mesh flipped = Mesh::New();
  flipped->DeepCopy(mesh);
  vtkNew<vtkCellArray> cells;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (mesh->GetPolys()->InitTraversal(); mesh->GetPolys()->GetNextCell(count, ids);)
  {
    std::vector<vtkIdType> polygon(ids, ids + count);
    if (all || random.Index(2) == 0)
    {
      std::reverse(polygon.begin(), polygon.end());
    }
    cells->InsertNextCell(count, polygon.data());
  }
  flipped->SetPolys(cells);
  return flipped;
}
}
