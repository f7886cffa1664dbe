// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent surfaces that are both seen and cast: the shadows of others on them and in the air
// before them, none of their own on their lit side, their own on the far side. Against brute force.
// And what switches their shadows on and off.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const glm::dvec3 Red(0.1, 0.8, 0.9);
const glm::dvec3 Blue(0.7, 0.5, 0.05);

// What a white translucent surface, made of the triangles from `first` on, is blended as.
Answer GetLayer(Scene& scene, size_t first, size_t last, double px, double py)
{
  const std::vector<Triangle> triangles = scene.Triangles;
  for (size_t i = 0; i < triangles.size(); ++i)
  {
    scene.Triangles[i].Stops = scene.Triangles[i].Stops || (i >= first && i < last);
  }
  const Answer answer = scene.GetAnswer(px, py);
  scene.Triangles = triangles;
  return answer;
}

// Whether brute force itself cannot decide, for the surface is seen through an edge.
bool IsUnsure(Scene& scene, size_t first, size_t last, double px, double py, const Answer& answer)
{
  for (int i = 0; i < 4; ++i)
  {
    const Answer other =
      GetLayer(scene, first, last, px + (i % 2 == 0 ? -0.05 : 0.05), py + (i < 2 ? -0.05 : 0.05));
    for (int k = 0; k < 3; ++k)
    {
      if (Differ(answer.Airlight[k], other.Airlight[k], 1e-3) ||
        Differ(answer.Surface[k], other.Surface[k], 1e-3))
      {
        return true;
      }
    }
    if (Differ(answer.Depth, other.Depth, 0.0))
    {
      return true;
    }
  }
  return false;
}

// The picture where a single translucent surface is seen, of opacity 1/2. `first` and `last` tell
// its triangles.
void CompareLayer(const std::string& name, Scene& scene, size_t first, size_t last)
{
  const Buffers buffers = scene.Render();
  Random random(9);
  Errors radiance;
  int unsure = 0;
  int seen = 0;
  const int rays = 1500;
  for (int i = 0; i < rays; ++i)
  {
    const int x = random.Index(scene.Width);
    const int y = random.Index(scene.Height);
    const Answer behind = scene.GetAnswer(x + 0.5, y + 0.5);
    const Answer layer = GetLayer(scene, first, last, x + 0.5, y + 0.5);
    if (layer.Depth == behind.Depth)
    {
      continue; // not seen here, or behind something
    }
    if (IsUnsure(scene, first, last, x + 0.5, y + 0.5, layer) ||
      IsUnstable(scene, x + 0.5, y + 0.5, behind, 1e-3 * behind.Unshadowed.x))
    {
      ++unsure;
      continue;
    }
    ++seen;
    const glm::dvec3 expected =
      0.5 * (behind.Airlight + behind.Surface) + 0.5 * (layer.Airlight + layer.Surface);
    radiance.Add(GetColour(buffers.at("Radiance"), x, y), expected);
  }
  std::cout << name << ": " << unsure << " rays excluded\n";
  Check(unsure < MostExcluded * rays, name + ": too many rays are excluded");
  Check(seen > 100, name + ": the surface is seen");
  radiance.Report(name, "Radiance", 2.5e-6, 2e-5);
}

//------------------------------------------------------------------------------
// A pane that everything else casts its shadow on, lit from before and from behind.
void TestPane(Scene& scene)
{
  for (const double z : { 6.0, -4.0 })
  {
    ResetToFloorAndBall(scene);
    scene.AddPointLight({ 1.5, 3, z }, { 8.0, 6.0, 4.0 });
    const glm::dvec3 pane(0.5, 0.5, 0.5);
    const size_t first = scene.Triangles.size();
    AddGlass(scene, MakeSheet({ -4, -1.9, 0 }, { 8, 0, 0.3 }, { 0, 5, -0.5 }), pane);
    const size_t last = scene.Triangles.size();
    // Not seen before the pane from here, nor behind it, but in the light.
    AddGlass(scene, MakeSheet({ -1, 4.5, 0.5 * z }, { 3, 0, 0 }, { 0, 2, 0 }), Red);
    AddGlass(scene, MakeSheet({ 0, 4.8, 0.6 * z }, { 3, 0, 0 }, { 0, 2, 0 }), Blue);
    for (double height = 2.5; height < 9.0; height += 6.0)
    {
      scene.Lights[0]->SetPosition(1.5, height, z);
      CompareLayer(Text("pane, light at ", height, ", ", z), scene, first, last);
    }
  }
}

// Whether lights reach a layer is kept in words of 32 lights each: of the first two, one light each
// shines. Drivers take their time over shaders with many lights.
void TestManyLights(Scene& scene)
{
  ResetToFloorAndBall(scene);
  const glm::dvec3 places[] = { { 1.5, 3, 6 }, { -2.5, 4, 5 } };
  for (int k = 0; k < 34; ++k)
  {
    const bool shines = k == 7 || k == 33;
    scene.AddPointLight(places[k / 32], shines ? glm::dvec3(8.0, 6.0, 4.0) : glm::dvec3(0.0));
  }
  const size_t first = scene.Triangles.size();
  AddGlass(scene, MakeSheet({ -4, -1.9, 0 }, { 8, 0, 0.3 }, { 0, 5, -0.5 }), glm::dvec3(0.5));
  const size_t last = scene.Triangles.size();
  // Between the pane and each light, above the picture.
  for (const glm::dvec3& place : places)
  {
    scene.Add(MakeSphere(0.35), [&](vtkActor* actor) {
      actor->SetPosition(0.5 * place.x - 0.4, 0.5 * place.y + 0.3, 0.5 * place.z);
    });
  }
  CompareLayer("pane in the light of lights 7 and 33", scene, first, last);
}

