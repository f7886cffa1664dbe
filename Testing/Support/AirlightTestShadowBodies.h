// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Casters of tests of shadows, and a floor to cast them on.
 */

#ifndef AirlightTestShadowBodies_h
#define AirlightTestShadowBodies_h

#include "AirlightTestScene.h"

#include "vtkPlaneSource.h"

namespace airlighttest
{
inline vtkSmartPointer<vtkPolyData> MakeSphere(const glm::dvec3& centre, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(12);
  return Make(sphere);
}

// A horizontal rectangle around a point.
inline vtkSmartPointer<vtkPolyData> MakePlate(const glm::dvec3& centre, double dx, double dz)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(centre.x - dx, centre.y, centre.z + dz);
  plane->SetPoint1(centre.x + dx, centre.y, centre.z + dz);
  plane->SetPoint2(centre.x - dx, centre.y, centre.z - dz);
  return Make(plane);
}

inline void AddFloor(Scene& scene) { scene.Add(MakePlate({ 0, -2.5, -1 }, 8, 7)); }
}

#endif
