// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetMultisampling(): edges of surfaces and of shadows come closer to the mean over
// each pixel, here of 256 pictures of cameras that the test moves; all other pixels are those of a
// picture without; and it is without effect where the window or the user asks for something else.

#include "AirlightTestEdges.h"
#include "AirlightTestMeans.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkRenderStepsPass.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Width = 96;
constexpr int Height = 72;

void SetSmooth(Scene& scene, bool smooth)
{
  scene.Window->SetMultiSamples(smooth ? 4 : 0);
  scene.Pass->SetMultisampling(smooth);
}

Picture CaptureSmooth(Scene& scene)
{
  SetSmooth(scene, true);
  Picture picture = Capture(scene.Window);
  SetSmooth(scene, false);
  return picture;
}

int CountDifferences(const Picture& a, const Picture& b)
{
  int count = a.size() == b.size() ? 0 : 1;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    count += a[i] != b[i] ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
// The largest step of a channel between a pixel and its four neighbours.
int GetContrast(const Picture& picture, int x, int y)
{
  int most = 0;
  const int neighbours[4][2] = { { x + 1, y }, { x - 1, y }, { x, y + 1 }, { x, y - 1 } };
  for (const auto& neighbour : neighbours)
  {
    const int nx = std::clamp(neighbour[0], 0, Width - 1);
    const int ny = std::clamp(neighbour[1], 0, Height - 1);
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(
        most, std::abs(picture[3 * (Width * y + x) + c] - picture[3 * (Width * ny + nx) + c]));
    }
  }
  return most;
}

// An edge is a step of more than 3 of 255; dithering and rounding may take two of it.
void CheckOthers(const std::string& name, const Picture& one, const Picture& smooth)
{
  int changed = 0;
  int others = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const bool same = std::equal(&one[3 * i], &one[3 * i] + 3, &smooth[3 * i]);
    changed += same ? 0 : 1;
    others += !same && GetContrast(one, i % Width, i / Width) < 1 ? 1 : 0;
  }
  Check(changed > 70, Text(name, ": edges have changed: ", changed));
  Check(changed < Width * Height / 4, Text(name, ": and little else: ", changed));
  Check(others == 0, Text(name, ": pixels that are no edges have changed: ", others));
}

//------------------------------------------------------------------------------
// Of four places, with one in the middle, 0.39 of one frame's error is the least at straight edges.
void CheckEdges(const std::string& name, WindowScene& scene, double goal = 0.5)
{
  const Picture one = Capture(scene.Window);
  Check(*std::max_element(one.begin(), one.end()) < 255, name + ": nothing is cut off at white");
  const Means expected = AverageByHand(scene.Window, scene.Renderer);
  const Picture smooth = CaptureSmooth(scene);
  const double first = GetEdgeError(expected, one, one);
  const double error = GetEdgeError(expected, one, smooth);
  std::cout << name << ": one frame is off by " << first << " / 255, four samples by " << error
            << "\n";
  Check(error < goal * first, Text(name, ": error of four samples"));
  CheckOthers(name, one, smooth);
  Check(CaptureSmooth(scene) == smooth, name + ": the same each time");
  Check(Capture(scene.Window) == one, name + ": one frame as before");
  double center[2];
  scene.Renderer->GetActiveCamera()->GetWindowCenter(center);
  Check(center[0] == 0.0 && center[1] == 0.0, name + ": the camera is where it was");
}

void TestEdges()
{
  WindowScene scene(Width, Height, 1);
  scene.Pass->RecordBuffersOff();
  HideLamp(scene);
  CheckEdges("opaque", scene);
  const Picture smooth = CaptureSmooth(scene);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Pass->SetDelegatePass(steps);
  Check(CountDifferences(CaptureSmooth(scene), smooth) == 0, "a delegate draws the same");
  scene.Pass->SetDelegatePass(nullptr);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  CheckEdges("parallel", scene);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Ball->GetProperty()->SetOpacity(0.5);
  CheckEdges("translucent", scene);
  scene.Ball->GetProperty()->SetOpacity(1.0);
  scene.Pass->SetShadowTechniqueToShadowMap();
  CheckEdges("shadow map", scene);
}

// Depths with stencils get their mask by a shader, others by a copy.
void TestStencil()
{
  WindowScene scene(Width, Height, 1);
  HideLamp(scene);
  const Picture smooth = CaptureSmooth(scene);
  WindowScene stencil(Width, Height, 1);
  stencil.Window->StencilCapableOn();
  HideLamp(stencil);
  const int different = CountDifferences(CaptureSmooth(stencil), smooth);
  Check(different < 30, Text("with stencils: ", different, " values differ"));
}

// Shadows of two lamps on surfaces need the scene's distances before its colours.
void TestTwoLamps()
{
  WindowScene scene(Width, Height, 2);
  scene.Pass->RecordBuffersOff();
  HideLamp(scene);
  vtkLight* second = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(1));
  second->SetPosition(-4.0, 5.0, 7.0);
  CheckEdges("two lamps", scene);
}

