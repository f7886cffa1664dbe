// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass in its place in VTK: what becomes of backgrounds, depth, single actors and
// annotations, and the keeping of media.

#include "AirlightTestCompareScene.h"

#include "vtkActorCollection.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationKeyLookup.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
void AddBodies(Scene& scene)
{
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
  scene.Add(floor);
  scene.Add(MakeSphere(1.0), [](vtkActor* actor) { actor->SetPosition(-1.3, 0, 0); });
}

//------------------------------------------------------------------------------
// A gradient seen through a box of medium: T background + airlight, both from vtkAirlight.
void TestBackground()
{
  Scene scene;
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground(0.8, 0.1, 0.3);
  scene.Renderer->SetBackground2(0.1, 0.2, 0.9);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-4, 4, -3, 3, -5, 5);
  scene.AddPointLight({ 1, 1, 1 }, { 4, 5, 6 });
  const Picture picture = Capture(scene.Window);
  double largest = 0.0;
  for (int y = 0; y < scene.Height; y += 7)
  {
    for (int x = 0; x < scene.Width; x += 7)
    {
      const double share = (y + 0.5) / scene.Height;
      const glm::dvec3 background =
        glm::mix(glm::dvec3(0.8, 0.1, 0.3), glm::dvec3(0.1, 0.2, 0.9), share);
      const Ray ray = scene.GetRay(x + 0.5, y + 0.5);
      const glm::dvec3 far = ray.Origin + 100.0 * ray.Direction;
      glm::dvec3 passes;
      vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &far.x, &passes.x);
      const glm::dvec3 expected =
        255.0 * (passes * background + scene.GetAnswer(x + 0.5, y + 0.5).Airlight);
      for (int k = 0; k < 3; ++k)
      {
        const double value = picture[3 * (y * scene.Width + x) + k];
        largest = std::max(largest, std::abs(value - std::min(expected[k], 255.0)));
      }
    }
  }
  std::cout << "gradient background: differs by " << largest << "/255\n";
  // Half a step of rounding, one of VTK's own for the gradient.
  Check(largest <= 1.5, "the background is attenuated and the airlight added");
}

//------------------------------------------------------------------------------
void TestDepthWrittenBack()
{
  Scene scene;
  AddBodies(scene);
  scene.AddPointLight({ 3, 3, 3 });
  const int right = scene.Width - 1;
  const int top = scene.Height - 1;
  scene.Window->Render();
  vtkNew<vtkFloatArray> with;
  scene.Window->GetZbufferData(0, 0, right, top, with);
  const double z = scene.Renderer->GetZ(70, 75);
  scene.Renderer->SetPass(nullptr);
  scene.Window->Render();
  vtkNew<vtkFloatArray> without;
  scene.Window->GetZbufferData(0, 0, right, top, without);
  double largest = 0.0;
  for (vtkIdType i = 0; i < without->GetNumberOfValues(); ++i)
  {
    largest =
      std::max(largest, std::abs(static_cast<double>(with->GetValue(i)) - without->GetValue(i)));
  }
  std::cout << "depth written back: differs by " << largest << "\n";
  // Both keep 24 bits.
  Check(largest <= 1.0 / (1 << 23), "the depth buffer is the one without the pass");
  Check(z < 1.0 && std::abs(z - scene.Renderer->GetZ(70, 75)) <= 1.0 / (1 << 23), "GetZ()");
}

//------------------------------------------------------------------------------
void TestCastsShadow()
{
  Scene scene;
  AddBodies(scene);
  scene.AddPointLight({ 3, 4, 2 });
  const size_t first = scene.Triangles.size();
  vtkActor* actor = scene.Add(MakeSphere(0.9), [](vtkActor* a) { a->SetPosition(1.3, 0.2, 0.5); });
  for (size_t i = first; i < scene.Triangles.size(); ++i)
  {
    scene.Triangles[i].Casts = false;
  }
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  actor->SetPropertyKeys(keys);
  CompareScene("actor that casts no shadow", scene);
  Check(vtkInformationKeyLookup::Find("CASTS_SHADOW", "vtkAirlightPass") ==
        vtkAirlightPass::CASTS_SHADOW() &&
      vtkInformationKeyLookup::Find("SHADOW_OPACITY", "vtkAirlightPass") ==
        vtkAirlightPass::SHADOW_OPACITY(),
    "the keys are found by their names");
}

