// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetSubpixelFrames() and SetProgressiveRefinement() in windows with layers, alpha
// and sRGB, in stereo and with a delegate: the mean is that of single frames by hand, and pictures
// that are refined end as those of all frames at once.

#include "AirlightTestDimScene.h"
#include "AirlightTestMeans.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
constexpr int Columns = DimScene::Columns;
constexpr int Rows = DimScene::Rows;
constexpr int Count = 16;

using Taker = std::function<Picture()>;

// `stepwise`: whether refinement has a frame a picture.
void CheckMean(const std::string& name, DimScene& scene, const Taker& take, bool stepwise = true)
{
  scene.Pass->SetSubpixelFrames(1);
  const Picture one = take();
  const Means expected = AverageByHand(scene.Window, scene.Renderer, take);
  scene.Pass->SetSubpixelFrames(Count);
  const Picture mean = take();
  const double first = GetEdgeError(expected, one, one);
  const double error = GetEdgeError(expected, one, mean);
  std::cout << name << ": one frame is off by " << first << " / 255, the mean by " << error << "\n";
  Check(error < first / 5.0, name + ": the mean is that by hand");
  scene.Pass->ProgressiveRefinementOn();
  const Picture begun = take();
  Check(scene.Pass->GetAccumulatedFrames() == (stepwise ? 1 : Count), name + ": the first picture");
  Check((begun == mean) != stepwise, name + ": shows what it has");
  for (int i = 1; i < Count; ++i)
  {
    scene.Window->Render();
  }
  const Picture refined = take();
  Check(scene.Pass->GetAccumulatedFrames() == Count, name + ": all frames in the end");
  Check(refined == mean, Text(name, ": refined, it differs by ", Compare(refined, mean)));
  scene.Pass->ProgressiveRefinementOff();
}

//------------------------------------------------------------------------------
// Over another renderer's picture, and below one.
void TestLayers()
{
  DimScene scene;
  const Taker take = [&scene] { return Capture(scene.Window); };
  vtkNew<vtkRenderer> other;
  vtkNew<vtkActor> actor;
  actor->SetMapper(scene.Cube->GetMapper());
  actor->SetPosition(0.0, 2.0, -3.0);
  other->AddActor(actor);
  other->SetBackground(0.1, 0.2, 0.3);
  other->ResetCamera();
  other->GetActiveCamera()->Zoom(0.3);
  scene.Window->SetNumberOfLayers(2);
  scene.Window->AddRenderer(other);
  scene.Renderer->SetLayer(1);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  CheckMean("over another layer", scene, take);
  scene.Renderer->SetLayer(0);
  other->SetLayer(1);
  CheckMean("below another layer", scene, take);
}

//------------------------------------------------------------------------------
// Opacities are means, too.
void TestAlpha()
{
  DimScene scene;
  scene.Window->SetAlphaBitPlanes(1);
  scene.Renderer->SetBackgroundAlpha(0.0);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const auto take = [&scene] {
    scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    scene.Window->GetRGBACharPixelData(0, 0, Columns - 1, Rows - 1, 1, pixels);
    const unsigned char* first = pixels->GetPointer(0);
    return Picture(first, first + pixels->GetNumberOfValues());
  };
  const Picture picture = take();
  int clear = 0;
  int veiled = 0;
  for (size_t i = 3; i < picture.size(); i += 4)
  {
    clear += picture[i] == 0 ? 1 : 0;
    veiled += picture[i] > 0 && picture[i] < 255 ? 1 : 0;
  }
  Check(veiled > 1000, Text("pixels half veiled: ", veiled, ", clear: ", clear));
  CheckMean("a transparent background", scene, take);
}

//------------------------------------------------------------------------------
// Pairs have all frames of both eyes at once.
void TestStereo()
{
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_ANAGLYPH, VTK_STEREO_INTERLACED })
  {
    DimScene scene;
    scene.Window->SetStereoType(type);
    scene.Window->StereoRenderOn();
    CheckMean(
      Text("stereo ", type), scene, [&scene] { return Capture(scene.Window); }, false);
  }
}

//------------------------------------------------------------------------------
void TestDelegate()
{
  DimScene scene;
  const Taker take = [&scene] { return Capture(scene.Window); };
  scene.Pass->SetSubpixelFrames(Count);
  const Picture without = take();
  vtkNew<vtkRenderStepsPass> steps;
  scene.Pass->SetDelegatePass(steps);
  Check(Compare(take(), without) <= 1, "a delegate that draws the same");
  CheckMean("a delegate", scene, take);
  scene.Pass->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
// A window of sRGB encodes what it is given, the mean of radiance, where VTK can have such a one.
double Decode(double x)
{
  return x <= 0.04045 * 255.0 ? x / 12.92 : 255.0 * std::pow((x / 255.0 + 0.055) / 1.055, 2.4);
}

void CheckEncoding(const std::string& name, const Picture& linear, const Picture& encoded)
{
  int wrong = 0;
  for (size_t i = 0; i < linear.size(); ++i)
  {
    // Half a step of each, by the encoding's slope.
    const double step = Decode(encoded[i] + 0.51) - Decode(encoded[i] - 0.51);
    wrong += std::abs(Decode(encoded[i]) - linear[i]) > 0.51 + step ? 1 : 0;
  }
  Check(wrong == 0, Text(name, " in a window of sRGB: ", wrong, " values differ"));
}

void TestSRGB()
{
  DimScene linear;
  DimScene encoded;
  encoded.Window->SetUseSRGBColorSpace(true);
  vtkNew<vtkRenderStepsPass> steps; // VTK's own picture
  const bool encodes = linear.ShowOnce(steps) != encoded.ShowOnce(steps);
  std::cout << "VTK's windows of sRGB encode: " << encodes << "\n";
  for (const int frames : { 1, Count })
  {
    linear.Pass->SetSubpixelFrames(frames);
    encoded.Pass->SetSubpixelFrames(frames);
    linear.Renderer->SetPass(linear.Pass);
    encoded.Renderer->SetPass(encoded.Pass);
    const Picture expected = Capture(linear.Window);
    const Picture picture = Capture(encoded.Window);
    if (encodes)
    {
      CheckEncoding(Text(frames, " frames"), expected, picture);
    }
    else
    {
      Check(picture == expected, Text(frames, " frames, as VTK has no such window"));
    }
  }
}
}

//------------------------------------------------------------------------------
int TestSubpixelWindows(int, char*[])
{
  TestLayers();
  TestAlpha();
  TestStereo();
  TestDelegate();
  TestSRGB();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
