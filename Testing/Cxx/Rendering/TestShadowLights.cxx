// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows for parallel projection, directional lights, several lights and bounded media, and for
// cameras on a shadow's very edge, against brute force (see AirlightTestBruteForce.h).

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"

#include "vtkCubeSource.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
void SetParallel(Scene& scene, double scale)
{
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(scale);
}

//------------------------------------------------------------------------------
void TestParallelPoint()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 3 });
  AddOpenBodies(scene);
  SetParallel(scene, 4.0);
  CompareScene("parallel projection, point light", scene);
}

void TestParallelInShadow()
{
  // The rays start inside shadows of what stands before and behind the camera's plane.
  Scene scene;
  scene.AddPointLight({ 1, 2, 16 });
  AddOpenBodies(scene);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  scene.Add(sphere, [](vtkActor* actor) { actor->SetPosition(-1, 1.5, 12); });
  scene.Add(sphere, [](vtkActor* actor) { actor->SetPosition(1.5, 1, 13.2); });
  SetParallel(scene, 4.0);
  CompareScene("parallel projection, rays that start in shadow", scene);
}

void TestParallelDirectional()
{
  Scene scene;
  scene.AddDirectionalLight({ 1, 2, 0.5 });
  AddOpenBodies(scene);
  SetParallel(scene, 4.0);
  CompareScene("parallel projection, directional light", scene);
}

//------------------------------------------------------------------------------
void TestDirectional()
{
  Scene scene;
  scene.AddDirectionalLight({ 0.7, 2, 0.5 });
  AddOpenBodies(scene);
  CompareScene("directional light", scene);
}

void TestDirectionalFromBehind()
{
  // The camera and the rays' beginning are in the shadow of a plate behind the camera.
  Scene scene;
  scene.AddDirectionalLight({ 0.1, 0.5, 2 });
  AddOpenBodies(scene);
  vtkNew<vtkCubeSource> plate;
  plate->SetBounds(-0.5, 1.5, 0.5, 2.5, 12, 12.2);
  scene.Add(plate);
  CompareScene("directional light, camera in shadow", scene);
}

//------------------------------------------------------------------------------
void TestTwoLights()
{
  Scene scene;
  scene.AddPointLight({ 3, 4, 2 });
  scene.AddPointLight({ -4, 2, 3 }, { 10, 30, 50 });
  AddOpenBodies(scene);
  CompareScene("two point lights", scene);
}

void TestThreeLightsOfTwoKinds()
{
  Scene scene;
  scene.AddPointLight({ 3, 4, 2 });
  scene.AddDirectionalLight({ -1, 1, 0.3 }, { 0.5, 0.2, 0.1 });
  scene.AddPointLight({ 0, 2, -3 }, { 10, 30, 50 });
  AddOpenBodies(scene);
  CompareScene("two point lights and a directional one", scene);
}

//------------------------------------------------------------------------------
void SetBox(Scene& scene)
{
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-4, 3, -2, 5, -3, 4);
}

void TestBoxWithLight()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 2 });
  AddOpenBodies(scene);
  SetBox(scene);
  CompareScene("box of medium that holds the light", scene);
}

void TestBoxWithoutLight()
{
  Scene scene;
  scene.AddPointLight({ 5, 6, 3 });
  AddOpenBodies(scene);
  SetBox(scene);
  CompareScene("box of medium beside the light", scene);
}

//------------------------------------------------------------------------------
void TestPhaseFunction()
{
  Scene scene;
  scene.AddPointLight({ 1, 2, -3 });
  AddOpenBodies(scene);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.7);
  CompareScene("forward scattering medium", scene);
}

//------------------------------------------------------------------------------
// A plate above the camera ends in the plane that holds camera and light: the rays to its side
// start in shadow, the others in light.
void TestCameraOnEdge()
{
  Scene scene;
  scene.AddPointLight({ 0, 8, 10 });
  AddOpenBodies(scene);
  scene.Add(MakeSoup(
    { { { 0, 4, 6 }, { 3, 4, 6 }, { 3, 4, 13 } }, { { 0, 4, 6 }, { 3, 4, 13 }, { 0, 4, 13 } } }));
  CompareScene("camera on the edge of a shadow", scene);
}

// The same a little to either side, where single precision cannot tell.
void TestCameraNearEdge()
{
  for (const double x : { -1e-7, 1e-7, -1e-5, 1e-5 })
  {
    Scene scene;
    scene.AddPointLight({ 0, 8, 10 });
    AddOpenBodies(scene);
    scene.Add(MakeSoup(
      { { { x, 4, 6 }, { 3, 4, 6 }, { 3, 4, 13 } }, { { x, 4, 6 }, { 3, 4, 13 }, { x, 4, 13 } } }));
    CompareScene("camera at " + std::to_string(1e6 * x) + "e-6 of a shadow's edge", scene);
  }
}

