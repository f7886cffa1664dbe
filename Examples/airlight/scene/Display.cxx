// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Display.h"

#include "formats/UserError.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cstdlib>
#include <string>

#ifdef AIRLIGHT_HAS_X11
#include <X11/Xlib.h>
#endif

namespace airlight
{

//------------------------------------------------------------------------------
void CheckDisplay()
{
#ifdef AIRLIGHT_HAS_X11
  vtkNew<vtkRenderWindow> window;
  if (!window->IsA("vtkXOpenGLRenderWindow"))
  {
    return; // VTK was built for another window system, or for none
  }
  Display* display = XOpenDisplay(nullptr);
  if (!display)
  {
    const char* name = std::getenv("DISPLAY");
    throw UserError(std::string("no X server to render with (DISPLAY=") + (name ? name : "") +
      "); without a screen, run under: xvfb-run -a -s \"-noreset -screen 0 1280x1024x24\"");
  }
  XCloseDisplay(display);
#endif
}

}
