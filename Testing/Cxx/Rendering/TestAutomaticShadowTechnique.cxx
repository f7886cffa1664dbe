// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// When AUTOMATIC takes shadow maps, and that it says so once: casters without polygons, and more
// boundaries than the memory limit allows. Old OpenGL is in TestAirlightPassOldOpenGL.

#include "AirlightTestErrors.h"
#include "AirlightTestImageErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPointGaussianMapper.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Draws two frames and checks what they took and said.
void CheckRule(Scene& scene, const std::string& name, int technique, int effective, int warnings,
  const std::string& said = "")
{
  ErrorListener warned(scene.Pass, vtkCommand::WarningEvent);
  ErrorListener failed(scene.Pass);
  scene.Pass->SetShadowTechnique(technique);
  scene.Window->Render();
  scene.Window->Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == effective,
    Text(name, ": technique ", scene.Pass->GetEffectiveShadowTechnique()));
  const int count = warned.Take();
  Check(count == warnings, Text(name, ": ", count, " warnings"));
  Check(count == 0 || warned.GetText().find(said) != std::string::npos,
    name + ": the warning says " + said + ": " + warned.GetText());
  Check(failed.Take() == 0, name + ": no errors");
}

// For one window: in a second one VTK's mapper draws from buffers of the first, which some drivers
// do not survive.
vtkSmartPointer<vtkActor> MakeSplat()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 3.0, 0.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(1.0);
  auto splat = vtkSmartPointer<vtkActor>::New();
  splat->SetMapper(mapper);
  return splat;
}

//------------------------------------------------------------------------------
void TestCasters()
{
  const int automatic = vtkAirlightPass::AUTOMATIC;
  const int planes = vtkAirlightPass::SHADOW_PLANES;
  const int map = vtkAirlightPass::SHADOW_MAP;
  Scene scene(80, 60);
  scene.Pass->SetShadowMapResolution(256);
  vtkLight* lamp = scene.AddPointLight({ 0, 5, 0 });
  scene.Add(MakeSphere(0.5));
  CheckRule(scene, "polygons", automatic, planes, 0);

  vtkSmartPointer<vtkActor> splat = MakeSplat();
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  splat->SetPropertyKeys(keys);
  scene.Renderer->AddActor(splat);
  CheckRule(scene, "a splat that casts none", automatic, planes, 0);
  const double without = GetMean(scene.GetBuffer("Airlight"));
  lamp->SetLightTypeToHeadlight();
  scene.Pass->SetLightScatters(lamp, true);
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 1);
  CheckRule(scene, "a splat in a headlight", automatic, planes, 0);
  lamp->SetLightTypeToSceneLight(); // from where the headlight was, at the eye
  lamp->SetTransformMatrix(nullptr);
  lamp->SetPosition(0.0, 5.0, 0.0);
  CheckRule(scene, "a splat", automatic, map, 1, "PointGaussianMapper");
  // Not of the lit lengths, of which the mean is that of the rays without an end.
  const double with = GetMean(scene.GetBuffer("Airlight"));
  Check(with < 0.99 * without, Text("the splat casts a shadow: ", with, " for ", without));
  CheckRule(scene, "said once", automatic, map, 0);

  Scene other(80, 60);
  other.AddPointLight({ 0, 5, 0 });
  other.Renderer->AddActor(MakeSplat());
  CheckRule(other, "a splat, planes", planes, planes, 1, "PointGaussianMapper");
}

//------------------------------------------------------------------------------
void AddLeaves(Scene& scene, int count)
{
  scene.Pass->SetShadowMapResolution(256);
  scene.AddPointLight({ 0, 5, 0 });
  Random random(3);
  std::vector<Triangle> leaves;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at(random.Uniform(-2.0, 2.0), random.Uniform(2.0, 4.0), random.Uniform(-2, 2));
    leaves.push_back({ at, at + glm::dvec3(0.6, 0, 0.3), at + glm::dvec3(0, 0.1, 0.6) });
  }
  scene.Add(MakeSoup(leaves));
  scene.Pass->SetMaximumBoundariesPerPixel(VTK_DOUBLE_MAX); // TestMaximumBoundaries is for these
}

// Those that a k-buffer of 16 slots leaves over.
double CountInLists(Scene& scene)
{
  vtkImageData* counts = scene.GetBuffer("BoundaryCount");
  double sum = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    sum += std::max(0.0, GetValue(counts, i % scene.Width, i / scene.Width) - 16.0);
  }
  return sum;
}

//------------------------------------------------------------------------------
// Of 1 MiB, a quarter is for lists: 21845 boundaries.
void TestBudget()
{
  const int automatic = vtkAirlightPass::AUTOMATIC;
  const int planes = vtkAirlightPass::SHADOW_PLANES;
  const int map = vtkAirlightPass::SHADOW_MAP;
  Scene scene(160, 120);
  AddLeaves(scene, 500);
  CheckRule(scene, "leaves", automatic, planes, 0);
  const double boundaries = CountInLists(scene);
  Check(boundaries > 2.0 * 16.0 * 21845.0, Text("lists have ", boundaries, " boundaries"));
  const double exact = GetMean(scene.GetBuffer("Airlight"));
  scene.Pass->SetMemoryLimit(1);
  CheckRule(scene, "leaves in 1 MiB", automatic, map, 1, "SetMemoryLimit");
  const double coarse = GetMean(scene.GetBuffer("Airlight"));
  Check(std::abs(coarse - exact) < 0.1 * exact, Text("airlight ", coarse, " for ", exact));
  Check(coarse != exact, "it is that of shadow maps");
  CheckRule(scene, "leaves in 1 MiB, said once", automatic, map, 0);
  scene.Pass->SetMemoryLimit(64);
  CheckRule(scene, "leaves in 64 MiB", automatic, planes, 0);
}

//------------------------------------------------------------------------------
// A picture of which the k-buffer takes many times the limit keeps its planes: each part that has
// slots has few boundaries.
void TestLargePicture()
{
  Scene scene(160, 600);
  AddLeaves(scene, 60);
  scene.Pass->SetMemoryLimit(1);
  CheckRule(
    scene, "few leaves in 1 MiB", vtkAirlightPass::AUTOMATIC, vtkAirlightPass::SHADOW_PLANES, 0);
  const double boundaries = CountInLists(scene);
  Check(boundaries > 16.0 * 21845.0, Text("lists have ", boundaries, " boundaries"));
}
}

//------------------------------------------------------------------------------
int TestAutomaticShadowTechnique(int, char*[])
{
  TestCasters();
  TestBudget();
  TestLargePicture();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
