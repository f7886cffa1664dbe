// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points for vtkAirlightProbeFilter, and what it ought to say of them.
 */

#ifndef AirlightTestProbe_h
#define AirlightTestProbe_h

#include "AirlightTestCheck.h"
#include "AirlightTestRandomSoup.h"

#include "vtkAirlightProbeFilter.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

namespace airlight_test
{

const glm::dvec3 Eye(0.4, 1.9, 1.2);

vtkSmartPointer<vtkPolyData> MakeCloud(Random& random, int count, bool normals);

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

// exp(-sigma_t l), with l the length inside the region.
glm::dvec3 Transmit(vtkParticipatingMedium* medium, const glm::dvec3& a, const glm::dvec3& b);

glm::dvec3 ExpectRadiance(const std::vector<Triangle>& triangles, vtkParticipatingMedium* medium,
  vtkLight* light, const glm::dvec3& point);

// I cos(theta)/(a + b r + c r^2) T, times cos(angle)^exponent of a spot. `normal` may be 0: none.
glm::dvec3 ExpectDirect(const std::vector<Triangle>& triangles, vtkParticipatingMedium* medium,
  vtkLight* light, const glm::dvec3& point, const glm::dvec3& normal);

void AddComparison(Comparison& comparison, const glm::dvec3& found, const glm::dvec3& expected,
  double limit, const std::string& where);
}

#endif
