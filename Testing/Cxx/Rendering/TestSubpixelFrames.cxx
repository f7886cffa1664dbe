// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetSubpixelFrames(): the picture tends to the mean over each pixel, here of 256
// pictures of cameras that the test moves; it is the same each time; and camera, depths, viewports
// and annotations are as with one frame.

#include "AirlightTestEdges.h"
#include "AirlightTestMeans.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkCallbackCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Width = 96;
constexpr int Height = 72;

void CheckEdges(const std::string& name, WindowScene& scene)
{
  const Picture one = Capture(scene.Window);
  Check(*std::max_element(one.begin(), one.end()) < 255, name + ": nothing is cut off at white");
  const Means expected = AverageByHand(scene.Window, scene.Renderer);
  const double first = GetEdgeError(expected, one, one);
  std::cout << name << ": one frame is off by " << first << " / 255";
  const std::pair<int, double> goals[] = { { 16, 5.0 }, { 64, 12.0 } };
  for (const auto& goal : goals)
  {
    scene.Pass->SetSubpixelFrames(goal.first);
    const Picture mean = Capture(scene.Window);
    const double error = GetEdgeError(expected, one, mean);
    std::cout << ", " << goal.first << " by " << error;
    Check(error < first / goal.second, Text(name, ": error of ", goal.first, " frames"));
    Check(Capture(scene.Window) == mean, name + ": the same each time");
  }
  std::cout << "\n";
  double center[2];
  scene.Renderer->GetActiveCamera()->GetWindowCenter(center);
  Check(center[0] == 0.0 && center[1] == 0.0, name + ": the camera is where it was");
  scene.Pass->SetSubpixelFrames(1);
  Check(Capture(scene.Window) == one, name + ": one frame as before");
}

//------------------------------------------------------------------------------
void TestEdges()
{
  WindowScene scene(Width, Height, 1);
  HideLamp(scene);
  CheckEdges("opaque", scene);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  CheckEdges("parallel", scene);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Ball->GetProperty()->SetOpacity(0.5);
  CheckEdges("translucent", scene);
  scene.Ball->GetProperty()->SetOpacity(1.0);
  scene.Pass->SetShadowTechniqueToRayMarch();
  CheckEdges("march", scene);
}

//------------------------------------------------------------------------------
// It is encoded once.
void TestEncoding()
{
  WindowScene scene(Width, Height, 1);
  HideLamp(scene);
  scene.Pass->SetSubpixelFrames(16);
  const Picture linear = Capture(scene.Window);
  scene.Pass->SetEncodedOutput(true);
  const Picture encoded = Capture(scene.Window);
  int most = 0;
  for (size_t i = 0; i < linear.size(); ++i)
  {
    // Back, as eight bits know dark colours better so.
    const double back = 255.0 * std::pow(encoded[i] / 255.0, 2.2);
    const double step = 255.0 * std::pow((encoded[i] + 1.0) / 255.0, 2.2) - back;
    most = std::max(most, std::abs(back - linear[i]) > step + 1.0 ? 1 : 0);
  }
  Check(most == 0, "the mean is encoded, and not a mean of what is encoded");
}

//------------------------------------------------------------------------------
void TestBuffers()
{
  Scene scene(Width, Height);
  scene.AddPointLight({ 1, 3, 2 });
  scene.Add(MakeSphere(1.0));
  scene.Pass->DitheringOff();
  const Buffers one = scene.Render();
  scene.Pass->SetSubpixelFrames(5);
  const Buffers mean = scene.Render();
  for (const char* name : { "Airlight", "LitLength" })
  {
    Check(!AreSame(one.at(name), mean.at(name)), Text(name, " is a mean"));
  }
  CheckBuffers(one, mean, Capture(scene.Window));
}

//------------------------------------------------------------------------------
// Text over the medium does not move, is not blurred, and not encoded.
void TestAnnotations()
{
  WindowScene scene(Width, Height, 1);
  vtkNew<vtkTextActor> text;
  text->SetInput("fog");
  text->GetTextProperty()->SetFontSize(30);
  text->GetTextProperty()->SetColor(1.0, 1.0, 1.0);
  scene.Renderer->AddActor2D(text);
  const Picture one = Capture(scene.Window);
  scene.Pass->SetSubpixelFrames(8);
  const Picture mean = Capture(scene.Window);
  int white = 0;
  for (size_t i = 0; i < one.size(); ++i)
  {
    white += one[i] == 255 ? 1 : 0;
    Check(one[i] != 255 || mean[i] == 255, "white text stays white");
  }
  Check(white > 100, Text("there is text: ", white));
}

