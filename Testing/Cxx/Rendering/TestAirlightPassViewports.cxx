// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass in several viewports of one window: each shows what a window of its own shows,
// with a pass for each renderer and with one pass for all of them; viewports without pixels; and
// screenshots in tiles.

#include "AirlightTestWindowScene.h"

#include "vtkCallbackCommand.h"
#include "vtkWindowToImageFilter.h"

#include <functional>

using namespace airlight_test;

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

// What a renderer left in the pass's buffers, copied as soon as it is done.
class Recorder
{
public:
  explicit Recorder(Scene& scene, Scene& owner)
    : Owner(owner)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      auto* recorder = static_cast<Recorder*>(self);
      recorder->Last = recorder->Owner.CopyBuffers();
    });
    scene.Renderer->AddObserver(vtkCommand::EndEvent, command);
  }

  Buffers Last;

private:
  Scene& Owner; // of the pass
};

// The two scenes that are drawn side by side: they differ in lamps, background and opacity.
void MakeLeft(WindowScene& scene)
{
  scene.Renderer->SetBackground(0.6, 0.2, 0.1);
  scene.Renderer->SetBackground2(0.1, 0.2, 0.6);
  scene.Renderer->GradientBackgroundOn();
}

void MakeRight(WindowScene& scene)
{
  scene.Cube->GetProperty()->SetOpacity(0.5);
  scene.Renderer->SetBackground(0.1, 0.3, 0.1);
  scene.Look({ 3, 2, 9 }, { 0, 0, 0 });
}

void Report(const std::string& what, const Picture& expected, const Picture& picture,
  const Buffers& expectedBuffers, const Buffers& buffers)
{
  const int steps = Compare(expected, picture);
  const double relative = CompareBuffers(expectedBuffers, buffers);
  std::cout << what << ": differs by " << steps << "/255, buffers by " << relative << "\n";
  Check(ShowsScene(expected), what + ": something is seen");
  Check(steps <= 1, what + ": the same picture");
  Check(relative <= 1e-6, what + ": the same buffers");
}

//------------------------------------------------------------------------------
// `shared`: the right renderer uses the left one's pass.
void TestSideBySide(bool shared)
{
  WindowScene left(Width, Height, 1);
  WindowScene right(Width, Height, 2);
  MakeLeft(left);
  MakeRight(right);
  const Buffers leftBuffers = left.Render();
  const Buffers rightBuffers = right.Render();
  const Picture leftPicture = Capture(left.Window);
  const Picture rightPicture = Capture(right.Window);

  WindowScene a(Width, Height, 1);
  WindowScene b(Width, Height, 2);
  MakeLeft(a);
  MakeRight(b);
  if (shared)
  {
    b.Renderer->SetPass(a.Pass);
  }
  const auto window = MakeWindow(2 * Width, 2 * Height);
  Place(a, window, 0.0, 0.5, 0.5, 1.0);
  Place(b, window, 0.5, 0.0, 1.0, 0.5);
  const Recorder recordA(a, a);
  const Recorder recordB(b, shared ? a : b);
  const std::string name = shared ? "one pass for two viewports" : "two passes";
  for (int frame = 0; frame < 3; ++frame)
  {
    const Picture both = Capture(window);
    const std::string what = name + ", frame " + std::to_string(frame);
    Report(what + ", upper left", leftPicture, Cut(both, 2 * Width, 0, Height, Width, Height),
      leftBuffers, recordA.Last);
    Report(what + ", lower right", rightPicture, Cut(both, 2 * Width, Width, 0, Width, Height),
      rightBuffers, recordB.Last);
  }
}

//------------------------------------------------------------------------------
// The same actors and lights in two renderers with passes of their own, seen from two sides.
void TestSharedActors()
{
  WindowScene front;
  const Picture expectedFront = Capture(front.Window);
  WindowScene side;
  side.Look({ 9, 2, 3 }, { 0, 0, 0 });
  side.Medium->SetScattering(0.15, 0.1, 0.05);
  const Picture expectedSide = Capture(side.Window);

  WindowScene scene;
  Scene other(Width, Height);
  other.Look({ 9, 2, 3 }, { 0, 0, 0 });
  other.Medium->SetRegionToBox();
  other.Medium->SetBounds(-7, 7, -3, 5, -7, 7);
  other.Medium->SetScattering(0.15, 0.1, 0.05);
  for (vtkActor* actor : { scene.Floor, scene.Ball, scene.Cube })
  {
    other.Renderer->AddActor(actor);
  }
  other.Renderer->AddLight(scene.Lights[0]);
  const auto window = MakeWindow(2 * Width, Height);
  Place(scene, window, 0.0, 0.0, 0.5, 1.0);
  Place(other, window, 0.5, 0.0, 1.0, 1.0);
  for (int frame = 0; frame < 2; ++frame)
  {
    const Picture both = Capture(window);
    const int first = Compare(expectedFront, Cut(both, 2 * Width, 0, 0, Width, Height));
    const int second = Compare(expectedSide, Cut(both, 2 * Width, Width, 0, Width, Height));
    std::cout << "shared actors, frame " << frame << ": differ by " << first << " and " << second
              << "/255\n";
    Check(first <= 1 && second <= 1, "shared actors: the same pictures");
  }
  Check(ShowsScene(expectedSide), "shared actors: something is seen");
}

