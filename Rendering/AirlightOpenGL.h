// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL's functions, from whichever loader this VTK uses (GLEW before 9.4, glad since).
 */

#ifndef AirlightOpenGL_h
#define AirlightOpenGL_h

#include "vtkObject.h" // which vtkOpenGLError.h uses
#include "vtkOpenGLError.h"

#endif
