// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass, the mapper and the probe filter for media inside cylinders, against vtkAirlight on the
// pixels' rays, which TestCylinderRegion compares with quadrature: every kind of light inside and
// outside, cameras inside, outside and along the axis, in both projections; and the pass against
// vtkAirlightReference.

#include "AirlightTestMapper.h"
#include "AirlightTestPassMatrix.h"

#include "vtkAirlightProbeFilter.h"
#include "vtkAirlightReference.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstdlib>

using namespace airlight_test;
using Medium = vtkParticipatingMedium;

namespace
{
bool TestCells()
{
  PassMatrixComparisons comparisons;
  PassMatrix experiment;
  for (const int phase : { MATRIX_ISOTROPIC, MATRIX_FORWARD })
  {
    for (int light = 0; light < MATRIX_LIGHTS; ++light)
    {
      for (int i = 0; i < 4; ++i)
      {
        const MatrixCell cell{ light, Medium::CYLINDER, i % 2, phase };
        const int turn = light + phase + i / 2;
        experiment.Run(cell, turn % 2 == 1, turn / 2 % 2 == 1, i < 2, comparisons);
      }
    }
  }
  return comparisons.Report();
}

//------------------------------------------------------------------------------
// Rays along the axis, from a camera on it, and a wall at half the height.
bool TestAlongAxis()
{
  Comparison airlight("Airlight along the axis");
  Comparison transmittance("Transmittance along the axis");
  Comparison reference("Airlight of the reference");
  PixelScene scene;
  scene.AddTiltedPlane();
  scene.Medium->SetScattering(0.3, 0.2, 0.1);
  scene.Medium->SetAbsorption(0.0, 0.1, 0.2);
  scene.Medium->SetRegionToCylinder();
  scene.Medium->SetCenter(0.2, 0.1, -0.3);
  scene.Medium->SetAxis(0.0, 0.0, -2.0);
  scene.Medium->SetRadius(1.3);
  scene.Medium->SetHeight(2.6);
  scene.Light->SetPositional(true);
  scene.Light->SetConeAngle(180.0);
  scene.Light->SetAttenuationValues(0.0, 0.0, 1.0);
  scene.Light->SetColor(4.0, 7.0, 2.0);
  scene.Plane->SetOrigin(-5.0, -5.0, -0.2);
  scene.Plane->SetPoint1(0.3, -5.0, -0.2);
  scene.Plane->SetPoint2(-5.0, 5.0, -0.2);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.2, 0.1, 5.0);
  camera->SetFocalPoint(0.2, 0.1, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.7);
  camera->SetClippingRange(0.1, 50.0);
  long inside = 0;
  for (const bool lightInside : { true, false })
  {
    lightInside ? scene.Light->SetPosition(0.5, 0.3, 0.1) : scene.Light->SetPosition(2.4, 0.8, 0.9);
    scene.Window->Render();
    vtkNew<vtkAirlightReference> computed;
    computed->SetRenderer(scene.Renderer);
    computed->AddMedium(scene.Medium);
    computed->SetSize(PixelScene::Width, PixelScene::Height);
    computed->Update();
    vtkDataArray* expectedAirlight = computed->GetOutput()->GetPointData()->GetArray("Airlight");
    for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; pixel += 7)
    {
      const int i = pixel % PixelScene::Width;
      const int j = pixel / PixelScene::Width;
      const PixelRay ray = scene.GetRay(i, j);
      const double end = scene.GetEnd(i, j);
      const glm::dvec3 to = ray.Origin + end * ray.Direction;
      const double beside = std::hypot(ray.Origin.x - 0.2, ray.Origin.y - 0.1);
      if (std::abs(beside - 1.3) < 1e-4)
      {
        continue; // along the wall
      }
      double rgb[3];
      double passes[3];
      vtkAirlight::Inscatter(
        scene.Medium, scene.Light, &ray.Origin.x, &ray.Direction.x, 0.0, end, rgb);
      vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &to.x, passes);
      const float* a = scene.GetPixel("Airlight", i, j);
      const float* t = scene.GetPixel("Transmittance", i, j);
      inside += passes[0] < 1.0 ? 1 : 0;
      for (int k = 0; k < 3; ++k)
      {
        const auto describe = [&] {
          return Text("pixel ", i, " ", j, ", channel ", k, ": got ", a[k], ", expected ", rgb[k],
            ", transmittance ", t[k], ", expected ", passes[k]);
        };
        const double limit = lightInside ? 1e-4 : 1e-3;
        airlight.Add(std::abs(a[k] - rgb[k]), limit * rgb[k] + 1e-12, describe);
        transmittance.Add(std::abs(t[k] - passes[k]), 1e-5, describe);
        const double value = expectedAirlight->GetComponent(j * PixelScene::Width + i, k);
        reference.Add(std::abs(a[k] - value), limit * value + 1e-12, describe);
      }
    }
  }
  // A disc of radius 1.3 in a picture 3.4 high: 302 of the samples, but for those at its edge.
  Check(std::abs(inside - 302) < 20, Text("pixels in the medium: ", inside));
  return AllOk({ &airlight, &transmittance, &reference });
}

