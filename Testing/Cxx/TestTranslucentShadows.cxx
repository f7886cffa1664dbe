// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent casters dim the light in the air and on opaque surfaces behind them, by 1 - opacity a
// layer and colour. Against brute force (AirlightBruteForce.h), and against the power law itself.

#include "AirlightTestGlass.h"
#include "AirlightTestTools.h"

#include <cstdlib>

using namespace airlighttest;
using airlight_test::Random;

namespace
{
const glm::dvec3 Red(0.1, 0.8, 0.9);
const glm::dvec3 Blue(0.7, 0.5, 0.05);
const glm::dvec3 Grey(0.4);

//------------------------------------------------------------------------------
// Two sheets of different colours that overlap, before a floor and a ball.
void TestSheets()
{
  Scene scene;
  scene.AddPointLight({ 1, 4.5, 1 });
  scene.AddPointLight({ -4, 3, 4 }, { 10.0, 20.0, 30.0 });
  AddFloorAndBall(scene);
  AddGlass(scene, MakeSheet({ -2.5, 1.5, -1 }, { 3, 0.3, 0 }, { 0, 0, 3 }), Red);
  AddGlass(scene, MakeSheet({ -1, 0.8, -1.5 }, { 3, -0.2, 0 }, { 0, 0.2, 2.5 }), Blue);
  CompareScene("two sheets", scene);
}

// A closed body: what lies behind it is dimmed by both its walls, what is inside by one.
void TestBody()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 2.5 });
  AddFloorAndBall(scene);
  AddGlass(scene, MakeSphere(1.2), Grey, [](vtkActor* a) { a->SetPosition(1.2, 0.2, 1); });
  CompareScene("closed body", scene);
}

// A lamp in a coloured globe, which hangs in another one.
void TestGlobes()
{
  Scene scene;
  scene.AddPointLight({ 0.3, 1, 2 });
  AddFloorAndBall(scene);
  AddGlass(scene, MakeSphere(0.5), Red, [](vtkActor* a) { a->SetPosition(0.3, 0.9, 2); });
  AddGlass(scene, MakeSphere(0.9), Blue, [](vtkActor* a) { a->SetPosition(0.5, 1, 2); });
  CompareScene("globes around the lamp", scene);
}

//------------------------------------------------------------------------------
// The camera in a body, in its shadow, and exactly on a shadow plane.
void TestCameraInside()
{
  Scene scene;
  scene.AddPointLight({ 3, 5, 2 });
  AddFloorAndBall(scene);
  AddGlass(scene, MakeSphere(2.0), Red, [](vtkActor* a) { a->SetPosition(0, 1, 8); });
  scene.Look({ 0.4, 1.3, 8.7 }, { 0, 0, 0 });
  CompareScene("camera in a body", scene);
  scene.Look({ -1.3, -0.7, 7.6 }, { 0, 0, 0 });
  CompareScene("camera in a shadow", scene);

  Scene plane;
  plane.AddPointLight({ 0, 8, 0 });
  AddFloorAndBall(plane);
  AddGlass(plane, MakeSheet({ 0, 4, -6 }, { 3, 0, 0 }, { 0, 0, 18 }), Blue);
  plane.Look({ 0, 1, 10 }, { 0, 0, 0 });
  CompareScene("camera on a shadow plane", plane);
}

//------------------------------------------------------------------------------
Triangle MakeLeaf(Random& random, double size)
{
  const auto vector = [&random](double length) {
    return glm::dvec3(random.Uniform(-length, length), random.Uniform(-length, length),
      random.Uniform(-length, length));
  };
  const glm::dvec3 at = vector(1.8) + glm::dvec3(0, 0.8, 1);
  return { at, at + vector(size), at + vector(size) };
}

// Everything at once: soups of many opacities among opaque ones, some of which block single colours
// or show only their shadow.
void TestSoup()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 3 });
  AddFloorAndBall(scene);
  Random random(5);
  for (int i = 0; i < 12; ++i)
  {
    std::vector<Triangle> leaves;
    for (int k = 0; k < 8; ++k)
    {
      leaves.push_back(MakeLeaf(random, 0.6));
    }
    glm::dvec3 opacity(random.Uniform(0, 1), random.Uniform(0, 1), random.Uniform(0, 1));
    if (i < 3)
    {
      opacity[i] = 1.0;
    }
    AddGlass(scene, MakeSoup(leaves), i == 3 ? glm::dvec3(1.0) : opacity);
  }
  std::vector<Triangle> dark = { MakeLeaf(random, 0.8), MakeLeaf(random, 0.8) };
  scene.Add(MakeSoup(dark));
  CompareScene("soup", scene);

  // An opaque body with the shadow of a translucent one.
  const size_t first = scene.Triangles.size();
  vtkActor* cube = scene.Add(MakeSphere(0.6));
  SetShadowOpacity(cube, Red);
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].Opacity = Red;
  }
  CompareScene("soup and an opaque body with a coloured shadow", scene);
}