//------------------------------------------------------------------------------
// Viewports of few pixels and of none beside one that must not notice.
void TestTinyViewports()
{
  WindowScene alone;
  const Picture expected = Capture(alone.Window);
  const double viewports[][4] = { { 0.5, 0.2, 0.5, 0.8 }, { 0.6, 0.5, 0.9, 0.5 },
    { 1.0, 1.0, 1.0, 1.0 }, { 0.75, 0.5, 0.75 + 1.0 / (2 * Width), 0.5 + 1.0 / Height },
    { 0.75, 0.0, 0.75 + 1.0 / (2 * Width), 1.0 }, { 0.5, 0.5, 1.0, 0.5 + 1.0 / Height } };
  WindowScene scene;
  WindowScene tiny;
  tiny.Cube->GetProperty()->SetOpacity(0.5);
  const auto window = MakeWindow(2 * Width, Height);
  Place(scene, window, 0.0, 0.0, 0.5, 1.0);
  Place(tiny, window, 0.5, 0.0, 1.0, 1.0);
  for (const auto& v : viewports)
  {
    tiny.Renderer->SetViewport(v[0], v[1], v[2], v[3]);
    const Picture picture = Cut(Capture(window), 2 * Width, 0, 0, Width, Height);
    const int* size = tiny.Renderer->GetSize();
    const std::string what =
      "viewport of " + std::to_string(size[0]) + " x " + std::to_string(size[1]);
    const int steps = Compare(expected, picture);
    std::cout << what << ": its neighbour differs by " << steps << "/255\n";
    Check(steps <= 1, what + ": its neighbour is as alone");
    if (size[0] > 0 && size[1] > 0)
    {
      const int* extent = tiny.Pass->GetBuffer("Radiance")->GetDimensions();
      Check(extent[0] == size[0] && extent[1] == size[1], what + ": it has been drawn");
      CheckFinite(tiny.CopyBuffers(), what);
    }
  }
  tiny.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  WindowScene fresh;
  fresh.Cube->GetProperty()->SetOpacity(0.5);
  const Picture after = Cut(Capture(window), 2 * Width, Width, 0, Width, Height);
  Check(Compare(Capture(fresh.Window), after) <= 1, "the viewport made large again");
}

// Windows of one pixel or one row, and back.
void TestTinyWindows()
{
  WindowScene scene;
  const Buffers before = scene.Render();
  const int sizes[][2] = { { 1, 1 }, { 1, 40 }, { 40, 1 }, { 2, 3 } };
  for (const auto& size : sizes)
  {
    scene.Window->SetSize(size[0], size[1]);
    const std::string what =
      "window of " + std::to_string(size[0]) + " x " + std::to_string(size[1]);
    const Buffers buffers = scene.Render();
    const int* extent = buffers.at("Radiance")->GetDimensions();
    std::cout << what << ": buffers of " << extent[0] << " x " << extent[1] << "\n";
    Check(extent[0] == size[0] && extent[1] == size[1], what + ": buffers of that size");
    CheckFinite(buffers, what);
  }
  scene.Window->SetSize(Width, Height);
  CheckSame(before, scene.Render(), "the window made large again");
}

//------------------------------------------------------------------------------
// Screenshots larger than the window, which VTK puts together from tiles: the picture is that of a
// window of that size.
constexpr int Scale = 3;
constexpr int ShotWidth = 100;
constexpr int ShotHeight = 75;

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
  Check(direct.size() == size_t(3) * Scale * Scale * ShotWidth * ShotHeight && steps <= 1,
    what + ": the picture of a large window");
}

//------------------------------------------------------------------------------
using Change = std::function<void(WindowScene&)>;

void TestScreenshot(const std::string& what, const Change& change)
{
  WindowScene large(Scale * ShotWidth, Scale * ShotHeight, 2);
  change(large);
  const Picture direct = Capture(large.Window);
  WindowScene small(ShotWidth, ShotHeight, 2);
  change(small);
  const Picture before = Capture(small.Window);
  CheckShot(what, direct, Shoot(small.Window, false));
  CheckShot(what + ", overlapping tiles", direct, Shoot(small.Window, true));
  Check(Compare(before, Capture(small.Window)) == 0, what + ": the window is as before");
}

//------------------------------------------------------------------------------
// Viewports that tiles cut through, miss and touch. (VTK clears nothing beside viewports in tiles.)
void TestScreenshotOfViewports()
{
  const auto make = [](int scale, bool shoot) {
    WindowScene left(ShotWidth, ShotHeight, 1);
    WindowScene right(ShotWidth, ShotHeight, 2);
    right.Cube->GetProperty()->SetOpacity(0.5);
    const auto window = MakeWindow(scale * ShotWidth, scale * ShotHeight);
    Place(left, window, 0.0, 0.0, 0.4, 1.0);
    Place(right, window, 0.4, 0.0, 1.0, 1.0);
    return shoot ? Shoot(window, false) : Capture(window);
  };
  CheckShot("two viewports", make(Scale, false), make(1, true));
}
}

//------------------------------------------------------------------------------
int TestAirlightPassViewports(int, char*[])
{
  TestSideBySide(false);
  TestSideBySide(true);
  TestSharedActors();
  TestTinyViewports();
  TestTinyWindows();
  TestScreenshot("perspective", [](WindowScene&) {});
  TestScreenshot("parallel projection", [](WindowScene& scene) {
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  });
  TestScreenshot("translucent", [](WindowScene& scene) {
    scene.Cube->GetProperty()->SetOpacity(0.5);
    scene.Medium->SetRegionToUnbounded();
  });
  TestScreenshotOfViewports();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
