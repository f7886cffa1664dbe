// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The debug view of the difference from the ray march: its colours are those of the recorded
// airlights of both techniques, and it fades as the ray march takes more steps.

#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkUnsignedCharArray.h"

#include <cstdlib>

using namespace airlighttest;
using airlight_test::Comparison;
using airlight_test::ErrorListener;
using airlight_test::Text;

namespace
{
// The picture as it is shown.
vtkSmartPointer<vtkUnsignedCharArray> Show(Scene& scene, int view)
{
  scene.Pass->SetDebugView(view);
  scene.Window->Render();
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  scene.Window->GetPixelData(0, 0, scene.Width - 1, scene.Height - 1, 0, pixels);
  return pixels;
}

Buffers Record(Scene& scene, int technique)
{
  scene.Pass->SetDebugViewToShaded();
  scene.Pass->SetShadowTechnique(technique);
  return scene.Render();
}

double Sum(const glm::dvec3& c) { return c.x + c.y + c.z; }

// The mean of how far the view is from white.
double CheckColours(Scene& scene, const std::string& name, int technique)
{
  const Buffers march = Record(scene, vtkAirlightPass::RAY_MARCH);
  const Buffers exact = Record(scene, technique);
  const auto shown = Show(scene, vtkAirlightPass::DIFFERENCE);
  Check(scene.Pass->GetEffectiveShadowTechnique() == technique, name + ": the picture's technique");
  Comparison comparison(name + ": colours");
  double strength = 0.0;
  int more = 0;
  int less = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const double difference =
      Sum(GetColour(exact.at("Airlight"), x, y)) - Sum(GetColour(march.at("Airlight"), x, y));
    const double share =
      glm::clamp(100.0 * difference / Sum(GetColour(exact.at("Radiance"), x, y)), -1.0, 1.0);
    const glm::dvec3 expected(
      1.0 + std::min(share, 0.0), 1.0 - std::abs(share), 1.0 - std::max(share, 0.0));
    for (int k = 0; k < 3; ++k)
    {
      // Half a step of 8 bits, and single precision times 100.
      comparison.Add(std::abs(shown->GetComponent(i, k) / 255.0 - expected[k]), 0.5 / 255.0 + 1e-3,
        [&] { return Text("pixel ", x, ", ", y, ": ", shown->GetComponent(i, k), ", ", share); });
    }
    strength += std::abs(share);
    more += share > 0.1 ? 1 : 0;
    less += share < -0.1 ? 1 : 0;
  }
  Check(comparison.Report(), name);
  strength /= scene.Width * scene.Height;
  std::cout << name << ": mean strength " << strength << ", " << more << " pixels with more, "
            << less << " with less\n";
  Check(strength > 0.0, name + ": there is a difference");
  return strength;
}
}

//------------------------------------------------------------------------------
int TestDifferenceView(int, char*[])
{
  Scene scene(120, 90);
  scene.Renderer->SetBackground(0.1, 0.1, 0.1);
  scene.AddPointLight({ 2, 4, 3 });
  scene.AddPointLight({ -3, 2, 1 }, { 5.0, 5.0, 8.0 });
  scene.Add(MakeSphere(1.0), [](vtkActor* actor) { actor->SetPosition(0.5, 1.0, 1.0); });
  ErrorListener failed(scene.Pass);
  scene.Pass->SetNumberOfSteps(8);
  const double coarse = CheckColours(scene, "8 steps", vtkAirlightPass::SHADOW_PLANES);
  scene.Pass->SetNumberOfSteps(32);
  const double finer = CheckColours(scene, "32 steps", vtkAirlightPass::SHADOW_PLANES);
  scene.Pass->SetNumberOfSteps(256);
  const double finest = CheckColours(scene, "256 steps", vtkAirlightPass::SHADOW_PLANES);
  Check(finer < 0.5 * coarse && finest < 0.5 * finer,
    Text("the difference shrinks: ", coarse, ", ", finer, ", ", finest));
  scene.Pass->SetNumberOfSteps(8);
  CheckColours(scene, "without shadows in the picture", vtkAirlightPass::NONE);
  CheckColours(scene, "shadow map", vtkAirlightPass::SHADOW_MAP);
  Check(failed.Take() == 0, "no errors");

  scene.Pass->SetShadowTechniqueToRayMarch();
  const auto shaded = Show(scene, vtkAirlightPass::SHADED);
  const auto shown = Show(scene, vtkAirlightPass::DIFFERENCE);
  scene.Window->Render();
  Check(failed.Take() == 1, "no difference from the ray march itself: one error");
  Check(failed.GetText().find("RAY_MARCH") != std::string::npos, "that says why");
  bool same = true;
  for (vtkIdType i = 0; i < shaded->GetNumberOfValues(); ++i)
  {
    same = same && shaded->GetValue(i) == shown->GetValue(i);
  }
  Check(same, "and the picture");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
