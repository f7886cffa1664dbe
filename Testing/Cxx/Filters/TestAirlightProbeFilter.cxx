// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightProbeFilter: each array at random points among random triangles against loops over
// all triangles and the formulas of the header.

#include "AirlightTestProbe.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// exp(-sigma_t l), with l the length inside the region.
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
// I cos(theta)/(a + b r + c r^2) T, times cos(angle)^exponent of a spot. `normal` may be 0: none.
glm::dvec3 ExpectDirect(const std::vector<Triangle>& triangles, vtkParticipatingMedium* medium,
  vtkLight* light, const glm::dvec3& point, const glm::dvec3& normal)
{
  const glm::dvec4 position = GetPosition(light);
  const glm::dvec3 way = glm::dvec3(position) - position.w * point;
  const double r = glm::length(way);
  const Ray ray{ point, way / r };
  for (const Triangle& t : triangles)
  {
    if (Hit(t, ray) < (position.w != 0.0 ? r : Infinity))
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
  const glm::dvec3 end = position.w != 0.0 ? glm::dvec3(position) : point + 100.0 * ray.Direction;
  const bool dims = position.w != 0.0 || medium->GetRegion() != vtkParticipatingMedium::UNBOUNDED;
  result *= dims ? Transmit(medium, point, end) : glm::dvec3(1.0);
  if (position.w == 0.0)
  {
    return result;
  }
  const double* a = light->GetAttenuationValues();
  glm::dvec3 focus;
  light->GetFocalPoint(&focus.x);
  const double cosine = glm::dot(-ray.Direction, glm::normalize(focus - glm::dvec3(position)));
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

//------------------------------------------------------------------------------
void TestPoints()
{
  Random random(21);
  std::vector<Triangle> triangles;
  const vtkSmartPointer<vtkPolyData> soup = MakeRandomSoup(random, 150, triangles);
  Comparison radiance("radiance");
  Comparison transmittance("transmittance");
  Comparison direct("direct irradiance");
  int lit = 0;
  int dark = 0;
  for (int k = 0; k < 24; ++k)
  {
    const auto light = MakeLights()[k % 6];
    Probing probing;
    probing.Medium->SetBounds(-1.1, 0.9, -1.2, 1.4, -0.8, 1.3);
    probing.Medium->SetRegion(
      k / 6 % 2 ? vtkParticipatingMedium::BOX : vtkParticipatingMedium::UNBOUNDED);
    const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 300, k >= 12);
    probing.Filter->SetInputData(cloud);
    probing.Filter->AddLight(light.second);
    probing.Filter->AddOccluderData(soup);
    probing.Filter->Update();
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 p;
      cloud->GetPoint(i, &p.x);
      glm::dvec3 normal(0.0);
      if (k >= 12)
      {
        cloud->GetPointData()->GetNormals()->GetTuple(i, &normal.x);
      }
      const std::string where = Text(light.first, ", case ", k, ", point ", i);
      AddComparison(radiance, probing.Get("Radiance", i),
        ExpectRadiance(triangles, probing.Medium, light.second, p), 1e-9, where);
      AddComparison(transmittance, probing.Get("Transmittance", i),
        Transmit(probing.Medium, p, Eye), 1e-9, where);
      const glm::dvec3 e = ExpectDirect(triangles, probing.Medium, light.second, p, normal);
      AddComparison(direct, probing.Get("DirectIrradiance", i), e, 1e-9, where);
      ++(e.x > 0.0 ? lit : dark);
    }
  }
  Check(radiance.Report() && transmittance.Report() && direct.Report(), "random points");
  Check(lit > 500 && dark > 500, Text("points in the light ", lit, ", in the dark ", dark));
}

