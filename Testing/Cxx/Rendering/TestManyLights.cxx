// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// More lights than anyone uses: 64 of all kinds, each with its shadows, light what they light one
// by one, without a word; more than can cast shadows on surfaces get a warning, and the air is
// right. Lights without shadows, of which several are drawn at once unless buffers are recorded,
// give the same picture.

#include "AirlightTestBodies.h"
#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkActorCollection.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Point lights, spots and directional lights in turn, around two bodies on a floor in a box of fog.
void Fill(Scene& scene, int lights)
{
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-6, 6, -2.6, 6, -6, 6);
  AddClosedBodies(scene);
  Random random(64);
  const auto colour = [&] {
    return glm::dvec3(random.Uniform(0.1, 2.0), random.Uniform(0.1, 2.0), random.Uniform(0.1, 2.0));
  };
  for (int k = 0; k < lights; ++k)
  {
    const glm::dvec3 place(
      random.Uniform(-5.0, 5.0), random.Uniform(1.5, 5.0), random.Uniform(-5.0, 5.0));
    if (k % 3 == 2)
    {
      scene.AddDirectionalLight(place, 0.05 * colour());
      continue;
    }
    vtkLight* light = scene.AddPointLight(place, colour());
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPositional(true);
    light->SetConeAngle(k % 3 == 1 ? 25.0 : 90.0);
  }
}

void SwitchOnOnly(Scene& scene, size_t index)
{
  for (size_t k = 0; k < scene.Lights.size(); ++k)
  {
    scene.Lights[k]->SetSwitch(k == index);
  }
}

std::vector<double> Read(Scene& scene, const char* name)
{
  std::vector<double> values;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const glm::dvec3 colour = GetColour(scene.GetBuffer(name), i % scene.Width, i / scene.Width);
    values.insert(values.end(), { colour.x, colour.y, colour.z });
  }
  return values;
}

// Sums of 64 single-precision numbers: each of 64 additions rounds by 6e-8.
void Compare(const std::vector<double>& sum, const std::vector<double>& all, Comparison& comparison)
{
  for (size_t i = 0; i < all.size(); ++i)
  {
    comparison.Add(std::abs(all[i] - sum[i]), 1e-5 * sum[i] + 1e-12,
      [&] { return Text("value ", i, ": expected ", sum[i], ", got ", all[i]); });
  }
}

//------------------------------------------------------------------------------
// Drivers take their time over shaders with many lights: where surfaces are not compared, they are
// unlit.
bool TestSum(int lights, bool surfaces)
{
  Scene scene(80, 60);
  Fill(scene, lights);
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetProperty()->SetLighting(surfaces);
  }
  ErrorListener errors(scene.Pass);
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  const char* const names[] = { "Airlight", "Surface" };
  scene.Window->Render();
  const std::vector<double> all[2] = { Read(scene, names[0]), Read(scene, names[1]) };
  Check(errors.Take() == 0, Text(lights, " lights are no error"));
  Check(warnings.Take() == (surfaces ? 0 : 1),
    Text(lights, " lights: ", surfaces ? "no warning" : "one warning"));
  Check(surfaces || warnings.GetText().find(Text(lights, " lights")) != std::string::npos,
    "the warning names the number of lights: " + warnings.GetText());
  const std::string last = Text("Airlight:", lights - 1);
  Check(scene.GetBuffer(last.c_str()) != nullptr, "there is a buffer " + last);

  std::vector<double> sums[2];
  int shadowed = 0;
  for (int k = 0; k < lights; ++k)
  {
    SwitchOnOnly(scene, k);
    scene.Window->Render();
    for (int i = 0; i < 2; ++i)
    {
      const std::vector<double> one = Read(scene, names[i]);
      sums[i].resize(one.size());
      for (size_t j = 0; j < one.size(); ++j)
      {
        sums[i][j] += one[j];
      }
    }
    shadowed += GetValue(scene.GetBuffer("BoundaryCount"), 40, 25) > 0.0;
  }
  Check(shadowed > lights / 4, Text(shadowed, " lights have shadows on the ray in the middle"));
  Comparison airlight(Text(lights, " lights together and one by one, Airlight"));
  Comparison surface(Text(lights, " lights together and one by one, Surface"));
  Compare(sums[0], all[0], airlight);
  Compare(sums[1], all[1], surface);
  return surfaces ? AllOk({ &airlight, &surface }) : AllOk({ &airlight });
}

//------------------------------------------------------------------------------
// The picture with buffers, in which each light is drawn alone, and without.
void TestTogether(const std::string& name, int technique, bool casts)
{
  Scene scene(80, 60);
  Fill(scene, 40); // more than have their bits in one channel
  scene.Pass->SetShadowTechnique(technique);
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    vtkAirlightPass::SetCastsShadow(actor, casts);
  }
  scene.Pass->RecordBuffersOn();
  const Picture alone = Capture(scene.Window);
  scene.Pass->RecordBuffersOff();
  const Picture together = Capture(scene.Window);
  Check(airlight_test::Compare(alone, together) <= 1,
    name + ": the same picture with lights alone and together");
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  Check(airlight_test::Compare(Capture(scene.Window), together) > 20,
    name + ": their light is in the air");
}
}

//------------------------------------------------------------------------------
int TestManyLights(int, char*[])
{
  const bool many = TestSum(64, true);
  const bool tooMany = TestSum(100, false);
  TestTogether("no shadows", vtkAirlightPass::NONE, true);
  TestTogether("shadow planes", vtkAirlightPass::SHADOW_PLANES, true);
  TestTogether("shadow maps without casters", vtkAirlightPass::SHADOW_MAP, false);
  TestTogether("shadow planes without casters", vtkAirlightPass::SHADOW_PLANES, false);
  return many && tooMany && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
