// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef EglWindow_h
#define EglWindow_h

class vtkRenderWindow;

namespace benchmarks
{
/**
 * Makes an OpenGL context on the first of EGL's devices that offers one, graphics cards before
 * software, for the rest of the process. Throws std::runtime_error where there is none.
 */
void StartEgl();

/**
 * A window that draws with the context of StartEgl(). The caller owns it.
 */
vtkRenderWindow* MakeEglWindow();
}

#endif
