// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent casters in lists of boundaries that take several draws, in the light of the sun, as
// blocks and in assemblies, and the power law of layers.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkAssembly.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMultiBlockDataSet.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const glm::dvec3 Red(0.1, 0.8, 0.9);
const glm::dvec3 Blue(0.7, 0.5, 0.05);

//------------------------------------------------------------------------------
// Lists that take several draws, drawn in bands, too: many faint sheets one behind another.
void TestLongLists()
{
  Scene scene(32, 24);
  scene.Pass->SetShadowTechniqueToShadowPlanes(); // AUTOMATIC would take a grid
  Random random(3);
  std::vector<Triangle> sheets;
  for (int i = 0; i < 160; ++i)
  {
    const double x = 30.0 + 0.02 * i;
    const double front = random.Uniform(4.0, 9.0);
    const double back = random.Uniform(-9.0, -2.0);
    sheets.push_back({ { x, -40, front }, { x, -40, back }, { x, 40, back } });
    sheets.push_back({ { x, -40, front }, { x, 40, back }, { x, 40, front } });
  }
  AddGlass(scene, MakeSoup(sheets), { 0.002, 0.005, 0.004 });
  scene.Add(MakeSheet({ 20, -4, -1 }, { 0, 3, 0 }, { 0, 0, 2 }));
  scene.Add(MakeSheet({ -8, -2, -8 }, { 16, 0, 0 }, { 0, 0, 16 }));
  scene.AddPointLight({ 60, 8, -1 }, { 3000, 2000, 1000 });
  // Each layer's thickness is kept to half of 2^-20.
  Limits limits;
  limits.Median = 160.0 * 0x1p-21;
  limits.P99 = 2.0 * limits.Median;
  limits.SurfaceMedian = limits.P99;
  CompareScene("160 sheets", scene, 120, limits);
  const double most = scene.GetBuffer("BoundaryCount")->GetScalarRange()[1];
  std::cout << "  " << most << " boundaries on one pixel\n";
  Check(most > 130.0, "some lists take several draws");
  const Buffers whole = scene.CopyBuffers();
  scene.Pass->SetMemoryLimit(1);
  CheckSame(whole, scene.Render(), "long lists in little memory");
}

//------------------------------------------------------------------------------
// How long a list is decides how it is read. Sheets that take 1e-5 of the light make lists longer
// and hardly change the picture, also where lists become as long as one way of reading allows.
void TestLengthsOfLists()
{
  Scene scene(32, 24);
  scene.Pass->SetShadowTechniqueToShadowPlanes(); // AUTOMATIC would take a grid
  const auto add = [&scene](int i, double opacity) {
    const double front = 2.0 + std::fmod(1.7 * i, 6.0);
    AddGlass(scene, MakeSheet({ 30.0 + 0.02 * i, -40, -9 }, { 0, 80, 0 }, { 0, 0, 9.0 + front }),
      glm::dvec3(opacity));
  };
  constexpr int Dark = 40;
  for (int i = 0; i < Dark; ++i)
  {
    add(i, 0.003);
  }
  scene.AddPointLight({ 60, 8, -1 }, { 3000, 2000, 1000 });
  Buffers before = scene.Render();
  double worst = 0.0;
  int just = 0;
  for (int sheet = Dark; sheet < Dark + 8; ++sheet)
  {
    add(sheet, 1e-5);
    const Buffers after = scene.Render();
    for (int i = 0; i < scene.Width * scene.Height; ++i)
    {
      const int x = i % scene.Width;
      const int y = i / scene.Width;
      const glm::dvec3 air = GetColour(before.at("Airlight"), x, y);
      const glm::dvec3 change = GetColour(after.at("Airlight"), x, y) - air;
      worst = std::max(worst, glm::length(change) / glm::length(air));
      just += GetValue(after.at("BoundaryCount"), x, y) == 64.0;
    }
    before = after;
  }
  std::cout << "one sheet more: " << just << " lists of 64 boundaries, airlight " << worst
            << " off\n";
  Check(just > 100, "there are lists of 64 boundaries");
  Check(worst < 3e-5, "sheets through which light goes change little");
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
    AddGlass(scene, MakeSheet({ -2000, 300.0 + n, -2000 }, { 4000, 0, 0 }, { 0, 0, 4000 }), Red);
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

//------------------------------------------------------------------------------
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
// To the reference only: triangles that rays go through.
void AddShadow(
  Scene& scene, vtkPolyData* data, const glm::dvec3& opacity, const glm::dvec3& shift, bool stops)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, 3, shift[i]);
  }
  for (Triangle t : GetTriangles(data, matrix))
  {
    t.Opacity = opacity;
    t.Stops = stops;
    scene.Triangles.push_back(t);
  }
}

// An opaque block beside a translucent one.
void TestBlocks(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 1, 4.5, 2 });
  const auto ball = MakeSphere(0.5);
  const auto sheet = MakeSheet({ -1, 1.5, 0 }, { 2.5, 0, 0 }, { 0, 0.2, 2.5 });
  vtkNew<vtkMultiBlockDataSet> root;
  root->SetBlock(0, ball);
  root->SetBlock(1, sheet);
  vtkNew<airlight::BlocksMapper> mapper;
  mapper->SetInputDataObject(root);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockOpacity(2, 0.3);
  scene.Renderer->AddActor(Scene::MakeActor(mapper));
  AddShadow(scene, ball, glm::dvec3(1.0), glm::dvec3(0.0), true);
  AddShadow(scene, sheet, glm::dvec3(0.3), glm::dvec3(0.0), false);
  CompareScene("blocks", scene);
}

// The key of an assembly is that of its parts; VTK hands it to them, in place of their own.
void TestAssembly(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 1, 4.5, 2 });
  const auto ball = MakeSphere(0.5);
  const glm::dvec3 places[2] = { { 0.8, 0.5, 1 }, { 0, 1.4, 1.5 } };
  vtkNew<vtkAssembly> assembly;
  for (const glm::dvec3& place : places)
  {
    const vtkSmartPointer<vtkActor> part = Scene::MakeActor(ball);
    part->SetPosition(place.x, place.y, place.z);
    part->GetProperty()->SetOpacity(0.5);
    SetShadowOpacity(part, Blue);
    assembly->AddPart(part);
  }
  SetShadowOpacity(assembly, Red);
  scene.Renderer->AddViewProp(assembly);
  AddShadow(scene, ball, Red, places[0], false);
  AddShadow(scene, ball, Red, places[1], false);
  CompareScene("assembly", scene);
}
}

//------------------------------------------------------------------------------
int TestTranslucentShadowLists(int, char*[])
{
  TestLongLists();
  TestLengthsOfLists();
  TestPowerLaw();
  TestSun();
  Scene scene;
  TestBlocks(scene);
  TestAssembly(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
