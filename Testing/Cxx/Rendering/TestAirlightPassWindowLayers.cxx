// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass below, in and above other layers of a window, and over all kinds of background.

#include "AirlightTestWindowScene.h"

#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

using namespace airlight_test;

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

// A medium that dims all colours alike: one opacity describes it.
void MakeGrey(Scene& scene)
{
  scene.Medium->SetScattering(0.06, 0.06, 0.06);
  scene.Medium->SetAbsorption(0.02, 0.02, 0.02);
}

// One whose opacity is the mean of its colours'.
void MakeColoured(Scene& scene)
{
  scene.Medium->SetScattering(0.02, 0.06, 0.03);
  scene.Medium->SetAbsorption(0.01, 0.02, 0.2);
}

// What is left of what lies behind the medium, in each channel: on average, since a picture has one
// opacity.
double GetClarity(Scene& scene, int x, int y)
{
  const Ray ray = scene.GetRay(x + 0.5, y + 0.5);
  const glm::dvec3 far = ray.Origin + 1000.0 * ray.Direction;
  glm::dvec3 passes;
  vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &far.x, &passes.x);
  return (passes.x + passes.y + passes.z) / 3.0;
}

// A triangle that shows its colour, whatever the light.
vtkSmartPointer<vtkActor> MakeSign()
{
  const auto actor = Scene::MakeActor(MakeSoup({ { { -2, -1, 5 }, { 2, -1, 5 }, { 0, 1.5, 5 } } }));
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.0, 0.8, 1.0);
  return actor;
}

vtkSmartPointer<vtkRenderer> AddLayer(vtkRenderWindow* window, vtkCamera* camera, int layer)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetLayer(layer);
  renderer->SetActiveCamera(camera);
  window->SetNumberOfLayers(std::max(window->GetNumberOfLayers(), layer + 1));
  window->AddRenderer(renderer);
  return renderer;
}

//------------------------------------------------------------------------------
// A layer without pass above the fog stays as clear as it is alone.
void TestLayerAbove()
{
  WindowScene scene;
  scene.Pass->DitheringOff();
  const Picture fog = Capture(scene.Window);
  const auto above = AddLayer(scene.Window, scene.Renderer->GetActiveCamera(), 1);
  above->AddActor(MakeSign());
  const Picture both = Capture(scene.Window);
  int sign = 0;
  int wrong = 0;
  for (size_t i = 0; i < both.size(); i += 3)
  {
    const bool clear = both[i] == 0 && both[i + 1] == 204 && both[i + 2] == 255;
    sign += clear;
    for (size_t k = i; k < i + 3 && !clear; ++k)
    {
      wrong += std::abs(both[k] - fog[k]) > 0;
    }
  }
  std::cout << "layer above: " << sign << " pixels of it, " << wrong << " others changed\n";
  Check(ShowsScene(fog) && sign > 300 && wrong == 0, "the layer above is clear, the rest fog");
}

//------------------------------------------------------------------------------
// What the pass adds over a picture `under`: radiance + (1 - opacity) under, with opacity 1 on
// surfaces and 1 - T beside them, T from vtkAirlight, the mean of the channels.
double CompareOver(WindowScene& scene, const Picture& under, const Picture& picture)
{
  double largest = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const bool surface = GetValue(scene.GetBuffer("Depth"), x, y) >= 0.0;
      const double clarity = surface ? 0.0 : GetClarity(scene, x, y);
      const glm::dvec3 added = GetColour(scene.GetBuffer("Radiance"), x, y);
      for (int k = 0; k < 3; ++k)
      {
        const size_t i = 3 * (static_cast<size_t>(y) * Width + x) + k;
        const double expected = 255.0 * added[k] + clarity * under[i];
        largest = std::max(largest, std::abs(std::min(expected, 255.0) - picture[i]));
      }
    }
  }
  return largest;
}

