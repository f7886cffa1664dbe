// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightProbeFilter: scattered light against brute force (see AirlightTestIrradiance.h), a
// surface that shades itself, kinds of data, the same output in one thread and in many.

#include "AirlightTestIrradiance.h"
#include "AirlightTestProbe.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
void TestScattered()
{
  Random random(8);
  Comparison comparison("scattered irradiance, relative");
  for (int k : { 0, 3, 5 }) // point light, spot, sun
  {
    const auto light = MakeLights()[k];
    const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 5, true);
    Probing probing;
    probing.Medium->SetPhaseFunctionToHenyeyGreenstein();
    probing.Medium->SetAnisotropy(0.4);
    probing.Filter->SetInputData(cloud);
    probing.Filter->AddLight(light.second);
    probing.Filter->ScatteredIrradianceOn();
    probing.Filter->Update();
    for (vtkIdType i = 0; i < 5; ++i)
    {
      glm::dvec3 p;
      glm::dvec3 normal;
      cloud->GetPoint(i, &p.x);
      cloud->GetPointData()->GetNormals()->GetTuple(i, &normal.x);
      const glm::dvec3 expected =
        Hemisphere(probing.Medium, light.second, p, glm::normalize(normal)).Irradiance(1);
      const glm::dvec3 found = probing.Get("ScatteredIrradiance", i);
      for (int c = 0; c < 3; ++c)
      {
        // The errors that vtkAirlightPass::SetScatteredSurfaceLight() states.
        comparison.Add(std::abs(found[c] / expected[c] - 1.0), k == 3 ? 0.01 : 0.003,
          [&] { return Text(light.first, ", point ", i, ": ", found[c], ", not ", expected[c]); });
      }
    }
  }
  Check(comparison.Report(), "scattered irradiance");
}

//------------------------------------------------------------------------------
// A ball, its own occluder, under a sun from above: E cos(theta) on the upper half, 0 below.
void TestSurface()
{
  vtkNew<vtkSphereSource> sphere; // of single precision
  sphere->SetCenter(3.0, 2.0, 1.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(61);
  const auto sun = MakeLights()[5].second;
  sun->SetPosition(0.0, 0.0, 1.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  Probing probing;
  probing.Filter->SetInputConnection(sphere->GetOutputPort());
  probing.Filter->AddInputConnection(1, sphere->GetOutputPort());
  probing.Filter->AddLight(sun);
  probing.Filter->Update();
  vtkDataArray* normals = sphere->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const double cosine = normals->GetComponent(i, 2);
    const double e = probing.Get("DirectIrradiance", i).x;
    Check(cosine < 0.05 || std::abs(e - 4.0 * cosine) < 1e-5, Text("lit side, E = ", e));
    Check(cosine > -0.05 || e == 0.0, Text("dark side, E = ", e));
  }
}

//------------------------------------------------------------------------------
// Any data set keeps its kind; nothing depends on threads; no lights are no error.
void TestData()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(11, 12, 13);
  image->SetSpacing(0.2, 0.2, 0.2);
  image->SetOrigin(-1.0, -1.0, -1.0);
  Random random(6);
  std::vector<Triangle> triangles;
  const auto lights = MakeLights();
  Probing probing;
  probing.Filter->SetInputData(image);
  probing.Filter->AddOccluderData(MakeRandomSoup(random, 50, triangles));
  probing.Filter->AddLight(lights[0].second);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  probing.Filter->Update();
  auto* output = vtkImageData::SafeDownCast(probing.Filter->GetOutput());
  if (!Check(output && output->GetNumberOfPoints() == 11 * 12 * 13, "an image stays an image"))
  {
    return;
  }
  vtkNew<vtkImageData> one;
  one->DeepCopy(output);
  vtkSMPTools::Initialize(4);
  probing.Filter->Modified();
  probing.Filter->Update();
  for (const char* name : { "Radiance", "Transmittance", "DirectIrradiance" })
  {
    auto* a = vtkDoubleArray::SafeDownCast(one->GetPointData()->GetArray(name));
    auto* b = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetArray(name));
    Check(a && b && a->GetNumberOfValues() == 3 * 11 * 12 * 13 &&
        std::equal(a->Begin(), a->End(), b->Begin(), b->End()),
      Text(name, ": the same of one and four threads"));
  }
  const double before = probing.Get("Radiance", 0).x;
  lights[0].second->SetIntensity(2.0);
  probing.Filter->Update();
  Check(std::abs(probing.Get("Radiance", 0).x / before - 2.0) < 1e-12, "a changed light is seen");
  probing.Filter->RemoveAllLights();
  probing.Filter->Update();
  Check(probing.Get("Radiance", 0) == glm::dvec3(0.0), "no light, no airlight");
  Check(probing.Get("Transmittance", 0).x < 1.0, "no light, but transmittance");
}
}

//------------------------------------------------------------------------------
int TestAirlightProbeSurfaces(int, char*[])
{
  TestScattered();
  TestSurface();
  TestData();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
