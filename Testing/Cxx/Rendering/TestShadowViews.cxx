// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows for all ways to place camera, lights and casters, against brute force (see
// AirlightTestBruteForce.h).

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"

#include "vtkConeSource.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
void AddThreeBodies(Scene& scene)
{
  AddFloor(scene);
  scene.Add(MakeSphere({ -1.5, 0, 0 }, 1.0));
  scene.Add(MakeSphere({ 1.2, 0.5, 1 }, 0.7));
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0.5, -1, -2);
  cone->SetHeight(2.0);
  scene.Add(cone);
}

//------------------------------------------------------------------------------
void TestCameraInShadow()
{
  Scene scene;
  // Above the camera, so that the way from the light passes through the middle of each plate:
  // through a diagonal, that is the edge of two triangles.
  scene.AddPointLight({ 0, 9, 10 });
  AddThreeBodies(scene);
  for (int i = 0; i < 4; ++i)
  {
    scene.Add(MakePlate({ 0, 4.0 + i, 10 }, 1.0 + 0.1 * i, 2.0));
  }
  CompareScene("camera four shadows deep", scene);
}

void TestCameraInsideBody()
{
  Scene closed;
  closed.AddPointLight({ 3, 4, 1 });
  closed.Add(MakeSphere({ 0, 1, 10 }, 3.0));
  closed.Window->Render();
  Check(GetColour(closed.GetBuffer("Airlight"), 100, 75) == glm::dvec3(0.0),
    "no light reaches the air inside a closed body");
  Scene open;
  open.AddPointLight({ 3, 4, 1 });
  AddThreeBodies(open);
  vtkNew<vtkSphereSource> shell;
  shell->SetCenter(0, 1, 10);
  shell->SetRadius(2.0);
  shell->SetThetaResolution(24);
  shell->SetPhiResolution(16);
  shell->SetStartPhi(40.0); // around the poles, along z
  shell->SetEndPhi(140.0);
  open.Add(shell);
  CompareScene("camera inside an open shell", open);
}

//------------------------------------------------------------------------------
void TestLightBetween()
{
  Scene scene;
  scene.AddPointLight({ 0.3, 0.4, 4 });
  AddThreeBodies(scene);
  CompareScene("light between camera and objects", scene);
}

void TestLightInsideBody()
{
  Scene scene;
  scene.AddPointLight({ 0, 0.1, 0 });
  AddFloor(scene);
  vtkNew<vtkSphereSource> lantern;
  lantern->SetRadius(1.0);
  lantern->SetThetaResolution(20);
  lantern->SetPhiResolution(20);
  lantern->SetStartTheta(60.0); // a slit all along from pole to pole
  scene.Add(lantern, [](vtkActor* actor) { actor->RotateX(-60); });
  CompareScene("light inside a body with a hole", scene);
}

// The light is singular at the camera, and with it brute force. Only the surfaces are compared: the
// light reaches all that is seen, to the edge of each body.
void TestLightAtCamera()
{
  Scene scene;
  scene.AddPointLight({ 0, 1, 10 });
  scene.AddPointLight({ 3, 3, 2 });
  AddThreeBodies(scene);
  scene.Window->Render();
  int wrong = 0;
  int rays = 0;
  for (int y = 0; y < scene.Height; y += 3)
  {
    for (int x = 0; x < scene.Width; x += 3, ++rays)
    {
      Ray ray = scene.GetRay(x + 0.5, y + 0.5);
      ray.Origin += 1e-6 * ray.Direction;
      const double expected = Trace(scene.Triangles, scene.Lights, scene.Medium, ray).Surface.y;
      const double value = GetColour(scene.GetBuffer("Surface"), x, y).y;
      const bool isFinite = std::isfinite(GetColour(scene.GetBuffer("Airlight"), x, y).y);
      wrong += !isFinite || std::abs(value - expected) > 0.01 * expected + 1e-6;
    }
  }
  std::cout << "light at the camera: " << wrong << " of " << rays << " rays are wrong\n";
  Check(wrong <= rays / 100, "a light at the camera lights what is seen");
}

//------------------------------------------------------------------------------
void TestOutsideTheView()
{
  Scene scene;
  scene.AddPointLight({ 2, 9, 16 });
  AddFloor(scene);
  scene.Add(MakeSphere({ 0.5, 4, 13 }, 0.8)); // behind the camera
  scene.Add(MakePlate({ 3, 4.5, 4 }, 1, 1));  // above the view
  scene.Add(MakeSphere({ -3, 6, 8 }, 0.9));
  CompareScene("casters behind the camera and outside the view", scene);
}
}

//------------------------------------------------------------------------------
int TestShadowViews(int, char*[])
{
  TestCameraInShadow();
  TestCameraInsideBody();
  TestLightBetween();
  TestLightInsideBody();
  TestLightAtCamera();
  TestOutsideTheView();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
