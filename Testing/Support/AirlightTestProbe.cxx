// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestProbe.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeCloud(Random& random, int count, bool normals)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> n;
  n->SetNumberOfComponents(3);
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 p = RandomPoint(random, 1.5);
    const glm::dvec3 normal = RandomPoint(random, 1.0); // of any length
    points->InsertNextPoint(&p.x);
    n->InsertNextTuple(&normal.x);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->SetNormals(normals ? n.Get() : nullptr);
  return data;
}

//------------------------------------------------------------------------------
glm::dvec3 Transmit(vtkParticipatingMedium* medium, const glm::dvec3& a, const glm::dvec3& b)
{
  glm::dvec3 extinction;
  medium->GetExtinction(&extinction.x);
  const double length = glm::distance(a, b);
  const Ray ray{ a, (b - a) / length };
  return glm::exp(-extinction * LengthInside(medium, ray, { 0.0, length }));
}

//------------------------------------------------------------------------------
glm::dvec3 ExpectRadiance(const std::vector<Triangle>& triangles, vtkParticipatingMedium* medium,
  vtkLight* light, const glm::dvec3& point)
{
  const double length = glm::distance(Eye, point);
  const Ray ray{ Eye, (point - Eye) / length };
  std::vector<Interval> shadows;
  for (const Triangle& t : triangles)
  {
    Interval shadow;
    if (FindShadow(t, GetPosition(light), ray, shadow))
    {
      shadows.push_back(shadow);
    }
  }
  glm::dvec3 sum(0.0);
  for (const Interval& part : Complement(shadows, length))
  {
    glm::dvec3 rgb;
    vtkAirlight::Inscatter(
      medium, light, &ray.Origin.x, &ray.Direction.x, part.From, part.To, &rgb.x);
    sum += rgb;
  }
  return sum;
}

//------------------------------------------------------------------------------
glm::dvec3 ExpectDirect(const std::vector<Triangle>& triangles, vtkParticipatingMedium* medium,
  vtkLight* light, const glm::dvec3& point, const glm::dvec3& normal)
{
  const glm::dvec4 lamp = GetPosition(light);
  const glm::dvec3 way = glm::dvec3(lamp) - lamp.w * point;
  const double r = glm::length(way);
  const Ray ray{ point, way / r };
  for (const Triangle& t : triangles)
  {
    if (Hit(t, ray) < (lamp.w != 0.0 ? r : Infinity))
    {
      return glm::dvec3(0.0);
    }
  }
  glm::dvec3 result;
  vtkAirlight::GetRadiantIntensity(light, &result.x);
  if (normal != glm::dvec3(0.0))
  {
    result *= std::max(glm::dot(glm::normalize(normal), ray.Direction), 0.0);
  }
  const glm::dvec3 end = lamp.w != 0.0 ? glm::dvec3(lamp) : point + 100.0 * ray.Direction;
  const bool dims = lamp.w != 0.0 || medium->GetRegion() != vtkParticipatingMedium::UNBOUNDED;
  result *= dims ? Transmit(medium, point, end) : glm::dvec3(1.0);
  if (lamp.w == 0.0)
  {
    return result;
  }
  const double* a = light->GetAttenuationValues();
  glm::dvec3 focus;
  light->GetFocalPoint(&focus.x);
  const double cosine = glm::dot(-ray.Direction, glm::normalize(focus - glm::dvec3(lamp)));
  const double pi = std::acos(-1.0);
  if (light->GetConeAngle() < 90.0 && cosine < std::cos(light->GetConeAngle() * pi / 180.0))
  {
    return glm::dvec3(0.0);
  }
  const double spot = light->GetConeAngle() < 90.0 ? std::pow(cosine, light->GetExponent()) : 1.0;
  return result * spot / (a[0] + a[1] * r + a[2] * r * r);
}

//------------------------------------------------------------------------------
void AddComparison(Comparison& comparison, const glm::dvec3& found, const glm::dvec3& expected,
  double limit, const std::string& where)
{
  for (int c = 0; c < 3; ++c)
  {
    comparison.Add(std::abs(found[c] - expected[c]), limit * (1e-3 + expected[c]),
      [&] { return Text(where, ", channel ", c, ": ", found[c], ", expected ", expected[c]); });
  }
}
}
