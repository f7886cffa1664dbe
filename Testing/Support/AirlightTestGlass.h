// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Translucent bodies in a scene, for the picture and for brute force.
 */

#ifndef AirlightTestGlass_h
#define AirlightTestGlass_h

#include "AirlightCompareScene.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkPlaneSource.h"

namespace airlighttest
{
inline void SetShadowOpacity(vtkProp* prop, const glm::dvec3& opacity)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::SHADOW_OPACITY(), opacity.x, opacity.y, opacity.z);
  prop->SetPropertyKeys(keys);
}

// An actor that VTK blends at half its opacity, with a shadow of these opacities.
inline vtkActor* AddGlass(Scene& scene, vtkPolyData* data, const glm::dvec3& opacity,
  const std::function<void(vtkActor*)>& place = {})
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

// A rectangle from a corner along two edges.
inline vtkSmartPointer<vtkPolyData> MakeSheet(
  const glm::dvec3& corner, const glm::dvec3& along, const glm::dvec3& up)
{
  vtkNew<vtkPlaneSource> plane;
  const glm::dvec3 first = corner + along;
  const glm::dvec3 second = corner + up;
  plane->SetOrigin(corner.x, corner.y, corner.z);
  plane->SetPoint1(first.x, first.y, first.z);
  plane->SetPoint2(second.x, second.y, second.z);
  return Make(plane);
}

inline void AddFloorAndBall(Scene& scene)
{
  scene.Add(MakeSheet({ -8, -2, -8 }, { 16, 0, 0 }, { 0, 0, 16 }));
  scene.Add(MakeSphere(0.7), [](vtkActor* actor) { actor->SetPosition(-1.2, -0.8, 1.5); });
}

// The same window with floor, ball and nothing else: shaders are compiled once.
inline void Restart(Scene& scene)
{
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->RemoveAllLights();
  scene.Lights.clear();
  scene.Triangles.clear();
  scene.Look({ 0, 1, 10 }, { 0, 0, 0 });
  AddFloorAndBall(scene);
}
}

#endif
