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
}

//------------------------------------------------------------------------------
int TestAirlightProbeFilter(int, char*[])
{
  TestPoints();
  TestSums();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