//------------------------------------------------------------------------------
// FXAA is left out of a mean; and what cannot be averaged is one frame.
void TestOneFrame()
{
  WindowScene scene(Width, Height, 1);
  scene.Pass->SetSubpixelFrames(4);
  const Picture mean = Capture(scene.Window);
  scene.Renderer->UseFXAAOn();
  Check(Capture(scene.Window) == mean, "without FXAA");
  scene.Renderer->UseFXAAOff();
  const auto check = [&scene](const std::string& name) {
    scene.Pass->SetSubpixelFrames(4);
    const Picture several = Capture(scene.Window);
    scene.Pass->SetSubpixelFrames(1);
    Check(Capture(scene.Window) == several, name + ": one frame");
  };
  scene.Pass->SetDebugViewToBoundaryCount();
  check("counts");
  scene.Pass->SetDebugViewToShadowPlanes();
  check("planes");
  scene.Pass->SetDebugViewToShaded();
  scene.Renderer->PreserveDepthBufferOn();
  check("depths of others");
  scene.Renderer->PreserveDepthBufferOff();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->UseOffAxisProjectionOn();
  check("off the axis");
}

//------------------------------------------------------------------------------
// Of a camera with a matrix of its own, as VTK's own of the same view; with multisampling, too.
void TestOwnMatrix()
{
  for (const int frames : { 4, 1 })
  {
    WindowScene scene(Width, Height, 1);
    scene.Window->SetMultiSamples(4);
    const Picture one = Capture(scene.Window);
    scene.Pass->SetSubpixelFrames(frames);
    scene.Pass->MultisamplingOn();
    const Picture expected = Capture(scene.Window);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    vtkNew<vtkMatrix4x4> projection;
    projection->DeepCopy(
      camera->GetProjectionTransformMatrix(scene.Renderer->GetTiledAspectRatio(), -1, 1));
    vtkNew<vtkMatrix4x4> kept;
    kept->DeepCopy(projection);
    camera->SetExplicitProjectionTransformMatrix(projection);
    camera->UseExplicitProjectionTransformMatrixOn();
    const Picture seen = Capture(scene.Window);
    int largest = 0;
    int changed = 0;
    for (size_t i = 0; i < seen.size(); ++i)
    {
      largest = std::max(largest, std::abs(seen[i] - expected[i]));
      changed += seen[i] != one[i] ? 1 : 0;
    }
    Check(largest <= 1, Text("a matrix of its own, ", frames, " frames: off by ", largest));
    Check(changed > 100, Text("edges of ", changed, " numbers are smooth"));
    Check(camera->GetExplicitProjectionTransformMatrix() == projection.Get() &&
        std::equal(kept->GetData(), kept->GetData() + 16, projection->GetData()),
      "the camera has its matrix again");
  }
}

//------------------------------------------------------------------------------
// Each frame is told, and the window may end the mean: its buffers are the mean of what was drawn.
void TestProgress()
{
  WindowScene scene(Width, Height, 1);
  scene.Pass->SetSubpixelFrames(8);
  struct
  {
    std::vector<double> Shares;
    vtkRenderWindow* Window;
    bool Aborts = false;
  } seen;
  seen.Window = scene.Window;
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(&seen);
  progress->SetCallback([](vtkObject*, unsigned long, void* data, void* share) {
    auto* all = static_cast<decltype(seen)*>(data);
    all->Shares.push_back(*static_cast<double*>(share));
    all->Window->SetAbortRender(all->Aborts && all->Shares.size() == 3);
  });
  scene.Pass->AddObserver(vtkCommand::ProgressEvent, progress);
  const Buffers whole = scene.Render();
  Check(seen.Shares.size() == 8 && seen.Shares[1] == 0.25 && seen.Shares[7] == 1.0,
    "the progress of eight frames");
  seen.Shares.clear();
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Window->Render();
  Check(seen.Shares.empty(), "one frame while the user moves something");
  scene.Window->SetDesiredUpdateRate(0.0001);
  scene.Window->Render();
  Check(seen.Shares.size() == 8, "and all at rest");
  seen.Aborts = true;
  seen.Shares.clear();
  const Buffers part = scene.Render();
  Check(seen.Shares.size() == 3, "ended after three frames");
  double sums[2] = { 0.0, 0.0 };
  for (int i = 0; i < Width * Height; ++i)
  {
    sums[0] += GetValue(whole.at("Airlight"), i % Width, i / Width);
    sums[1] += GetValue(part.at("Airlight"), i % Width, i / Width);
  }
  Check(std::abs(sums[1] / sums[0] - 1.0) < 0.02, "the mean of three frames");
}
}

//------------------------------------------------------------------------------
int TestSubpixelFrames(int, char*[])
{
  TestEdges();
  TestEncoding();
  TestBuffers();
  TestAnnotations();
  TestOneFrame();
  TestOwnMatrix();
  TestProgress();
  const auto smooth = [](Scene& scene, vtkRenderWindow*) { scene.Pass->SetSubpixelFrames(16); };
  CheckViewports(Width, Height, smooth);
  CheckTiles(Width, Height, smooth, true);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
