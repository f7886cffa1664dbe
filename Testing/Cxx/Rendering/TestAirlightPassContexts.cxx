// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass in windows that share nothing: a pass for each, one that moves between them, and
// windows whose OpenGL context goes and comes back.

#include "AirlightTestWindowScene.h"

using namespace airlight_test;

namespace
{
// Two scenes that differ in size, lamps and what their shaders need.
struct First : WindowScene
{
  First()
    : WindowScene(120, 90, 1)
  {
  }
};

struct Second : WindowScene
{
  Second()
    : WindowScene(100, 80, 2)
  {
    this->Cube->GetProperty()->SetOpacity(0.5);
    this->Look({ 5, 2, 8 }, { 0, 0, 0 });
    this->Renderer->UseFXAAOn();
  }
};

void CheckPicture(const Picture& expected, vtkRenderWindow* window, const std::string& what)
{
  const int steps = Compare(expected, Capture(window));
  std::cout << what << ": differs by " << steps << "/255\n";
  Check(steps == 0, what + ": the same picture");
}

//------------------------------------------------------------------------------
void TestAlternately(const Picture& first, const Picture& second)
{
  First a;
  Second b;
  for (int frame = 0; frame < 4; ++frame)
  {
    CheckPicture(first, a.Window, "alternately, first window");
    CheckPicture(second, b.Window, "alternately, second window");
  }
}

//------------------------------------------------------------------------------
// One pass that is taken from one window and given to another, there and back.
void TestMoved(const Picture& first, const Picture& second)
{
  First a;
  Second b;
  for (int round = 0; round < 2; ++round)
  {
    b.Renderer->SetPass(nullptr);
    a.Renderer->SetPass(a.Pass);
    CheckPicture(first, a.Window, "pass moved, first window");
    a.Renderer->SetPass(nullptr);
    b.Renderer->SetPass(a.Pass);
    CheckPicture(second, b.Window, "pass moved, second window");
  }
  // What is without the pass is drawn plain and undisturbed.
  First plain;
  plain.Renderer->SetPass(nullptr);
  CheckPicture(Capture(plain.Window), a.Window, "window that the pass has left");
}

// One pass in two windows at once.
void TestShared(const Picture& first, const Picture& second)
{
  First a;
  Second b;
  b.Renderer->SetPass(a.Pass);
  for (int frame = 0; frame < 3; ++frame)
  {
    CheckPicture(first, a.Window, "shared pass, first window");
    CheckPicture(second, b.Window, "shared pass, second window");
  }
}

//------------------------------------------------------------------------------
// The pass lives longer than the window that it drew in.
void TestWindowGone(const Picture& first)
{
  vtkNew<vtkAirlightPass> pass;
  {
    Second gone;
    pass->SetMedium(gone.Medium);
    gone.Renderer->SetPass(pass);
    gone.Window->Render();
    gone.Renderer->SetPass(nullptr);
  }
  First a;
  pass->SetMedium(a.Medium);
  a.Renderer->SetPass(pass);
  CheckPicture(first, a.Window, "after another window has gone");
}

// `attached`: the renderer has the pass when the context goes.
void TestFinalized(const Picture& first, bool attached)
{
  const std::string what = attached ? "finalised" : "finalised without the pass";
  First a;
  Second other;
  other.Window->Render();
  for (int round = 0; round < 3; ++round)
  {
    CheckPicture(first, a.Window, what + ", round " + std::to_string(round));
    if (!attached)
    {
      a.Renderer->SetPass(nullptr);
    }
    a.Window->Finalize();
    a.Renderer->SetPass(a.Pass);
  }
  // Freed in the wrong context, its numbers would have been another window's objects.
  Second fresh;
  CheckPicture(Capture(fresh.Window), other.Window, what + ", another window");
}

//------------------------------------------------------------------------------
// The context goes after frames without casters: nothing of it may be left for the next one.
// `moved`: the pass goes to another window instead.
void TestGoneWithoutCasters(const Picture& first, bool moved)
{
  const std::string what =
    moved ? "moved after a frame without casters" : "finalised after a frame without casters";
  First a;
  const auto show = [&a](bool visible) {
    for (vtkActor* actor : { a.Floor, a.Ball, a.Cube })
    {
      actor->SetVisibility(visible);
    }
  };
  show(false);
  a.Window->Render();
  show(true);
  if (!moved)
  {
    a.Window->Finalize();
    CheckPicture(first, a.Window, what);
    return;
  }
  First b;
  a.Renderer->SetPass(nullptr);
  b.Renderer->SetPass(a.Pass);
  CheckPicture(first, b.Window, what);
}

//------------------------------------------------------------------------------
// A window on the screen shows what one beside it does. With AIRLIGHT_TEST_EGL there is no screen.
void TestOnScreen(const Picture& first)
{
  First a;
  if (a.Window->IsA("vtkAirlightHeadlessWindow"))
  {
    return;
  }
  a.Window->SetOffScreenRendering(0);
  a.Window->Render();
  Check(a.Window->GetMapped() != 0, "the window is on the screen");
  CheckPicture(first, a.Window, "window on the screen");
  a.Window->SetOffScreenRendering(1);
  CheckPicture(first, a.Window, "the same window off the screen");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassContexts(int, char*[])
{
  Picture first;
  Picture second;
  {
    First a;
    first = Capture(a.Window);
    Second b;
    second = Capture(b.Window);
  }
  Check(ShowsScene(first) && ShowsScene(second), "something is seen");
  TestAlternately(first, second);
  TestMoved(first, second);
  TestShared(first, second);
  TestWindowGone(first);
  TestFinalized(first, true);
  TestFinalized(first, false);
  TestGoneWithoutCasters(first, false);
  TestGoneWithoutCasters(first, true);
  TestOnScreen(first);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
