// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What keeps a scene on the screen where OpenGL is too old or a frame fails.
 */

#ifndef AirlightErrorRecovery_h
#define AirlightErrorRecovery_h

#include <string>

class vtkOpenGLRenderWindow;

namespace airlight
{
// Whether the window's OpenGL is new enough. False with a reason in `error`.
bool CheckOpenGL(vtkOpenGLRenderWindow* window, std::string& error);

// A frame that fails may end with the state of any of its steps; VTK expects its own.
void RestoreState(vtkOpenGLRenderWindow* window);
}

#endif
