// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent casters dim the light in the air and on opaque surfaces behind them, by 1 - opacity a
// layer and colour. Against brute force (AirlightTestBruteForce.h), and against the power law
// itself.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const glm::dvec3 Red(0.1, 0.8, 0.9);
const glm::dvec3 Blue(0.7, 0.5, 0.05);
const glm::dvec3 Grey(0.4);

//------------------------------------------------------------------------------
// Two sheets of different colours that overlap, before a floor and a ball.
void TestSheets(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 1, 4.5, 1 });
  scene.AddPointLight({ -4, 3, 4 }, { 10.0, 20.0, 30.0 });
  AddGlass(scene, MakeSheet({ -2.5, 1.5, -1 }, { 3, 0.3, 0 }, { 0, 0, 3 }), Red);
  AddGlass(scene, MakeSheet({ -1, 0.8, -1.5 }, { 3, -0.2, 0 }, { 0, 0.2, 2.5 }), Blue);
  CompareScene("two sheets", scene);
}

// A closed body: what lies behind it is dimmed by both its walls, what is inside by one.
void TestBody(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 2, 4, 2.5 });
  AddGlass(scene, MakeSphere(1.2), Grey, [](vtkActor* a) { a->SetPosition(1.2, 0.2, 1); });
  CompareScene("closed body", scene);
}

// A lamp in a coloured globe, which hangs in another one.
void TestGlobes(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 0.3, 1, 2 });
  AddGlass(scene, MakeSphere(0.5), Red, [](vtkActor* a) { a->SetPosition(0.3, 0.9, 2); });
  AddGlass(scene, MakeSphere(0.9), Blue, [](vtkActor* a) { a->SetPosition(0.5, 1, 2); });
  CompareScene("globes around the lamp", scene);
}

//------------------------------------------------------------------------------
// The camera in a body, in its shadow, and exactly on a shadow plane.
void TestCameraInside(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 3, 5, 2 });
  AddGlass(scene, MakeSphere(2.0), Red, [](vtkActor* a) { a->SetPosition(0, 1, 8); });
  scene.Look({ 0.4, 1.3, 8.7 }, { 0, 0, 0 });
  CompareScene("camera in a body", scene);
  scene.Look({ -1.3, -0.7, 7.6 }, { 0, 0, 0 });
  CompareScene("camera in a shadow", scene);

  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 0, 8, 0 });
  AddGlass(scene, MakeSheet({ 0, 4, -6 }, { 3, 0, 0 }, { 0, 0, 18 }), Blue);
  scene.Look({ 0, 1, 10 }, { 0, 0, 0 });
  CompareScene("camera on a shadow plane", scene);
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
void TestSoup(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 2, 4, 3 });
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
}

//------------------------------------------------------------------------------
int TestTranslucentShadows(int, char*[])
{
  Scene scene;
  TestSheets(scene);
  TestBody(scene);
  TestGlobes(scene);
  TestCameraInside(scene);
  TestSoup(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
