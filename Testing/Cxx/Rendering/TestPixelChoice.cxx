// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetPixelChooser(): it gets the depths of the opaque surfaces; the pixels that it
// leaves out are empty, the others are those of a frame that draws all, with every technique.

#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkFloatArray.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Width = 121; // whose rows of bytes end anywhere
constexpr int Height = 90;

using Change = std::function<void(WindowScene&)>;

struct Shown
{
  std::vector<unsigned char> Colours; // RGBA
  std::vector<float> Depths;
};

Shown Show(Scene& scene)
{
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkFloatArray> depths;
  scene.Window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 0, colours);
  scene.Window->GetZbufferData(0, 0, Width - 1, Height - 1, depths);
  return { { colours->GetPointer(0), colours->GetPointer(0) + colours->GetNumberOfValues() },
    { depths->GetPointer(0), depths->GetPointer(0) + depths->GetNumberOfValues() } };
}

using Pattern = std::function<bool(int x, int y)>;

// Blocks of pixels that begin where no other pattern does.
bool IsInBlocks(int x, int y) { return (x / 7 + y / 5) % 3 != 0; }

// A part of the picture with some of all bodies, their shadows and the background.
bool IsInside(int x, int y) { return x > 31 && x < 97 && y > 22 && y < 71; }

void Prepare(WindowScene& scene, const Change& change)
{
  scene.Window->SetAlphaBitPlanes(1);
  scene.Renderer->SetBackground(0.2, 0.3, 0.4);
  scene.Pass->RecordBuffersOff();
  scene.Pass->DitheringOff();
  scene.Medium->SetScattering(0.05, 0.06, 0.07);
  change(scene);
}

//------------------------------------------------------------------------------
void TestChoice(const std::string& name, const Change& change, const Pattern& isDrawn = IsInBlocks)
{
  WindowScene scene(Width, Height, 2);
  Prepare(scene, change);
  const Shown all = Show(scene);
  int calls = 0;
  double farthest = 0.0;
  scene.Pass->SetPixelChooser(
    [&](int width, int height, const float* depths, unsigned char* drawn) {
      ++calls;
      Check(width == Width && height == Height, name + ": the size of the picture");
      for (int i = 0; i < width * height; ++i)
      {
        farthest = std::max(farthest, std::abs(static_cast<double>(depths[i]) - all.Depths[i]));
        Check(drawn[i] == 1, name + ": all are drawn at first");
        drawn[i] = isDrawn(i % Width, i / Width) ? 1 : 0;
      }
      return true;
    });
  const Shown some = Show(scene);
  int differing = 0;
  int left = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const unsigned char* a = &all.Colours[4 * i];
    const unsigned char* b = &some.Colours[4 * i];
    if (isDrawn(i % Width, i / Width))
    {
      differing += !std::equal(a, a + 4, b) || all.Depths[i] != some.Depths[i];
    }
    else
    {
      const bool empty = b[0] == 0 && b[1] == 0 && b[2] == 0 && b[3] == 0;
      left += !empty || some.Depths[i] != 1.0f;
    }
  }
  std::cout << name << ": depths differ by " << farthest << ", " << differing << " pixels differ, "
            << left << " of those left out are not empty\n";
  Check(calls == 1, name + ": asked once a frame");
  Check(farthest <= 1.0 / (1 << 23), name + ": the depths are those of the picture");
  Check(differing == 0, name + ": what is drawn is as in a whole picture");
  Check(left == 0, name + ": what is left out is empty");

  scene.Pass->SetPixelChooser([](int, int, const float*, unsigned char* drawn) {
    std::fill(drawn, drawn + Width * Height, 0);
    return false;
  });
  Check(Show(scene).Colours == all.Colours, name + ": false draws all");
  scene.Pass->SetPixelChooser(nullptr);
  Check(Show(scene).Colours == all.Colours, name + ": without a chooser all are drawn");
}

// Frames that draw all pixels do not ask.
void TestIgnored(const std::string& name, const Change& change)
{
  WindowScene scene(Width, Height);
  Prepare(scene, change);
  const Shown all = Show(scene);
  scene.Pass->SetPixelChooser([&](int, int, const float*, unsigned char* drawn) {
    Check(false, name + ": the chooser is not called");
    std::fill(drawn, drawn + Width * Height, 0);
    return true;
  });
  Check(Show(scene).Colours == all.Colours, name + ": all pixels are drawn");
}
}

//------------------------------------------------------------------------------
int TestPixelChoice(int, char*[])
{
  TestChoice("planes", [](WindowScene& s) { s.Pass->SetShadowTechniqueToShadowPlanes(); });
  TestChoice("maps", [](WindowScene& s) { s.Pass->SetShadowTechniqueToShadowMap(); });
  TestChoice("march", [](WindowScene& s) { s.Pass->SetShadowTechniqueToRayMarch(); });
  TestChoice(
    "a part, planes", [](WindowScene&) {}, IsInside);
  TestChoice(
    "a part, maps", [](WindowScene& s) { s.Pass->SetShadowTechniqueToShadowMap(); }, IsInside);
  TestChoice(
    "nothing", [](WindowScene&) {}, [](int, int) { return false; });
  TestChoice("no shadows", [](WindowScene& s) { s.Pass->SetShadowTechniqueToNone(); });
  TestChoice("Mie", [](WindowScene& s) { s.Medium->SetPhaseFunctionToMieMurky(); });
  TestChoice("height fog", [](WindowScene& s) {
    s.Medium->SetRegionToUnbounded();
    s.Medium->SetDensityToExponentialHeight();
  });
  TestChoice("wireframe", [](WindowScene& s) {
    s.Cube->GetProperty()->SetRepresentationToWireframe();
    s.Ball->GetProperty()->SetColor(1.0, 0.5, 0.2);
  });
  TestIgnored("translucent", [](WindowScene& s) { s.Ball->GetProperty()->SetOpacity(0.5); });
  TestIgnored("frames of a mean", [](WindowScene& s) { s.Pass->SetSubpixelFrames(2); });
  TestIgnored("exposure", [](WindowScene& s) { s.Pass->AutomaticExposureOn(); });
  TestIgnored("buffers", [](WindowScene& s) { s.Pass->RecordBuffersOn(); });
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
