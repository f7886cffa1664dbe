// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// In place of EglWindow.cxx where EGL or VTK's GLEW is missing.

#include "EglWindow.h"

#include <stdexcept>

namespace benchmarks
{
//------------------------------------------------------------------------------
void StartEgl()
{
  throw std::runtime_error("--egl: this program was built without EGL; leave --egl out and give it "
                           "an X server, or build it with EGL's headers and a VTK 9.1 to 9.3");
}

//------------------------------------------------------------------------------
vtkRenderWindow* MakeEglWindow() { return nullptr; } // after StartEgl() only
}
