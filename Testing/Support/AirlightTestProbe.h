// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points for vtkAirlightProbeFilter, and the filter with what it needs.
 */

#ifndef AirlightTestProbe_h
#define AirlightTestProbe_h

#include "AirlightTestCheck.h"
#include "AirlightTestSoup.h"

#include "vtkAirlightProbeFilter.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

namespace airlight_test
{
const glm::dvec3 Eye(0.4, 1.9, 1.2);

inline vtkSmartPointer<vtkPolyData> MakeCloud(Random& random, int count, bool normals)
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

struct Probing
{
  Probing()
  {
    this->Medium->SetScattering(0.3, 0.2, 0.1);
    this->Medium->SetAbsorption(0.1, 0.0, 0.05);
    this->Filter->SetMedium(this->Medium);
    this->Filter->SetViewpoint(&Eye.x);
  }
  glm::dvec3 Get(const char* name, vtkIdType i)
  {
    glm::dvec3 rgb(-1.0);
    vtkDataArray* array = this->Filter->GetOutput()->GetPointData()->GetArray(name);
    if (Check(array, Text("there is an array ", name)))
    {
      array->GetTuple(i, &rgb.x);
    }
    return rgb;
  }

  vtkNew<vtkAirlightProbeFilter> Filter;
  vtkNew<vtkParticipatingMedium> Medium;
};
}

#endif