//------------------------------------------------------------------------------
// Lights add, and the medium's ambient radiance L gives albedo L (1 - T).
void TestSums()
{
  Random random(2);
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 20, false);
  const auto lights = MakeLights();
  Probing probing;
  probing.Medium->SetAmbientRadiance(0.5, 0.25, 1.0);
  probing.Filter->SetInputData(cloud);
  probing.Filter->AddLight(lights[0].second);
  probing.Filter->AddLight(lights[5].second);
  probing.Filter->AddLight(lights[0].second); // each once
  Check(probing.Filter->GetNumberOfLights() == 2, "a light counts once");
  probing.Filter->Update();
  const glm::dvec3 albedo(0.75, 1.0, 0.1 / 0.15);
  for (vtkIdType i = 0; i < 20; ++i)
  {
    glm::dvec3 p;
    cloud->GetPoint(i, &p.x);
    glm::dvec3 expected =
      albedo * glm::dvec3(0.5, 0.25, 1.0) * (1.0 - Transmit(probing.Medium, p, Eye));
    glm::dvec3 direct(0.0);
    for (int k : { 0, 5 })
    {
      expected += ExpectRadiance({}, probing.Medium, lights[k].second, p);
      direct += ExpectDirect({}, probing.Medium, lights[k].second, p, glm::dvec3(0.0));
    }
    Check(glm::length(probing.Get("Radiance", i) - expected) < 1e-9 * glm::length(expected),
      Text("radiance of two lights and ambient, point ", i));
    Check(glm::length(probing.Get("DirectIrradiance", i) - direct) < 1e-9 * glm::length(direct),
      Text("irradiance of two lights, point ", i));
  }
}

//------------------------------------------------------------------------------
// Light that is scattered more than once, of lamps inside and outside of a box, as vtkAirlight has
// it, which TestMultipleScattering compares with the exact solution.
void TestMultipleScattering()
{
  Random random(1127);
  Comparison radiance("radiance with multiple scattering, relative");
  Comparison irradiance("irradiance with multiple scattering, relative");
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 20, true);
  for (const bool inside : { true, false })
  {
    const double intensity[3] = { 20.0, 10.0, 5.0 };
    const double lamp[3] = { inside ? 0.3 : 4.0, -0.6, 0.9 };
    vtkNew<vtkLight> light;
    vtkAirlight::SetRadiantIntensity(light, intensity);
    light->SetPosition(lamp);
    Probing probing;
    probing.Medium->SetRegionToBox();
    probing.Medium->SetBounds(-3.0, 2.5, -2.0, 3.5, -2.5, 2.0);
    probing.Medium->MultipleScatteringOn();
    probing.Filter->ScatteredIrradianceOn();
    probing.Filter->SetInputData(cloud);
    probing.Filter->AddLight(light);
    probing.Filter->Update();
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      const std::string where = Text(inside ? "inside" : "outside", ", point ", i);
      glm::dvec3 p;
      glm::dvec3 normal;
      cloud->GetPoint(i, &p.x);
      cloud->GetPointData()->GetNormals()->GetTuple(i, &normal.x);
      normal = glm::normalize(normal);
      const double length = glm::distance(Eye, p);
      const glm::dvec3 direction = (p - Eye) / length;
      glm::dvec3 expected;
      vtkAirlight::MultipleScattering(
        probing.Medium, lamp, intensity, &Eye.x, &direction.x, length, &expected.x);
      expected += ExpectRadiance({}, probing.Medium, light, p);
      AddComparison(radiance, probing.Get("Radiance", i), expected, 1e-9, where);
      vtkAirlight::MultipleIrradiance(
        probing.Medium, lamp, intensity, &p.x, &normal.x, &expected.x);
      AddComparison(irradiance, probing.Get("ScatteredIrradiance", i), expected, 1e-9, where);
    }
  }
  Check(radiance.Report() && irradiance.Report(), "multiple scattering");
}
}

//------------------------------------------------------------------------------
int TestAirlightProbeFilter(int, char*[])
{
  TestPoints();
  TestSums();
  TestMultipleScattering();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
