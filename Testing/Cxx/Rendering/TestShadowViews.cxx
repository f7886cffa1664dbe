// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows for all ways to place camera, lights and casters, against brute force (see
// AirlightTestBruteForce.h).

#include "AirlightTestBodies.h"
#include "AirlightTestCheck.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestQuadrature.h"

#include "vtkConeSource.h"
#include "vtkSphereSource.h"

#include <algorithm>
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

//------------------------------------------------------------------------------
// Rays to the background that enter a shadow and never leave it. A lamp at the origin stands before
// a square, 1 away and 2 wide, whose shadow is the pyramid |x|, |y| < -z behind it. The eye, beside
// the lamp, looks along the pyramid's axis. So each ray o + t d is lit up to where it has crossed
// the last of the pyramid's four planes, and dark from there to infinity:
//
//   L = sigmaS I/(4 pi) integral from 0 to there of exp(-sigmaT (t + r))/r^2 dt,   r = |o + t d|
constexpr double Intensity = 5.0;

// With the attenuation 1/r^2 the radiant intensity is pi times VTK's.
void AddLamp(PixelScene& scene)
{
  vtkLight* lamp = scene.Light;
  lamp->PositionalOn();
  lamp->SetConeAngle(180.0);
  lamp->SetPosition(0.0, 0.0, 0.0);
  lamp->SetAttenuationValues(0.0, 0.0, 1.0);
  lamp->SetIntensity(Intensity / Pi);
  scene.Renderer->AddLight(lamp);
}

// Where the ray has crossed all planes ±x + z = 0 and ±y + z = 0.
double GetShadowStart(const PixelRay& ray)
{
  double start = 0.0;
  for (const glm::dvec3& plane : { glm::dvec3(1.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 1.0),
         glm::dvec3(0.0, 1.0, 1.0), glm::dvec3(0.0, -1.0, 1.0) })
  {
    start = std::max(start, -glm::dot(plane, ray.Origin) / glm::dot(plane, ray.Direction));
  }
  return start;
}

double GetExpected(const PixelRay& ray, double scattering, double extinction)
{
  const double foot = -glm::dot(ray.Origin, ray.Direction); // of the lamp in the origin
  const double h = glm::length(ray.Origin + foot * ray.Direction);
  return scattering * Intensity *
    IsotropicAirlight([](double r, double) { return 1.0 / (r * r); }, extinction, foot, h, 0.0,
      GetShadowStart(ray));
}

void TestFog(bool coloured)
{
  PixelScene scene;
  const double extinction[3] = { 0.05, coloured ? 0.1 : 0.05, coloured ? 0.02 : 0.05 };
  scene.Medium->SetScattering(extinction);
  scene.AddPlane({ -1.0, -1.0, -1.0 }, { 1.0, -1.0, -1.0 }, { -1.0, 1.0, -1.0 });
  AddLamp(scene);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(5.0, 0.0, 5.0);
  camera->SetFocalPoint(5.0, 0.0, 0.0);
  camera->SetClippingRange(0.1, 100.0);
  scene.Window->Render();
  double worst = 0.0;
  for (int j = 0; j < PixelScene::Height; j += 3)
  {
    for (int i = 0; i < PixelScene::Width; i += 3)
    {
      const PixelRay ray = scene.GetRay(i, j);
      const float* seen = scene.GetPixel("Airlight", i, j);
      for (int k = 0; k < 3 && seen; ++k)
      {
        const double expected = GetExpected(ray, extinction[k], extinction[k]);
        worst = std::max(worst, std::abs(seen[k] / expected - 1.0));
      }
      Check(seen && *scene.GetPixel("Depth", i, j) < 0.0f, "the ray goes to the background");
      Check(seen && *scene.GetPixel("BoundaryCount", i, j) == 1.0f, "the ray has one boundary");
    }
  }
  const std::string what = coloured ? "coloured" : "grey";
  std::cout << what << ": largest relative error " << worst << "\n";
  Check(worst < 1e-5, what + ": airlight ends where the shadow begins");
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
  TestFog(false);
  TestFog(true);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
