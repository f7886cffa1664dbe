// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the pass shows: its debug views, against the recorded buffers, and colours that are encoded
// for display (SetLinearInput()), against decoding and encoding by hand.

#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"

#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"

#include <array>
#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
constexpr int Shadings = 256;

void AddBodies(Scene& scene)
{
  scene.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-8, 8, -2.6, -2.5, -8, 6);
  scene.Add(floor);
  scene.Add(MakeSphere(1.0), [](vtkActor* actor) { actor->SetPosition(-1.5, 0, 0.3); });
}

// Compares a picture with what `expected` says of each pixel, up to one step of 255.
void ComparePicture(
  const std::string& name, Scene& scene, const std::function<glm::dvec3(int x, int y)>& expected)
{
  const Picture picture = Capture(scene.Window);
  int worst = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const glm::dvec3 colour = expected(i % scene.Width, i / scene.Width);
    for (int k = 0; k < 3; ++k)
    {
      const double value = std::min(std::max(colour[k], 0.0), 1.0) * (Shadings - 1);
      worst =
        std::max(worst, static_cast<int>(std::ceil(std::abs(picture[3 * i + k] - value) - 0.5)));
    }
  }
  std::cout << name << ": within " << worst << "/255\n";
  Check(worst <= 1, name);
}

//------------------------------------------------------------------------------
void TestViews()
{
  Scene scene;
  AddBodies(scene);
  const Picture shaded = Capture(scene.Window);
  const auto airlight = [&](int x, int y) { return GetColour(scene.GetBuffer("Airlight"), x, y); };
  scene.Pass->SetDebugViewToAirlightOnly();
  ComparePicture("airlight only", scene, airlight);

  scene.Pass->SetDebugViewToBoundaryCount();
  int most = 0;
  ComparePicture("boundary count", scene, [&](int x, int y) {
    const double count = GetValue(scene.GetBuffer("BoundaryCount"), x, y);
    most = std::max(most, static_cast<int>(count));
    // Three ramps one after the other, of the logarithm: 255 is the end of the last one.
    const double heat = 3.0 * std::log2(1.0 + count) / std::log2(256.0);
    return glm::dvec3(heat, heat - 1.0, heat - 2.0);
  });
  Check(most > 1, "some rays cross shadow planes");
  // Also where nothing is recorded.
  scene.Pass->RecordBuffersOff();
  const Picture counts = Capture(scene.Window);
  scene.Pass->RecordBuffersOn();
  Check(Compare(counts, Capture(scene.Window)) == 0, "counts without recording");

  scene.Pass->SetDebugViewToShadowPlanes();
  const Picture outlines = Capture(scene.Window);
  const std::array<std::array<int, 3>, 2> colours = { { { 255, 64, 38 }, { 64, 128, 255 } } };
  int found[2] = { 0, 0 };
  int others = 0;
  for (size_t i = 0; i < outlines.size(); i += 3)
  {
    for (int k = 0; k < 2; ++k)
    {
      found[k] += std::equal(colours[k].begin(), colours[k].end(), outlines.begin() + i,
        [](int a, int b) { return std::abs(a - b) <= 1; });
    }
    others += std::equal(outlines.begin() + i, outlines.begin() + i + 3, shaded.begin() + i);
  }
  std::cout << "outlines: " << found[0] << " red and " << found[1] << " blue pixels\n";
  Check(found[0] > 100 && found[1] > 100, "planes that the view enters and leaves");
  Check(found[0] + found[1] + others >= scene.Width * scene.Height, "the picture beside outlines");

  scene.Pass->SetDebugViewToShaded();
  Check(Compare(shaded, Capture(scene.Window)) == 0, "back to the picture");
  ErrorListener errors(scene.Pass);
  scene.Pass->SetDebugView(17);
  Check(errors.Take() == 1 && errors.GetText().find("17") != std::string::npos,
    "a debug view that is none: " + errors.GetText());
  Check(scene.Pass->GetDebugView() == vtkAirlightPass::SHADED, "the old view stays");
}

//------------------------------------------------------------------------------
glm::dvec3 Decode(const glm::dvec3& colour) { return glm::pow(colour, glm::dvec3(2.2)); }

void TestEncoded()
{
  Scene scene;
  AddBodies(scene);
  scene.Renderer->SetBackground(0.3, 0.5, 0.7);
  vtkActor* actor = scene.Renderer->GetActors()->GetLastActor();
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetRoughness(0.7);
  vtkNew<vtkParticipatingMedium> clear;
  clear->SetScattering(0.0, 0.0, 0.0);
  clear->SetAbsorption(0.0, 0.0, 0.0);
  scene.Pass->SetMedium(clear);
  const Picture linear = Capture(scene.Window);
  // The scene's own colours, as VTK's shading encodes them; attenuated light is the pass's matter.
  scene.Pass->SetLinearInput(false);
  const Picture encoded = Capture(scene.Window);
  std::cout << "clear medium: within " << Compare(linear, encoded) << "/255\n";
  Check(Compare(linear, encoded) <= 1, "a clear medium leaves encoded colours as they are");

  scene.Pass->SetMedium(scene.Medium);
  scene.Medium->SetScattering(0.03, 0.04, 0.05);
  scene.Pass->SetLinearInput(false);
  ComparePicture("background in fog, encoded", scene, [&](int x, int y) {
    const glm::dvec3 radiance = GetColour(scene.GetBuffer("Radiance"), x, y);
    return glm::pow(glm::max(radiance, glm::dvec3(0.0)), glm::dvec3(1.0 / 2.2));
  });
  int sky = 0;
  double worst = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    if (GetValue(scene.GetBuffer("Depth"), x, y) < 0.0)
    {
      const glm::dvec3 expected = GetColour(scene.GetBuffer("Airlight"), x, y) +
        GetColour(scene.GetBuffer("Transmittance"), x, y) * Decode({ 0.3, 0.5, 0.7 });
      const glm::dvec3 error = glm::abs(GetColour(scene.GetBuffer("Radiance"), x, y) - expected);
      worst = std::max({ worst, error.x, error.y, error.z });
      ++sky;
    }
  }
  std::cout << "decoded background: " << worst << "\n";
  Check(sky > 1000 && worst < 1e-6, "the background is decoded before the medium is put before it");
}

//------------------------------------------------------------------------------
// A translucent pane in clear air, decoded, blended and encoded.
void TestEncodedLayer()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 3 });
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  scene.Renderer->SetBackground(0.3, 0.5, 0.7);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-30, -30, 0);
  plane->SetPoint1(30, -30, 0);
  plane->SetPoint2(-30, 30, 0);
  vtkActor* pane = scene.Add(plane);
  pane->GetProperty()->SetLighting(false);
  pane->GetProperty()->SetColor(0.9, 0.4, 0.2);
  pane->GetProperty()->SetOpacity(0.4);
  scene.Pass->SetLinearInput(false);
  ComparePicture("encoded pane", scene, [](int, int) {
    const glm::dvec3 blended = glm::mix(Decode({ 0.3, 0.5, 0.7 }), Decode({ 0.9, 0.4, 0.2 }), 0.4);
    return glm::pow(blended, glm::dvec3(1.0 / 2.2));
  });
}
}

//------------------------------------------------------------------------------
int TestDisplay(int, char*[])
{
  TestViews();
  TestEncoded();
  TestEncodedLayer();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
