// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays that go on through a caster, because the camera does not show the side that they meet: the
// ray then crosses the caster's own surface, not only the planes from its silhouette; or because it
// lies before or beyond the clipping range. Against brute force (see AirlightTestBruteForce.h).

#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
void AddBody(Scene& scene)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(12);
  sphere->SetRadius(0.7);
  scene.Add(sphere);
}

//------------------------------------------------------------------------------
// A room seen from outside, the walls between it and the camera culled; the lamp hangs inside.
void TestCulledRoom()
{
  Scene scene;
  scene.AddPointLight({ 1, 2, 1 });
  AddBody(scene);
  vtkNew<vtkCubeSource> room;
  room->SetBounds(-4, 4, -2.5, 3, -4, 4);
  const size_t first = scene.Triangles.size();
  scene.Add(room)->GetProperty()->FrontfaceCullingOn();
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].FrontCulled = true;
  }
  CompareScene("room with culled walls", scene);
}

// Graphics cards move each corner to the nearest 256th of a pixel, which software renderers do not:
// here the mapper does. No wall shadows itself for that.
void TestSnappedCorners()
{
  Scene scene;
  scene.AddPointLight({ 1, 2, 1 });
  vtkNew<vtkCubeSource> room;
  room->SetBounds(-4, 4, -2.5, 3, -4, 4);
  vtkActor* walls = scene.Add(room);
  walls->GetProperty()->FrontfaceCullingOn();
  vtkNew<vtkImageData> exact;
  exact->DeepCopy(scene.Render().at("Surface"));
  walls->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
    Text("//VTK::PositionVC::Impl\n  vec2 steps = 128.0 * vec2(", scene.Width, ".0, ", scene.Height,
      ".0);\n  gl_Position.xy = round(gl_Position.xy / gl_Position.w * steps) / steps * "
      "gl_Position.w;\n"),
    false);
  const Buffers buffers = scene.Render();
  vtkImageData* snapped = buffers.at("Surface");
  int dark = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    dark += GetValue(snapped, x, y) < 0.5 * GetValue(exact, x, y) ? 1 : 0;
  }
  std::cout << "corners snapped: " << dark << " pixels are dark\n";
  Check(dark == 0, "no wall shadows itself");
}

// The same of a room whose points are far from the origin, of which VTK's mappers keep the rounding
// in single precision: rays that end on a wall do not go through it all the same.
void TestFarPoints(double distance)
{
  const glm::dvec3 shift = distance * glm::normalize(glm::dvec3(0.63, -0.41, 0.52));
  Scene scene;
  scene.Look(shift + glm::dvec3(0, 1, 10), shift);
  scene.AddPointLight(shift + glm::dvec3(1, 2, 1));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(12);
  sphere->SetRadius(0.7);
  sphere->SetCenter(&shift.x);
  scene.Add(sphere);
  vtkNew<vtkCubeSource> room;
  room->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  room->SetBounds(shift.x - 4, shift.x + 4, shift.y - 2.5, shift.y + 3, shift.z - 4, shift.z + 4);
  const size_t first = scene.Triangles.size();
  scene.Add(room)->GetProperty()->FrontfaceCullingOn();
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].FrontCulled = true;
  }
  // Half the last place of single precision, of surfaces five units away. Lit parts can be short,
  // and are met at a slant.
  Limits limits;
  limits.Rounding = distance * 0x1p-24 / 5.0;
  limits.Median += 6.0 * limits.Rounding;
  limits.P99 += 60.0 * limits.Rounding;
  CompareScene("room " + std::to_string(distance) + " from the origin", scene, 2000, limits);
}

// A body that the near plane cuts open, lit from before the cut and from behind it.
void TestNearPlane()
{
  for (const double z : { 2.0, 12.0 })
  {
    Scene scene;
    scene.AddPointLight({ 3, 3, z });
    AddBody(scene);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.4, 0.6, 7);
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(16);
    sphere->SetPhiResolution(16);
    scene.Add(sphere);
    scene.Renderer->GetActiveCamera()->SetClippingRange(2.9, 200.0);
    CompareScene("body cut by the near plane, light at z = " + std::to_string(z), scene);
  }
}

// The same in a parallel projection, with bodies behind the camera's plane too.
void TestParallelNearPlane()
{
  Scene scene;
  scene.AddPointLight({ 1, 2, 16 });
  AddBody(scene);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  for (const glm::dvec3& p :
    { glm::dvec3(-1, 1.5, 12), glm::dvec3(1.5, 1, 13.2), glm::dvec3(0, -1, 8) })
  {
    scene.Add(sphere, [&](vtkActor* actor) { actor->SetPosition(p.x, p.y, p.z); });
  }
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(2.0, 50.0);
  CompareScene("parallel projection, bodies behind and cut by the near plane", scene);
}

// A mirrored body that the near plane cuts: its triangles run the other way round.
void TestMirroredNearPlane()
{
  Scene scene;
  scene.AddPointLight({ 3, 3, 12 });
  AddBody(scene);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(16);
  sphere->SetRadius(1.0);
  scene.Add(sphere, [](vtkActor* actor) {
    actor->SetScale(-1.0, 1.0, 1.0);
    actor->SetPosition(0.4, 0.6, 7.0);
  });
  scene.Renderer->GetActiveCamera()->SetClippingRange(2.9, 200.0);
  CompareScene("mirrored body cut by the near plane", scene);
}

// A plate beyond the far plane, which is not drawn and casts a shadow.
void TestFarPlane()
{
  Scene scene;
  scene.AddPointLight({ 1, 2, 4 });
  AddBody(scene);
  vtkNew<vtkPlaneSource> plate; // towards the camera
  plate->SetOrigin(-4, -3, -8);
  plate->SetPoint1(4, -3, -8);
  plate->SetPoint2(-4, 3, -8);
  const size_t first = scene.Triangles.size();
  scene.Add(plate);
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].FrontCulled = true;
  }
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.1, 14.0);
  CompareScene("plate beyond the far plane", scene);
}
}

//------------------------------------------------------------------------------
int TestShadowCutaway(int, char*[])
{
  TestCulledRoom();
  TestSnappedCorners();
  TestFarPoints(300.0);
  TestFarPoints(3000.0);
  TestNearPlane();
  TestParallelNearPlane();
  TestMirroredNearPlane();
  TestFarPlane();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
