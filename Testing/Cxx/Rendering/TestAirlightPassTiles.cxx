// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass in screenshots larger than the window, which VTK puts together from tiles: the
// picture is that of a window of that size.

#include "AirlightWindowScene.h"

#include "vtkWindowToImageFilter.h"

using namespace airlighttest;

namespace
{
constexpr int Scale = 3;
constexpr int Width = 100;
constexpr int Height = 75;

Picture Shoot(vtkRenderWindow* window, bool fixBoundary)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->SetScale(Scale, Scale);
  filter->SetFixBoundary(fixBoundary);
  filter->ReadFrontBufferOff();
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  const auto* first = static_cast<const unsigned char*>(image->GetScalarPointer());
  return Picture(first, first + 3 * image->GetNumberOfPoints());
}

void CheckShot(const std::string& what, const Picture& direct, const Picture& shot)
{
  const int steps = Compare(direct, shot);
  const int different = CountDifferent(direct, shot, 1);
  std::cout << what << ": differs by " << steps << "/255 at most, " << different << " of "
            << direct.size() / 3 << " pixels by more than 1/255\n";
  Check(ShowsScene(direct), what + ": something is seen");
  Check(direct.size() == size_t(3) * Scale * Scale * Width * Height && steps <= 1,
    what + ": the picture of a large window");
}

//------------------------------------------------------------------------------
using Change = std::function<void(WindowScene&)>;

void TestWhole(const std::string& what, const Change& change)
{
  WindowScene large(Scale * Width, Scale * Height, 2);
  change(large);
  const Picture direct = Capture(large.Window);
  WindowScene small(Width, Height, 2);
  change(small);
  const Picture before = Capture(small.Window);
  CheckShot(what, direct, Shoot(small.Window, false));
  CheckShot(what + ", overlapping tiles", direct, Shoot(small.Window, true));
  Check(Compare(before, Capture(small.Window)) == 0, what + ": the window is as before");
}

//------------------------------------------------------------------------------
// Viewports that tiles cut through, miss and touch. (VTK clears nothing beside viewports in tiles.)
void TestViewports()
{
  const auto make = [](int scale, bool shoot) {
    WindowScene left(Width, Height, 1);
    WindowScene right(Width, Height, 2);
    right.Cube->GetProperty()->SetOpacity(0.5);
    const auto window = MakeWindow(scale * Width, scale * Height);
    Place(left, window, 0.0, 0.0, 0.4, 1.0);
    Place(right, window, 0.4, 0.0, 1.0, 1.0);
    return shoot ? Shoot(window, false) : Capture(window);
  };
  CheckShot("two viewports", make(Scale, false), make(1, true));
}
}

//------------------------------------------------------------------------------
int TestAirlightPassTiles(int, char*[])
{
  TestWhole("perspective", [](WindowScene&) {});
  TestWhole("parallel projection", [](WindowScene& scene) {
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  });
  TestWhole("translucent", [](WindowScene& scene) {
    scene.Cube->GetProperty()->SetOpacity(0.5);
    scene.Medium->SetRegionToUnbounded();
  });
  TestViewports();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
