// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestBodies.h"

#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkInformation.h"
#include "vtkSphereSource.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
void AddFloor(Scene& scene) { scene.Add(MakePlate({ 0, -2.5, -1 }, 8, 7)); }

//------------------------------------------------------------------------------
static void AddBoxFloor(Scene& scene)
{
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-8, 8, -2.6, -2.5, -8, 6);
  scene.Add(floor);
}

//------------------------------------------------------------------------------
void AddOpenBodies(Scene& scene)
{
  AddBoxFloor(scene);
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

//------------------------------------------------------------------------------
void AddClosedBodies(Scene& scene)
{
  AddBoxFloor(scene);
  scene.Add(MakeSphere(1.0), [](vtkActor* actor) { actor->SetPosition(-1.5, 0, 0.3); });
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(2.0);
  scene.Add(cone, [](vtkActor* actor) { actor->SetPosition(1.5, 0.4, 0); });
}

//------------------------------------------------------------------------------
void SetShadowOpacity(vtkProp* prop, const glm::dvec3& opacity)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::SHADOW_OPACITY(), opacity.x, opacity.y, opacity.z);
  prop->SetPropertyKeys(keys);
}

//------------------------------------------------------------------------------
vtkActor* AddGlass(Scene& scene, vtkPolyData* data, const glm::dvec3& opacity,
  const std::function<void(vtkActor*)>& place)
{
  const size_t first = scene.Triangles.size();
  vtkActor* actor = scene.Add(data, place);
  actor->GetProperty()->SetOpacity(0.5);
  SetShadowOpacity(actor, opacity);
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].Opacity = opacity;
    scene.Triangles[i].Stops = false;
  }
  return actor;
}

//------------------------------------------------------------------------------
void AddFloorAndBall(Scene& scene)
{
  scene.Add(MakeSheet({ -8, -2, -8 }, { 16, 0, 0 }, { 0, 0, 16 }));
  scene.Add(MakeSphere(0.7), [](vtkActor* actor) { actor->SetPosition(-1.2, -0.8, 1.5); });
}

//------------------------------------------------------------------------------
void ResetToFloorAndBall(Scene& scene)
{
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->RemoveAllLights();
  scene.Lights.clear();
  scene.Triangles.clear();
  scene.Look({ 0, 1, 10 }, { 0, 0, 0 });
  AddFloorAndBall(scene);
}
}
