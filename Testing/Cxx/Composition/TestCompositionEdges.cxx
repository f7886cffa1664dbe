// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Smooth edges: what of VTK's antialiasing works with the pass, and how far it and frames moved by
// parts of a pixel are from a picture with 64 samples a pixel.

#include "AirlightTestComposition.h"

#include "vtkOpenGLFXAAPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkTexture.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Side = 160;  // square: SSAA's larger target then has the same shape
constexpr int Samples = 8; // of a pixel, each way

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeTexture(const Picture& picture, int side)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(picture.begin(), picture.end(), static_cast<unsigned char*>(image->GetScalarPointer()));
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

// What a pass of VTK's makes of a picture, a renderer's background.
template <typename Outside>
Picture Process(const Picture& picture, int side, Outside* outside)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Side, Side);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackgroundTexture(MakeTexture(picture, side));
  renderer->TexturedBackgroundOn();
  vtkNew<vtkRenderStepsPass> steps;
  outside->SetDelegatePass(steps);
  renderer->SetPass(outside);
  window->AddRenderer(renderer);
  const Picture result = Capture(window);
  outside->ReleaseGraphicsResources(window);
  renderer->SetPass(nullptr);
  return result;
}

//------------------------------------------------------------------------------
// Where blocks of samples are not all alike, and none is cut off at white: the
// picture's edges.
struct Reference
{
  explicit Reference(const Picture& large)
  {
    for (int i = 0; i < 3 * Side * Side; ++i)
    {
      const int x = i / 3 % Side;
      const int y = i / 3 / Side;
      double sum = 0.0;
      int least = 255;
      int most = 0;
      for (int k = 0; k < Samples * Samples; ++k)
      {
        const int row = Samples * y + k / Samples;
        const int column = Samples * x + k % Samples;
        const int value = large[3 * (row * Samples * Side + column) + i % 3];
        sum += value;
        least = std::min(least, value);
        most = std::max(most, value);
      }
      this->Values.push_back(sum / (Samples * Samples));
      this->Edges.push_back(most - least > 20 && most < 255);
    }
  }

  // Root mean square over the edges, in steps of 1/255.
  double GetError(const Picture& picture) const
  {
    double sum = 0.0;
    int count = 0;
    for (size_t i = 0; i < this->Values.size(); ++i)
    {
      const double error = picture[i] - this->Values[i];
      sum += this->Edges[i] ? error * error : 0.0;
      count += this->Edges[i] ? 1 : 0;
    }
    Check(count > 500, "the picture has edges: " + std::to_string(count));
    return std::sqrt(sum / count);
  }

  std::vector<double> Values;
  std::vector<bool> Edges;
};
}

//------------------------------------------------------------------------------
int TestCompositionEdges(int, char*[])
{
  Composition scene(Side, Side);
  scene.SetFoggy();
  const double intensity[3] = { 110.0, 95.0, 70.0 }; // for edges of much contrast
  vtkAirlight::SetRadiantIntensity(scene.Lamp, intensity);
  const Picture plain = scene.Show(scene.Pass);

  vtkNew<vtkOpenGLFXAAPass> fxaa;
  fxaa->SetDelegatePass(scene.Pass);
  const Picture smooth = scene.ShowOnce(fxaa);
  Check(CountApart(smooth, plain, 8) > 200, "FXAA has an effect");
  Check(Compare(smooth, Process(plain, Side, vtkNew<vtkOpenGLFXAAPass>().Get())) == 0,
    "FXAA outside is FXAA of the picture");
  scene.Renderer->UseFXAAOn();
  Check(Compare(scene.Show(scene.Pass), smooth) == 0, "FXAA of the renderer is FXAA outside");
  scene.Renderer->UseFXAAOff();

  vtkNew<vtkSSAAPass> ssaa;
  ssaa->SetDelegatePass(scene.Pass);
  const Picture averaged = scene.ShowOnce(ssaa);

  // Of a window as large as VTK's larger target, which holds radiance: nothing dithers it.
  scene.Pass->DitheringOff();
  const int large = static_cast<int>(Side * std::sqrt(5.0));
  scene.Window->SetSize(large, large);
  Check(Compare(averaged, Process(scene.Show(scene.Pass), large, vtkNew<vtkSSAAPass>().Get())) == 0,
    "SSAA outside is SSAA of the larger picture");

  scene.Window->SetSize(Samples * Side, Samples * Side);
  const Reference reference(scene.Show(scene.Pass));
  const double none = reference.GetError(plain);
  const double withFxaa = reference.GetError(smooth);
  const double withSsaa = reference.GetError(averaged);
  scene.Window->SetSize(Side, Side);
  scene.Pass->MultisamplingOn();
  scene.Window->SetMultiSamples(4);
  const double with4 = reference.GetError(scene.Show(scene.Pass));
  scene.Window->SetMultiSamples(0);
  scene.Pass->MultisamplingOff();
  scene.Pass->SetSubpixelFrames(16);
  const double with16 = reference.GetError(scene.Show(scene.Pass));
  scene.Pass->SetSubpixelFrames(64);
  const double with64 = reference.GetError(scene.Show(scene.Pass));
  scene.Pass->SetSubpixelFrames(1);
  std::cout << "edges' error, steps of 1/255: " << none << ", FXAA " << withFxaa << ", SSAA "
            << withSsaa << ", four samples at edges " << with4 << ", 16 frames " << with16
            << ", 64 frames " << with64 << "\n";
  Check(withFxaa < 0.8 * none, "FXAA brings edges closer to 64 samples a pixel");
  Check(withSsaa < 0.4 * none, "SSAA does more");
  Check(with4 <= 7.0 && with4 < 0.45 * none, "four samples at edges are SSAA's equal");
  Check(with16 < 0.5 * withSsaa && with64 < 0.25 * withSsaa, "frames moved by parts of a pixel");

  // The window's own multisampling is lost, and nothing else.
  Composition multisampled(Side, Side);
  multisampled.Window->SetMultiSamples(8);
  multisampled.SetFoggy();
  vtkAirlight::SetRadiantIntensity(multisampled.Lamp, intensity);
  Check(Compare(multisampled.Show(multisampled.Pass), plain) == 0,
    "the window's multisampling changes nothing");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
