// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent surfaces with the ray march: the air before each, with its shadows, is that before an
// opaque surface in the same place, but for the steps of the longer ray.

#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPlaneSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Opacity = 0.5;

vtkSmartPointer<vtkImageData> Copy(Scene& scene, const char* name)
{
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(scene.GetBuffer(name));
  return copy;
}

// The share of pixels whose layer is further than 1 % from the opaque pane's, and the largest
// shadow in the air before the pane, relative.
void Compare(Scene& scene, const std::string& name, double most)
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
}

//------------------------------------------------------------------------------
int TestTranslucentRayMarch(int, char*[])
{
  Scene scene(120, 90);
  scene.Pass->SetShadowMapResolution(512);
  scene.Pass->SetShadowTechniqueToRayMarch();
  scene.Pass->SetNumberOfSteps(400);
  scene.AddPointLight({ 1, 3, 4 });
  scene.Add(MakeSphere(0.5), [](vtkActor* actor) { actor->SetPosition(0.7, 2, 3.2); });
  scene.Add(MakeSphere(0.5), [](vtkActor* actor) { actor->SetPosition(-1, 0, 2); });
  // At the edges of shadows steps that lie otherwise make another picture.
  Compare(scene, "point light", 0.01);
  scene.Renderer->RemoveAllLights();
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-4, 4, -3, 3, -2, 4);
  scene.AddDirectionalLight({ 0.3, 1.0, 0.4 });
  Compare(scene, "sun", 0.01);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
