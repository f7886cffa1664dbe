// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenGL's functions, from whichever loader this VTK uses (GLEW before 9.4, glad since).
 */

#ifndef AirlightOpenGL_h
#define AirlightOpenGL_h

#include "vtkObject.h" // which vtkOpenGLError.h uses
#include "vtkOpenGLError.h"

// glMemoryBarrier() stands before whatever reads what shaders wrote to storage buffers. No test
// fails without these calls: software renderers, on which the tests run, finish one draw before the
// next. Graphics cards need not.

namespace airlight
{
// Before a call whose own errors matter. A context that is lost, or none, gives errors without end.
inline void ForgetErrors()
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}

// Memory of a storage buffer, with its content unless `data` is null. False where it is refused.
inline bool AllocateStorage(GLuint buffer, GLsizeiptr bytes, const void* data, GLenum usage)
{
  ForgetErrors();
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, data, usage);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return glGetError() == GL_NO_ERROR;
}

// Bytes of a buffer that shaders see as one block, which drivers bound: Mesa's software renderer to
// 128 MiB.
inline GLint64 GetLargestStorageBlock()
{
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  return most;
}

inline bool AllocateStorageBlock(GLuint buffer, GLsizeiptr bytes, const void* data, GLenum usage)
{
  return bytes <= GetLargestStorageBlock() && AllocateStorage(buffer, bytes, data, usage);
}

// Frees a buffer that there is. Without one there may be no context, and no function to call.
inline void DeleteBuffer(GLuint& buffer)
{
  if (buffer != 0)
  {
    glDeleteBuffers(1, &buffer);
    buffer = 0;
  }
}

// The same of a vertex array.
inline void DeleteVertexArray(GLuint& array)
{
  if (array != 0)
  {
    glDeleteVertexArrays(1, &array);
    array = 0;
  }
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