void TestSurfaceShadows()
{
  Scene scene;
  AddBodies(scene);
  scene.AddPointLight({ 3, 4, 2 });
  const Buffers all = scene.Render();
  scene.Pass->SurfaceShadowsOff();
  const Buffers air = scene.Render();
  scene.Pass->SetShadowTechniqueToNone();
  const Buffers none = scene.Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == vtkAirlightPass::NONE, "technique None");
  Check(AreSame(all.at("Airlight"), air.at("Airlight")), "shafts stay without surface shadows");
  Check(AreSame(air.at("Surface"), none.at("Surface")), "surfaces are lit without their shadows");
  Check(!AreSame(all.at("Surface"), none.at("Surface")), "surfaces have shadows");
  Check(!AreSame(all.at("Airlight"), none.at("Airlight")), "the air has shadows");
}

//------------------------------------------------------------------------------
// What VTK writes over the scene stays white, however thick the fog.
void TestOverlay()
{
  Scene scene;
  scene.Medium->SetScattering(1, 1, 1);
  scene.Medium->SetAbsorption(1, 1, 1);
  vtkNew<vtkTextActor> text;
  text->SetInput("Airlight");
  text->GetTextProperty()->SetFontSize(30);
  text->SetPosition(20, 50);
  scene.Renderer->AddViewProp(text);
  AddBodies(scene);
  scene.AddPointLight({ 3, 4, 2 });
  scene.Renderer->SetPass(nullptr);
  vtkActorCollection* bodies = scene.Renderer->GetActors();
  bodies->InitTraversal();
  while (vtkActor* body = bodies->GetNextActor())
  {
    body->GetProperty()->SetColor(0, 0, 0);
  }
  const Picture plain = Capture(scene.Window);
  scene.Renderer->SetPass(scene.Pass);
  const Picture fog = Capture(scene.Window);
  int white = 0;
  int same = 0;
  for (size_t i = 0; i < plain.size(); ++i)
  {
    white += plain[i] == 255;
    same += plain[i] == 255 && fog[i] == 255;
  }
  std::cout << "overlay: " << same << " of " << white << " white values stay white\n";
  Check(white > 300 && same == white, "text is not fogged");
}

//------------------------------------------------------------------------------
void TestMedia()
{
  vtkNew<vtkAirlightPass> pass;
  vtkNew<vtkParticipatingMedium> a;
  vtkNew<vtkParticipatingMedium> b;
  pass->AddMedium(nullptr);
  Check(pass->GetNumberOfMedia() == 0, "null is ignored");
  pass->AddMedium(a);
  pass->AddMedium(b);
  pass->AddMedium(a);
  Check(pass->GetNumberOfMedia() == 2, "a medium is added once");
  Check(pass->GetMedium(0) == a && pass->GetMedium(1) == b, "media keep their order");
  vtkMTimeType time = pass->GetMTime();
  b->SetMeanFreePath(3.0);
  Check(pass->GetMTime() > time, "a medium's change is the pass's");
  time = pass->GetMTime();
  pass->RemoveMedium(a);
  pass->RemoveMedium(a);
  Check(pass->GetNumberOfMedia() == 1 && pass->GetMedium(0) == b, "a medium is removed");
  Check(pass->GetMTime() > time, "removal modifies the pass");
  pass->SetMedium(a);
  Check(pass->GetNumberOfMedia() == 1 && pass->GetMedium(0) == a, "SetMedium() replaces");
  time = pass->GetMTime();
  pass->SetMedium(a);
  Check(pass->GetMTime() == time, "setting the same medium changes nothing");
  pass->SetMedium(nullptr);
  Check(pass->GetNumberOfMedia() == 0, "SetMedium(nullptr) leaves none");
  Check(pass->GetBuffer("Airlight") == nullptr, "no buffer before the first frame");
}