// A light at infinity, a box of fog, a parallel projection.
void TestSun()
{
  Scene scene;
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-4, 4, -3, 3, -2, 4);
  scene.AddDirectionalLight({ 0.4, 1, 0.5 });
  AddFloorAndBall(scene);
  AddGlass(scene, MakeSphere(1.0), Red);
  AddGlass(scene, MakeSheet({ -2, 1.5, -1 }, { 3, 0, 0 }, { 0, 0, 3 }), Blue);
  CompareScene("sun", scene);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  CompareScene("sun in a parallel projection", scene);
}

//------------------------------------------------------------------------------
// Lists that take several draws, drawn in bands, too.
void TestLongLists()
{
  Scene scene(32, 24);
  std::vector<Triangle> strips[2];
  for (int i = 0; i < 500; ++i)
  {
    const double front = 8.0 - 0.096 * i;
    const double back = front - 0.05;
    strips[i % 2].push_back({ { 30, -40, front }, { 30, -40, back }, { 30, 40, back } });
    strips[i % 2].push_back({ { 30, -40, front }, { 30, 40, back }, { 30, 40, front } });
  }
  AddGlass(scene, MakeSoup(strips[0]), { 0.2, 0.5, 1.0 });
  scene.Add(MakeSoup(strips[1]));
  scene.Add(MakeSheet({ -8, -2, -38 }, { 30, 0, 0 }, { 0, 0, 46 }));
  scene.AddPointLight({ 60, 1, -10 }, { 3000, 2000, 1000 });
  CompareScene("500 strips", scene, 120);
  const double most = scene.GetBuffer("BoundaryCount")->GetScalarRange()[1];
  Check(most > 300.0, "lists take several draws");
  const Buffers whole = scene.CopyBuffers();
  // 24 bytes for each of some 1000 boundaries a pixel.
  scene.Pass->SetMemoryLimit(1);
  CheckSame(whole, scene.Render(), "long lists in little memory");
}

//------------------------------------------------------------------------------
// Under wide sheets that the sun shines through, all air has the share that n layers let through.
void TestPowerLaw()
{
  Scene scene(40, 30);
  scene.AddDirectionalLight({ 0.2, 1, 0.1 });
  const vtkSmartPointer<vtkImageData> clear = scene.Render()["Airlight"];
  double worst = 0.0;
  double bound = 0.0;
  for (int n = 1; n <= 4; ++n)
  {
    AddGlass(scene, MakeSheet({ -2000, 20.0 + n, -2000 }, { 4000, 0, 0 }, { 0, 0, 4000 }), Red);
    const Buffers buffers = scene.Render();
    for (int i = 0; i < scene.Width * scene.Height; ++i)
    {
      const int x = i % scene.Width;
      const int y = i / scene.Width;
      const glm::dvec3 without = GetColour(clear, x, y);
      const glm::dvec3 expected = glm::pow(1.0 - Red, glm::dvec3(n)) * without;
      const glm::dvec3 error = glm::abs(GetColour(buffers.at("Airlight"), x, y) - expected);
      const double allowed = GetValue(buffers.at("ErrorBound"), x, y);
      worst = std::max({ worst, error.x / without.x, error.y / without.y, error.z / without.z });
      bound = std::max(bound, std::max({ error.x, error.y, error.z }) / allowed);
    }
  }
  std::cout << "power law: largest error " << worst << " of the undimmed airlight, " << bound
            << " of the error bound\n";
  Check(worst < 2e-6, "n layers let (1 - opacity)^n through");
  Check(bound < 1.0, "the error bound holds");
}
}

//------------------------------------------------------------------------------
int TestTranslucentShadows(int, char*[])
{
  TestSheets();
  TestBody();
  TestGlobes();
  TestCameraInside();
  TestSoup();
  TestSun();
  TestLongLists();
  TestPowerLaw();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
