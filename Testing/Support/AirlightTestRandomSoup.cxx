// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestRandomSoup.h"

namespace airlight_test
{
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