//------------------------------------------------------------------------------
void TestOddScenes()
{
  Scene empty;
  CheckFinite(empty.Render(), "empty renderer");
  empty.AddPointLight({ 1, 1, 1 });
  CheckFinite(empty.Render(), "a light and nothing else");
  Check(GetValue(empty.GetBuffer("Airlight"), 100, 75) > 0.0, "empty air is lit");
  Check(GetValue(empty.GetBuffer("Depth"), 100, 75) == -1.0, "no depth without a surface");
  Check(empty.GetBuffer("Nothing") == nullptr, "no buffer of an unknown name");

  Scene scene;
  AddBodies(scene);
  scene.AddPointLight({ 3, 4, 2 });
  scene.Pass->TranslucentShadowsOff();
  const Buffers before = scene.Render();
  // In front of the floor: before the background it would be fogged as the background is.
  scene.Add(MakeSphere(1.2), [](vtkActor* actor) { actor->SetPosition(1, -0.5, 4); })
    ->GetProperty()
    ->SetOpacity(0.4);
  const Buffers after = scene.Render();
  CheckFinite(after, "translucent actor");
  Check(AreSame(before.at("Airlight"), after.at("Airlight")),
    "translucent actors cast nothing where they shall not");
  Check(!AreSame(before.at("Radiance"), after.at("Radiance")), "translucent actors are drawn");
}

//------------------------------------------------------------------------------
// Tilted boards side by side from near to far, at a clipping range of 1 to 1e5.
void TestDepthRange()
{
  Scene scene;
  scene.Look({ 0, 0, 0 }, { 0, 0, -1 });
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, 5e4);
  scene.Medium->SetScattering(1e-4, 1e-4, 1e-4);
  scene.Medium->SetAbsorption(0, 0, 0);
  scene.AddPointLight({ 10, 1, -30 });
  for (int i = 0; i < 9; ++i)
  {
    // Each covers a ninth of the view's width, at 0.7 to 32 000 units.
    const double d = 0.7 * std::pow(3.8, i);
    const double left = 0.13 * (i - 4.5);
    scene.Add(MakeSoup({ { d * glm::dvec3(left, -0.4, -1.1), d * glm::dvec3(left + 0.12, -0.4, -1),
      d * glm::dvec3(left + 0.06, 0.4, -1.3) } }));
  }
  scene.Window->Render();
  Errors depth;
  double nearest = Infinity;
  double farthest = 0.0;
  for (int y = 0; y < scene.Height; y += 2)
  {
    for (int x = 0; x < scene.Width; ++x)
    {
      const Answer answer = scene.GetAnswer(x + 0.5, y + 0.5);
      if (answer.Depth > 0.0 && !IsUnstable(scene, x + 0.5, y + 0.5, answer, 1.0))
      {
        depth.Add(glm::dvec3(GetValue(scene.GetBuffer("Depth"), x, y)), glm::dvec3(answer.Depth));
        nearest = std::min(nearest, answer.Depth);
        farthest = std::max(farthest, answer.Depth);
      }
    }
  }
  std::cout << "clipping range 1 to 1e5: depths " << nearest << " to " << farthest << "\n";
  Check(nearest < 1.0 && farthest > 2e4, "boards are seen near and far");
  depth.Report("clipping range 1 to 1e5", "Depth", 1e-6, 1e-5);
}
}

//------------------------------------------------------------------------------
int TestAirlightPass(int, char*[])
{
  TestBackground();
  TestDepthWrittenBack();
  TestCastsShadow();
  TestSurfaceShadows();
  TestOverlay();
  TestMedia();
  TestOddScenes();
  TestDepthRange();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