// The pass in a layer above another, and in one of the same layer that keeps the colours.
void TestLayerOver(bool sameLayer, void (*makeMedium)(Scene&), const std::string& medium)
{
  const std::string what =
    (sameLayer ? "colours preserved, " : "pass in the layer above, ") + medium;
  WindowScene scene;
  scene.Pass->DitheringOff();
  makeMedium(scene);
  scene.Window->RemoveRenderer(scene.Renderer);
  const auto below = AddLayer(scene.Window, scene.Renderer->GetActiveCamera(), 0);
  below->SetBackground(0.7, 0.1, 0.2);
  below->SetBackground2(0.1, 0.4, 0.9);
  below->GradientBackgroundOn();
  below->AddActor(MakeSign());
  const Picture under = Capture(scene.Window);
  if (sameLayer)
  {
    scene.Renderer->SetPreserveColorBuffer(1);
  }
  else
  {
    scene.Window->SetNumberOfLayers(2);
    scene.Renderer->SetLayer(1);
  }
  scene.Window->AddRenderer(scene.Renderer);
  for (const double opacity : { 1.0, 0.5 })
  {
    scene.Cube->GetProperty()->SetOpacity(opacity);
    const Picture picture = Capture(scene.Window);
    if (opacity == 1.0)
    {
      const double largest = CompareOver(scene, under, picture);
      std::cout << what << ": differs by " << largest << "/255\n";
      // Half a step of rounding each: colour, opacity and their product, which OpenGL may blend in
      // the window's eight bits.
      Check(largest <= 1.5, what + ": premultiplied blending");
    }
    Check(CountDifferent(under, picture, 10) > 3000, what + ": something is drawn over it");
  }
  scene.Cube->GetProperty()->SetOpacity(1.0);
  scene.Medium->SetRegionToUnbounded();
  const Picture opaque = Capture(scene.Window);
  below->SetBackground(0.0, 0.0, 0.0);
  below->SetBackground2(0.0, 0.0, 0.0);
  Check(Compare(opaque, Capture(scene.Window)) == 0, what + ": endless fog hides all below");
}

//------------------------------------------------------------------------------
// An image behind the scene: T image + airlight. The viewport is off the origin.
void TestTexturedBackground()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 3 * 256; ++i)
  {
    values[i] = static_cast<unsigned char>((i * 37) % 256);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  WindowScene scene;
  scene.Pass->DitheringOff();
  MakeGrey(scene);
  scene.Renderer->SetBackgroundTexture(texture);
  scene.Renderer->TexturedBackgroundOn();
  const auto window = MakeWindow(2 * Width, 2 * Height);
  Place(scene, window, 0.5, 0.5, 1.0, 1.0);
  const auto capture = [&] {
    return Cut(Capture(window), 2 * Width, Width, Height, Width, Height);
  };
  scene.Renderer->SetPass(nullptr);
  const Picture under = capture();
  scene.Renderer->SetPass(scene.Pass);
  scene.Pass->RemoveAllMedia();
  scene.Pass->SurfaceShadowsOff();
  const int clear = Compare(under, capture());
  scene.Pass->SetMedium(scene.Medium);
  const Picture fog = capture();
  double largest = 0.0;
  int pixels = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      if (GetValue(scene.GetBuffer("Depth"), x, y) >= 0.0)
      {
        continue;
      }
      ++pixels;
      const Ray ray = scene.GetRay(x + 0.5, y + 0.5);
      const glm::dvec3 far = ray.Origin + 1000.0 * ray.Direction;
      glm::dvec3 passes;
      vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &far.x, &passes.x);
      const glm::dvec3 airlight = GetColour(scene.GetBuffer("Airlight"), x, y);
      for (int k = 0; k < 3; ++k)
      {
        const size_t i = 3 * (static_cast<size_t>(y) * Width + x) + k;
        const double expected = std::min(255.0 * airlight[k] + passes[k] * under[i], 255.0);
        largest = std::max(largest, std::abs(expected - fog[i]));
      }
    }
  }
  std::cout << "textured background: in a vacuum differs by " << clear << "/255, in fog by "
            << largest << "/255 on " << pixels << " pixels\n";
  Check(ShowsScene(under) && pixels > 2000, "textured background: it is seen");
  Check(clear <= 1, "textured background: in a vacuum as without the pass");
  Check(largest <= 0.51, "textured background: dimmed and airlight added");
}

//------------------------------------------------------------------------------
// The picture's own opacity, for pictures that are put over others later.
void TestOpacity(void (*makeMedium)(Scene&), const std::string& medium)
{
  WindowScene scene;
  scene.Pass->DitheringOff();
  makeMedium(scene);
  scene.Window->SetAlphaBitPlanes(1);
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 1, pixels);
  double largest = 0.0;
  int between = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const bool surface = GetValue(scene.GetBuffer("Depth"), x, y) >= 0.0;
      const double expected = surface ? 255.0 : 255.0 * (1.0 - GetClarity(scene, x, y));
      const double value = pixels->GetValue(4 * (y * Width + x) + 3);
      largest = std::max(largest, std::abs(value - expected));
      between += value > 10.0 && value < 245.0;
    }
  }
  std::cout << "transparent background, " << medium << ": opacity differs by " << largest
            << "/255, " << between << " pixels are between\n";
  Check(between > 1000 && largest <= 0.51, medium + ": the opacity is that of surface and medium");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassWindowLayers(int, char*[])
{
  TestLayerAbove();
  TestLayerOver(false, MakeGrey, "grey");
  TestLayerOver(true, MakeGrey, "grey");
  TestLayerOver(false, MakeColoured, "coloured");
  TestLayerOver(true, MakeColoured, "coloured");
  TestTexturedBackground();
  TestOpacity(MakeGrey, "grey");
  TestOpacity(MakeColoured, "coloured");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
