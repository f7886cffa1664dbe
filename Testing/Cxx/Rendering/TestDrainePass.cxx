// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass, the mapper and the probe filter with Draine's phase function, fitted and as a table,
// against vtkAirlight on the pixels' rays, which TestDrainePhaseFunction compares with quadrature.

#include "AirlightTestMapper.h"
#include "AirlightTestMatrixReference.h"
#include "AirlightTestPassMatrix.h"

#include "vtkAirlightProbeFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cstdlib>

using namespace airlight_test;
using Medium = vtkParticipatingMedium;

namespace
{
bool TestPass()
{
  PassMatrixComparisons comparisons;
  PassMatrix experiment;
  for (const int phase : { MATRIX_DRAINE, MATRIX_FOG })
  {
    for (int light = 0; light < MATRIX_LIGHTS; ++light)
    {
      for (const int region : { Medium::UNBOUNDED, Medium::BOX })
      {
        const int turn = light + region;
        const MatrixCell cell{ light, region, turn % 3 == 2 ? 1 : 0, phase };
        experiment.Run(cell, turn % 2 == 1, turn / 2 % 2 == 1,
          region == Medium::UNBOUNDED || light % 2 == 0, comparisons);
      }
    }
  }
  return comparisons.Report();
}

//------------------------------------------------------------------------------
bool TestMapper()
{
  Comparison comparison("mapper");
  MapperScene scene;
  vtkLight* light = scene.AddPointLight({ -1.5, 1.2, 2.0 }, { 40.0, 50.0, 20.0 });
  light->SetFocalPoint(0.5, -1.0, -1.0);
  scene.Add(MakePlane(1));
  const std::vector<MapperSample> samples = scene.GetSamples();
  for (const int phase : { MATRIX_DRAINE, MATRIX_FOG })
  {
    const MatrixCell cell{ MATRIX_POINT, Medium::UNBOUNDED, Medium::UNIFORM, phase };
    cell.Apply(scene.Medium, light);
    const double limit = cell.HasClosedForm(true, scene.Medium) ? 1e-4 : 1e-3;
    scene.Compare(cell.Describe(), samples, limit + scene.Medium->GetPhaseErrorBound(), comparison);
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// Directly against the integral.
bool TestProbe()
{
  Comparison radiance("probe, radiance");
  Random random(28);
  vtkNew<Medium> medium;
  medium->SetScattering(0.3, 0.2, 0.1);
  vtkNew<vtkLight> light;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 50; ++i)
  {
    const glm::dvec3 p = random.Uniform(0.0, 3.0) * RandomUnit(random);
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  const glm::dvec3 eye(0.4, 1.9, 3.2);
  for (const int phase : { MATRIX_DRAINE, MATRIX_FOG })
  {
    const MatrixCell cell{ MATRIX_POINT, Medium::UNBOUNDED, Medium::UNIFORM, phase };
    cell.Apply(medium, light);
    light->SetPosition(2.0, 1.8, 0.4);
    vtkNew<vtkAirlightProbeFilter> probe;
    probe->SetInputData(cloud);
    probe->SetMedium(medium);
    probe->AddLight(light);
    probe->SetViewpoint(&eye.x);
    probe->Update();
    vtkDataArray* array = probe->GetOutput()->GetPointData()->GetArray("Radiance");
    const MatrixReference reference(medium, light);
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 p;
      cloud->GetPoint(i, &p.x);
      const double l = glm::distance(eye, p);
      for (int k = 0; k < 3; ++k)
      {
        const double expected = reference.Airlight(k, eye, (p - eye) / l, 0.0, l);
        const double limit = medium->GetPhaseErrorBound() + 1e-6;
        radiance.Add(std::abs(array->GetComponent(i, k) - expected), limit * expected,
          [&] { return Text(cell.Describe(), ", point ", i, ", channel ", k); });
      }
    }
  }
  return AllOk({ &radiance });
}
}

//------------------------------------------------------------------------------
int TestDrainePass(int, char*[])
{
  const bool pass = TestPass();
  const bool mapper = TestMapper();
  return TestProbe() && pass && mapper && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