// In parallel projection all rays come from one point at infinity. Here it is on the edge of a
// plate's shadow or on two of them, or beside one by what single precision cannot tell: rays to one
// side start in shadow, the others in light.
void TestParallelOnEdge()
{
  for (const double x : { 0.0, -1e-7, 1e-7, -1e-5, 1e-5 })
  {
    for (const double y : { -1.0, 0.0 })
    {
      Scene scene;
      scene.Look({ 0, 0, 10 }, { 0, 0, 0 });
      scene.AddPointLight({ 0, 0, -3 });
      AddOpenBodies(scene);
      scene.Add(MakeSoup({ { { x, y, -1 }, { 2, y, -1 }, { 2, 2, -1 } },
        { { x, y, -1 }, { 2, 2, -1 }, { x, 2, -1 } } }));
      SetParallel(scene, 4.0);
      CompareScene("parallel projection along the edge of a shadow, " + std::to_string(1e6 * x) +
          "e-6 " + std::to_string(y),
        scene);
    }
  }
}

// The light comes straight towards the camera, or nearly so: rays that meet a body start in shadow.
void TestParallelAgainstLight()
{
  for (const glm::dvec3 eye : { glm::dvec3(0, 0, 10), glm::dvec3(3, 5, 8) })
  {
    for (const double aside : { 0.0, 1e-7, 1e-5, 1e-4, 1e-3 })
    {
      Scene scene;
      scene.Look(eye, { 0, 0, 0 });
      scene.AddDirectionalLight(glm::dvec3(aside, 0, 0) - glm::normalize(eye));
      AddOpenBodies(scene);
      SetParallel(scene, 4.0);
      CompareScene("parallel projection against the light, from " + std::to_string(eye.x) + ", " +
          std::to_string(1e6 * aside) + "e-6",
        scene);
    }
  }
}

// A lamp in a closed body has no silhouette: nothing outside is lit, and all within.
void TestLampInClosedBody()
{
  for (const bool inside : { false, true })
  {
    Scene scene;
    scene.AddPointLight({ 0.2, 0.1, -0.1 });
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(2.0);
    scene.Add(sphere);
    const glm::dvec3 eye(0, 1, inside ? 0.5 : 10);
    scene.Look(eye, { 1.5, 0, 0 });
    scene.Window->Render();
    vtkSmartPointer<vtkImageData> length = scene.GetBuffer("LitLength");
    vtkSmartPointer<vtkImageData> depth = scene.GetBuffer("Depth");
    vtkSmartPointer<vtkImageData> surface = scene.GetBuffer("Surface");
    int wrong = 0;
    for (int y = 0; y < scene.Height; ++y)
    {
      for (int x = 0; x < scene.Width; ++x)
      {
        const double expected = inside ? GetValue(depth, x, y) : 0.0;
        const bool right = std::abs(GetValue(length, x, y) - expected) <= 1e-6 * expected &&
          (GetColour(surface, x, y).x > 0.0) == inside;
        wrong += right ? 0 : 1;
      }
    }
    Check(wrong == 0,
      std::string("lamp in a sphere, eye ") + (inside ? "inside: " : "outside: ") +
        std::to_string(wrong) + " pixels are lit wrongly");
  }
}

// Everything a million units from the origin.
void TestFarFromOrigin()
{
  const glm::dvec3 shift(1e6, -2e6, 5e5);
  Scene scene;
  scene.Look(shift + glm::dvec3(0, 1, 10), shift);
  scene.AddPointLight(shift + glm::dvec3(3, 4, 2));
  vtkNew<vtkSphereSource> sphere;
  for (double x : { -1.5, 1.5 })
  {
    scene.Add(sphere, [&](vtkActor* actor) { actor->SetPosition(shift.x + x, shift.y, shift.z); });
  }
  CompareScene("a million units from the origin", scene);
}
}

//------------------------------------------------------------------------------
int TestShadowLights(int, char*[])
{
  TestParallelPoint();
  TestParallelInShadow();
  TestParallelDirectional();
  TestDirectional();
  TestDirectionalFromBehind();
  TestTwoLights();
  TestThreeLightsOfTwoKinds();
  TestBoxWithLight();
  TestBoxWithoutLight();
  TestPhaseFunction();
  TestCameraOnEdge();
  TestCameraNearEdge();
  TestParallelOnEdge();
  TestParallelAgainstLight();
  TestLampInClosedBody();
  TestFarFromOrigin();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
