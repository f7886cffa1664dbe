// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent casters dim the light in the air and on opaque surfaces behind them, by 1 - opacity a
// layer and colour. Against brute force (AirlightTestBruteForce.h), and against the power law
// itself.
//
// Translucent surfaces with the ray march: the air before each, with its shadows, is that before an
// opaque surface in the same place, but for the steps of the longer ray.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPlaneSource.h"

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

//------------------------------------------------------------------------------
constexpr double Opacity = 0.5;

vtkSmartPointer<vtkImageData> Copy(Scene& scene, const char* name)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(scene.GetBuffer(name));
  return copy;
}

// The share of pixels whose layer is further than 1 % from the opaque pane's, and the largest
// shadow in the air before the pane, relative.
void ComparePane(Scene& scene, const std::string& name, double most)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-30.0, -30.0, 0.5);
  plane->SetPoint1(30.0, -30.0, 0.5);
  plane->SetPoint2(-30.0, 30.0, 0.5);
  const vtkSmartPointer<vtkActor> pane = Scene::MakeActor(Make(plane));
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  pane->SetPropertyKeys(keys);
  scene.Window->Render();
  const auto behind = Copy(scene, "Radiance");
  scene.Renderer->AddActor(pane);
  scene.Window->Render();
  const auto opaque = Copy(scene, "Radiance");
  const auto air = Copy(scene, "Airlight");
  pane->GetProperty()->SetOpacity(Opacity);
  scene.Window->Render();
  const auto translucent = Copy(scene, "Radiance");
  pane->GetProperty()->SetOpacity(1.0);
  const int technique = scene.Pass->GetEffectiveShadowTechnique();
  scene.Pass->SetShadowTechniqueToNone();
  scene.Window->Render();
  const auto unshadowed = Copy(scene, "Airlight");
  scene.Pass->SetShadowTechnique(technique);
  scene.Renderer->RemoveActor(pane);
  int wrong = 0;
  double shadow = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const glm::dvec3 layer =
      (GetColour(translucent, x, y) - (1.0 - Opacity) * GetColour(behind, x, y)) / Opacity;
    const glm::dvec3 expected = GetColour(opaque, x, y);
    wrong += glm::length(layer - expected) <= 0.01 * glm::length(expected) ? 0 : 1;
    shadow = std::max(shadow, 1.0 - GetColour(air, x, y).x / GetColour(unshadowed, x, y).x);
  }
  const double share = wrong / static_cast<double>(scene.Width * scene.Height);
  Check(share <= most, Text(name, ": ", share, " of the pixels differ by more than 1 %"));
  Check(shadow > 0.2, Text(name, ": the air before the pane is in shadow by ", shadow));
  std::cout << name << ": " << share << " of the pixels differ, " << shadow << " in shadow\n";
}

void TestRayMarch()
{
  Scene scene(120, 90);
  scene.Pass->SetShadowMapResolution(512);
  scene.Pass->SetShadowTechniqueToRayMarch();
  scene.Pass->SetNumberOfSteps(400);
  scene.AddPointLight({ 1, 3, 4 });
  scene.Add(MakeSphere(0.5), [](vtkActor* actor) { actor->SetPosition(0.7, 2, 3.2); });
  scene.Add(MakeSphere(0.5), [](vtkActor* actor) { actor->SetPosition(-1, 0, 2); });
  // At the edges of shadows steps that lie otherwise make another picture.
  ComparePane(scene, "point light", 0.01);
  scene.Renderer->RemoveAllLights();
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-4, 4, -3, 3, -2, 4);
  scene.AddDirectionalLight({ 0.3, 1.0, 0.4 });
  ComparePane(scene, "sun", 0.01);
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
  TestRayMarch();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
