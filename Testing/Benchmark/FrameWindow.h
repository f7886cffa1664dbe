// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameWindow_h
#define FrameWindow_h

#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <string>

namespace benchmarks
{
/**
 * Makes windows off screen, with an X server or, through EGL, without: VTK's own EGL windows are
 * left out of most builds of VTK 9.1.
 */
class WindowMaker
{
public:
  // Throws std::runtime_error that says what to do where EGL has no device that draws with OpenGL;
  // without `egl`, where no X server is named.
  explicit WindowMaker(bool egl);

  vtkSmartPointer<vtkRenderWindow> Make(int width, int height) const;

private:
  bool IsEgl;
};

/**
 * Who draws.
 */
struct OpenGLNames
{
  std::string Vendor;
  std::string Renderer;
  std::string Version;
  bool IsSoftware; // one of Mesa's renderers that run on the processors
};

// Draws an empty frame, before which VTK does not know.
OpenGLNames GetOpenGLNames(vtkRenderWindow* window);
}

#endif