//------------------------------------------------------------------------------
bool TestMapper()
{
  Comparison comparison("mapper");
  MapperScene scene;
  scene.Medium->SetCenter(0.3, 0.2, 0.5);
  scene.Medium->SetRadius(2.5);
  scene.Medium->SetHeight(5.0);
  scene.Medium->SetAxis(0.2, 1.0, 0.4);
  vtkLight* light = scene.AddPointLight({ -1.0, 0.8, 1.2 }, { 40.0, 50.0, 20.0 });
  light->SetFocalPoint(0.5, -1.0, -1.0);
  scene.Add(MakePlane(1));
  for (const bool parallel : { false, true })
  {
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    const std::vector<MapperSample> samples = scene.GetSamples();
    for (const int kind : { MATRIX_POINT, MATRIX_FALLOFF, MATRIX_SUN })
    {
      const MatrixCell cell{ kind, Medium::CYLINDER, Medium::UNIFORM, MATRIX_ISOTROPIC };
      cell.Apply(scene.Medium, light);
      const double limit = cell.HasClosedForm(true, scene.Medium) ? 1e-4 : 1e-3;
      scene.Compare(
        Text(cell.Describe(), parallel ? ", parallel" : ""), samples, limit, comparison);
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
bool TestProbe()
{
  Comparison radiance("probe, radiance");
  Comparison transmittance("probe, transmittance");
  Random random(29);
  vtkNew<Medium> medium;
  medium->SetRegionToCylinder();
  medium->SetCenter(0.3, 0.2, 0.5);
  medium->SetRadius(1.5);
  medium->SetHeight(2.0);
  medium->SetAxis(0.2, 1.0, 0.4);
  medium->SetScattering(0.3, 0.2, 0.1);
  vtkNew<vtkLight> light;
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetAttenuationValues(0.0, 0.0, 1.0);
  light->SetPosition(2.0, 1.8, 0.4);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 100; ++i)
  {
    const glm::dvec3 p = random.Uniform(0.0, 3.0) * RandomUnit(random);
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  const glm::dvec3 eye(0.4, 1.9, 3.2);
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetInputData(cloud);
  probe->SetMedium(medium);
  probe->AddLight(light);
  probe->SetViewpoint(&eye.x);
  probe->Update();
  vtkPointData* data = probe->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    cloud->GetPoint(i, &p.x);
    const double l = glm::distance(eye, p);
    const glm::dvec3 way = (p - eye) / l;
    double rgb[3];
    double passes[3];
    vtkAirlight::Inscatter(medium, light, &eye.x, &way.x, 0.0, l, rgb);
    vtkAirlight::Transmittance(medium, &eye.x, &p.x, passes);
    for (int k = 0; k < 3; ++k)
    {
      const auto describe = [&] { return Text("point ", i, ", channel ", k); };
      radiance.Add(std::abs(data->GetArray("Radiance")->GetComponent(i, k) - rgb[k]),
        1e-9 * (rgb[k] + 1e-3), describe);
      transmittance.Add(
        std::abs(data->GetArray("Transmittance")->GetComponent(i, k) - passes[k]), 1e-12, describe);
    }
  }
  return AllOk({ &radiance, &transmittance });
}
}

//------------------------------------------------------------------------------
int TestCylinderPass(int, char*[])
{
  const bool cells = TestCells();
  const bool axis = TestAlongAxis();
  const bool mapper = TestMapper();
  return TestProbe() && cells && axis && mapper && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
