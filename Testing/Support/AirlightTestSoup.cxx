// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestSoup.h"

#include "vtkAirlight.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
Position ToPosition(const glm::dvec3& p) { return { p.x, p.y, p.z }; }

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSoup(const TriangleList& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const std::array<glm::dvec3, 3>& t : triangles)
  {
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k)
    {
      ids[k] = points->InsertNextPoint(&t[k].x);
    }
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

//------------------------------------------------------------------------------
TriangleList GetFans(vtkPolyData* data, std::vector<vtkIdType>* cellsOf)
{
  TriangleList triangles;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetCellPoints(cell, size, ids);
    for (vtkIdType k = 2; k < size; ++k)
    {
      std::array<glm::dvec3, 3> t;
      data->GetPoint(ids[0], &t[0].x);
      data->GetPoint(ids[k - 1], &t[1].x);
      data->GetPoint(ids[k], &t[2].x);
      triangles.push_back(t);
      if (cellsOf)
      {
        cellsOf->push_back(cell);
      }
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
TriangleList MakeLatticeSoup(Random& random, int count)
{
  const auto coordinate = [&] { return std::floor(random.Uniform(0.0, 3.0)) - 1.0; };
  const auto point = [&] {
    const double x = coordinate();
    const double y = coordinate();
    return glm::dvec3(x, y, coordinate());
  };
  TriangleList triangles;
  while (static_cast<int>(triangles.size()) < count)
  {
    const glm::dvec3 a = point();
    const glm::dvec3 b = point();
    const glm::dvec3 c = point();
    if (glm::length(glm::cross(b - a, c - a)) > 0.0)
    {
      triangles.push_back({ a, b, c });
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
double Facing(const std::array<glm::dvec3, 3>& t, const glm::dvec4& light)
{
  return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), glm::dvec3(light) - light.w * t[0]);
}

//------------------------------------------------------------------------------
EdgeWeights SumDirections(const TriangleList& triangles, const glm::dvec4& light)
{
  EdgeWeights sums;
  for (const std::array<glm::dvec3, 3>& t : triangles)
  {
    const double facing = Facing(t, light);
    for (int k = 0; k < 3; ++k)
    {
      const Position a = ToPosition(t[k]);
      const Position b = ToPosition(t[(k + 1) % 3]);
      const int direction = (facing > 0.0) - (facing < 0.0);
      sums[{ a, b }] += direction;
      sums[{ b, a }] -= direction;
    }
  }
  EdgeWeights weights;
  for (const auto& [ends, sum] : sums)
  {
    if (sum > 0)
    {
      weights[ends] = sum;
    }
  }
  return weights;
}

//------------------------------------------------------------------------------
int Crosses(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p, const glm::dvec3& way)
{
  const glm::dvec3 e1 = t[1] - t[0];
  const glm::dvec3 e2 = t[2] - t[0];
  const glm::dvec3 h = glm::cross(way, e2);
  const double determinant = glm::dot(e1, h);
  if (determinant == 0.0)
  {
    return 0;
  }
  const glm::dvec3 s = p - t[0];
  const double u = glm::dot(s, h) / determinant;
  const glm::dvec3 q = glm::cross(s, e1);
  const double v = glm::dot(way, q) / determinant;
  const double distance = glm::dot(e2, q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || distance <= 0.0 || distance >= 1.0)
  {
    return 0;
  }
  return glm::dot(glm::cross(e1, e2), way) < 0.0 ? 1 : -1;
}

//------------------------------------------------------------------------------
int CountShadows(
  const TriangleList& triangles, const glm::dvec4& light, const glm::dvec3& point, double far)
{
  const glm::dvec3 way =
    light.w != 0.0 ? glm::dvec3(light) - point : far * glm::normalize(glm::dvec3(light));
  int count = 0;
  for (const std::array<glm::dvec3, 3>& t : triangles)
  {
    count += Crosses(t, point, way) != 0 ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeRandomSoup(
  Random& random, int count, std::vector<Triangle>& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < count; ++i)
  {
    const double size = random.LogUniform(0.01, 0.5);
    const glm::dvec3 centre = RandomPoint(random, 1.0);
    const Triangle t{ centre + RandomPoint(random, size), centre + RandomPoint(random, size),
      centre + RandomPoint(random, size) };
    triangles.push_back(t);
    vtkIdType ids[3];
    int k = 0;
    for (const glm::dvec3& p : { t.A, t.B, t.C })
    {
      ids[k++] = points->InsertNextPoint(p.x, p.y, p.z);
    }
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, vtkSmartPointer<vtkLight>>> MakeLights()
{
  std::vector<std::pair<std::string, vtkSmartPointer<vtkLight>>> lights;
  const double power[3] = { 4.0, 3.0, 2.0 };
  const auto add = [&](const char* name) -> vtkLight* {
    auto light = vtkSmartPointer<vtkLight>::New();
    vtkAirlight::SetRadiantIntensity(light, power);
    light->SetExponent(0.0);
    light->SetPosition(0.3, 1.7, -0.4);
    light->SetFocalPoint(-0.2, 0.0, 0.1);
    lights.emplace_back(name, light);
    return light;
  };
  add("point light");
  add("point light among the triangles")->SetPosition(0.1, -0.2, 0.05);
  add("attenuated point light")->SetAttenuationValues(0.5, 0.2, 1.0);
  add("spot")->SetConeAngle(25.0);
  vtkLight* soft = add("spot with exponent");
  soft->SetConeAngle(40.0);
  soft->SetExponent(3.0);
  vtkAirlight::SetIrradiance(add("sun"), power);
  return lights;
}
}