// A triangle strip seen at all angles, down to the grazing ones: no acne.
void TestSlopes(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 3, 5, 4 }, { 8.0, 6.0, 4.0 });
  const size_t first = scene.Triangles.size();
  AddGlass(scene, MakeSheet({ -6, 0.4, -30 }, { 12, 0, 0 }, { 0, 0.1, 38 }), Red);
  const size_t last = scene.Triangles.size();
  scene.Look({ 0, 3, 10 }, { 0, 0, 0 });
  CompareLayer("sheet seen from above, lit from above", scene, first, last);
  scene.Look({ 0, 0.65, 10 }, { 0, 0.5, -4 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(3.0);
  CompareLayer("sheet seen at a grazing angle", scene, first, last);
  scene.Look({ 0, -1.5, 10 }, { 0, 0, 0 });
  CompareLayer("sheet seen from below, lit from above", scene, first, last);
}

//------------------------------------------------------------------------------
// Each way to have no shadow gives the same bits; each change shows at once.
void TestSwitches(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 1, 4.5, 1 }, { 8.0, 6.0, 4.0 });
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  head->SetIntensity(0.1);
  scene.AddLight(head);
  scene.Pass->SetLightScatters(head, true);
  vtkActor* pane = AddGlass(scene, MakeSheet({ -2.5, 1.5, -1 }, { 3, 0, 0 }, { 0, 0, 3 }), Red);
  const Buffers coloured = scene.Render();
  const auto headlight = vtkSmartPointer<vtkImageData>::New();
  headlight->DeepCopy(scene.GetBuffer("Airlight:1"));

  scene.Pass->TranslucentShadowsOff();
  const Buffers off = scene.Render();
  Check(!AreSame(coloured.at("Airlight"), off.at("Airlight")), "the pane has a shadow in the air");
  Check(!AreSame(coloured.at("Surface"), off.at("Surface")), "the pane has a shadow on surfaces");
  Check(AreSame(headlight, scene.GetBuffer("Airlight:1")), "headlights are not dimmed");
  scene.Pass->TranslucentShadowsOn();
  CheckSame(coloured, scene.Render(), "switched on again");

  SetShadowOpacity(pane, glm::dvec3(0.0));
  CheckSame(off, scene.Render(), "opacity 0");
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  keys->Set(vtkAirlightPass::SHADOW_OPACITY(), 0.1, 0.8, 0.9);
  pane->SetPropertyKeys(keys);
  CheckSame(off, scene.Render(), "CASTS_SHADOW wins");

  // Without a key the property's opacity is that of all channels.
  pane->SetPropertyKeys(nullptr);
  const Buffers plain = scene.Render();
  SetShadowOpacity(pane, glm::dvec3(0.5));
  CheckSame(plain, scene.Render(), "a key that says what the property does");
  pane->SetPropertyKeys(nullptr);
  pane->GetProperty()->SetOpacity(0.25);
  const Buffers fainter = scene.Render();
  Check(!AreSame(plain.at("Airlight"), fainter.at("Airlight")), "another opacity shows");
  pane->GetProperty()->SetOpacity(0.5);
  CheckSame(plain, scene.Render(), "the first opacity again");
  scene.Pass->SurfaceShadowsOff();
  const Buffers air = scene.Render();
  Check(AreSame(air.at("Airlight"), plain.at("Airlight")), "the air without shadows on surfaces");
  Check(AreSame(air.at("Surface"), off.at("Surface")) ||
      !AreSame(air.at("Surface"), plain.at("Surface")),
    "surfaces without shadows");
  scene.Pass->SurfaceShadowsOn();

  // Translucent by what varies over the surface: no shadow but by key.
  pane->GetProperty()->SetOpacity(1.0);
  pane->ForceTranslucentOn();
  Check(AreSame(off.at("Airlight"), scene.Render().at("Airlight")), "translucent without opacity");
  SetShadowOpacity(pane, Red);
  Check(AreSame(coloured.at("Airlight"), scene.Render().at("Airlight")), "and with a key");
}

// Peeled, to 8 bits rounded twice, and order-independent translucency show the same single layer.
void TestPeeling(Scene& scene)
{
  ResetToFloorAndBall(scene);
  scene.AddPointLight({ 1, 4.5, 1 }, { 8.0, 6.0, 4.0 });
  AddGlass(scene, MakeSheet({ -2.5, 1.5, -1 }, { 3, 0, 0 }, { 0, 0, 3 }), Red);
  const Buffers independent = scene.Render();
  scene.Renderer->UseDepthPeelingOn();
  const Buffers peeled = scene.Render();
  double largest = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const glm::dvec3 difference = glm::abs(
      GetColour(independent.at("Radiance"), x, y) - GetColour(peeled.at("Radiance"), x, y));
    largest = std::max({ largest, difference.x, difference.y, difference.z });
  }
  std::cout << "peeled and order-independent: " << largest << " apart\n";
  Check(largest < 6e-3, "peeled as order-independent");
  Check(AreSame(independent.at("Airlight"), peeled.at("Airlight")), "the same airlight");
}
}

//------------------------------------------------------------------------------
int TestTranslucentShadowLayers(int, char*[])
{
  Scene scene;
  scene.Window->SetAlphaBitPlanes(1);
  TestPane(scene);
  TestManyLights(scene);
  TestSlopes(scene);
  TestSwitches(scene);
  TestPeeling(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
