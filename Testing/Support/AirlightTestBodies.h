// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Bodies that several tests cast shadows with.
 */

#ifndef AirlightTestBodies_h
#define AirlightTestBodies_h

#include "AirlightTestScene.h"

#include "vtkConeSource.h"
#include "vtkCubeSource.h"

namespace airlighttest
{
inline void AddFloor(Scene& scene)
{
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-8, 8, -2.6, -2.5, -8, 6);
  scene.Add(floor);
}

// A ball and an open cone above a floor.
inline void AddOpenBodies(Scene& scene)
{
  AddFloor(scene);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(14);
  sphere->SetPhiResolution(14);
  scene.Add(sphere, [](vtkActor* actor) { actor->SetPosition(-1.5, 0, 0.3); });
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(2.0);
  cone->CappingOff();
  scene.Add(cone, [](vtkActor* actor) {
    actor->SetPosition(1.5, 0.4, 0);
    actor->RotateZ(50);
  });
}

// The same, closed.
inline void AddClosedBodies(Scene& scene)
{
  AddFloor(scene);
  scene.Add(MakeSphere(1.0), [](vtkActor* actor) { actor->SetPosition(-1.5, 0, 0.3); });
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(2.0);
  scene.Add(cone, [](vtkActor* actor) { actor->SetPosition(1.5, 0.4, 0); });
}
}

#endif