// Borders of shadows in the air alone.
void TestAir()
{
  WindowScene scene(Width, Height, 0);
  scene.Pass->RecordBuffersOff();
  scene.Renderer->GetLights()->RemoveAllItems();
  scene.AddDirectionalLight({ 0.4, 1.0, 0.2 }, glm::dvec3(8.0));
  scene.Pass->SetDebugViewToAirlightOnly();
  CheckEdges("airlight alone", scene);
}

//------------------------------------------------------------------------------
void TestDisplay()
{
  WindowScene scene(Width, Height, 1);
  HideLamp(scene);
  scene.Pass->SetExposure(0.7);
  scene.Pass->SetToneMapping(vtkAirlightPass::GENERIC_FILMIC);
  scene.Pass->SetOutputColorSpace(vtkAirlightPass::SRGB);
  const Picture one = Capture(scene.Window);
  const Picture smooth = CaptureSmooth(scene);
  int changed = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const bool same = std::equal(&one[3 * i], &one[3 * i] + 3, &smooth[3 * i]);
    changed += same ? 0 : 1;
  }
  Check(changed > 100 && changed < Width * Height / 4, Text("of what is shown: ", changed));
  scene.Pass->AutomaticExposureOn();
  Capture(scene.Window);
  const Picture exposed = CaptureSmooth(scene);
  Check(CaptureSmooth(scene) == exposed, "with automatic exposure the same each time");
}

//------------------------------------------------------------------------------
// The window, the pass and the frames of a mean.
void TestWhenAsked()
{
  WindowScene scene(Width, Height, 1);
  const Picture one = Capture(scene.Window);
  Check(!scene.Pass->GetMultisampling(), "it is off by default");
  scene.Pass->MultisamplingOn();
  Check(Capture(scene.Window) == one, "not without samples of the window");
  scene.Window->SetMultiSamples(1);
  Check(Capture(scene.Window) == one, "nor with one");
  scene.Pass->MultisamplingOff();
  scene.Window->SetMultiSamples(4);
  Check(Capture(scene.Window) == one, "nor without the property");
  scene.Window->SetMultiSamples(0);
  scene.Pass->SetSubpixelFrames(8);
  const Picture mean = Capture(scene.Window);
  Check(CaptureSmooth(scene) == mean, "a mean of whole frames needs none");
  scene.Window->SetDesiredUpdateRate(15.0);
  const Picture moving = CaptureSmooth(scene);
  scene.Window->SetDesiredUpdateRate(0.0001);
  scene.Pass->SetSubpixelFrames(1);
  Check(CaptureSmooth(scene) == moving && moving != one, "but its one frame in motion has");
  scene.Renderer->PreserveDepthBufferOn();
  const Picture among = CaptureSmooth(scene);
  Check(Capture(scene.Window) == among, "among depths of others there is one frame");
}

// VTK's own picture, with the window's samples.
void TestClearAir()
{
  WindowScene scene(Width, Height, 1);
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  scene.Pass->SurfaceShadowsOff();
  scene.Pass->RecordBuffersOff();
  const Picture smooth = CaptureSmooth(scene);
  scene.Renderer->SetPass(nullptr);
  const Picture plain = CaptureSmooth(scene);
  Check(
    plain == smooth, Text("clear air is VTK's picture, but for ", CountDifferences(plain, smooth)));
  Check(Capture(scene.Window) != plain, "which the window's samples smooth");
}

//------------------------------------------------------------------------------
void TestBuffers()
{
  Scene scene(Width, Height);
  scene.AddPointLight({ 1, 3, 2 });
  scene.Add(MakeSphere(1.0));
  scene.Pass->DitheringOff();
  const Buffers one = scene.Render();
  SetSmooth(scene, true);
  const Buffers smooth = scene.Render();
  const Picture picture = Capture(scene.Window);
  CheckBuffers(one, smooth, Capture(scene.Window));
  int changed = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double value = GetValue(smooth.at("Radiance"), i % Width, i / Width, c);
      changed += value != GetValue(one.at("Radiance"), i % Width, i / Width, c) ? 1 : 0;
    }
  }
  Check(changed < 3 * Width * Height / 4, Text("elsewhere it is as it was: ", changed));
}
}

//------------------------------------------------------------------------------
int TestMultisampling(int, char*[])
{
  TestEdges();
  TestStencil();
  TestTwoLamps();
  TestAir();
  TestDisplay();
  TestWhenAsked();
  TestClearAir();
  TestBuffers();
  const auto smooth = [](Scene& scene, vtkRenderWindow* window) {
    window->SetMultiSamples(4);
    scene.Pass->MultisamplingOn();
  };
  CheckViewports(Width, Height, smooth);
  // At an edge on the border of two tiles, one does not see the other's.
  CheckTiles(Width, Height, smooth, false);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
