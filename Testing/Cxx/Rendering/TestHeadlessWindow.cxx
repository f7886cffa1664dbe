// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightHeadlessWindow: the pictures of VTK's own windows, several at a time, and a device
// that is not there.

#include "AirlightTestErrors.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightHeadlessWindow.h"

using namespace airlight_test;

namespace
{
vtkSmartPointer<vtkAirlightHeadlessWindow> MakeHeadless(int width, int height)
{
  auto window = vtkSmartPointer<vtkAirlightHeadlessWindow>::New();
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

// The scene in a window of its own size.
Picture DrawIn(vtkRenderWindow* window, WindowScene& scene)
{
  Place(scene, window, 0, 0, 1, 1);
  return Capture(window);
}

void TestSamePictures(const Picture& expected)
{
  WindowScene scene;
  const auto window = MakeHeadless(120, 90);
  Check(window->GetNumberOfDevices() >= 1, "a device");
  Check(DrawIn(window, scene) == expected, "the bytes of VTK's own window");
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  Check(major * 10 + minor >= 43, "OpenGL 4.3 or later");
}

void TestSeveral(const Picture& expected)
{
  WindowScene first;
  WindowScene second;
  const auto window = MakeHeadless(120, 90);
  {
    const auto other = MakeHeadless(120, 90);
    Check(DrawIn(window, first) == expected, "first of two windows");
    Check(DrawIn(other, second) == expected, "second of two windows");
    Check(Capture(window) == expected, "first again");
  }
  Check(Capture(window) == expected, "once the second is gone");
}

void TestMissingDevice()
{
  WindowScene scene;
  const auto window = MakeHeadless(120, 90);
  window->SetDeviceIndex(window->GetNumberOfDevices());
  ErrorListener errors(window);
  Place(scene, window, 0, 0, 1, 1);
  window->Render();
  Check(errors.Take() == 1, "one error");
  Check(
    errors.GetText().find("EGL has no device") != std::string::npos, "that says what is missing");
  window->Render();
  Check(window->SupportsOpenGL() == 0 && errors.Take() == 0, "the error comes once");
}
}

//------------------------------------------------------------------------------
int TestHeadlessWindow(int, char*[])
{
  WindowScene scene;
  const Picture expected = DrawIn(MakeWindow(120, 90), scene);
  Check(ShowsScene(expected), "something is seen");
  TestSamePictures(expected);
  TestSeveral(expected);
  TestMissingDevice();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
