// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL's functions, from whichever loader this VTK uses (GLEW before 9.4, glad since).
 */

#ifndef AirlightOpenGL_h
#define AirlightOpenGL_h

#include "vtkObject.h" // which vtkOpenGLError.h uses
#include "vtkOpenGLError.h"

namespace airlight
{
// Before a call whose own errors matter. A context that is lost, or none, gives errors without end.
inline void ForgetErrors()
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

// Memory of a storage buffer, and what is in it where there is something. False where it is refused.
inline bool AllocateStorage(GLuint buffer, GLsizeiptr bytes, const void* data, GLenum usage)
{
  ForgetErrors();
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, data, usage);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return glGetError() == GL_NO_ERROR;
}

// After one that may have been refused. VTK's own calls in between may make other errors.
inline bool IsOutOfMemory()
{
  constexpr GLenum lostContext = 0x0507; // GL_CONTEXT_LOST, which old headers lack
  const GLenum error = glGetError();
  return error == GL_OUT_OF_MEMORY || error == lostContext;
}
}

#endif
