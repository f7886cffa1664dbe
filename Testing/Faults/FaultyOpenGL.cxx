// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyOpenGL.h"

#include "vtk_glew.h"

#include <cstring>
#include <dlfcn.h>

namespace
{
using airlighttest::Refusal;

// The functions of OpenGL are global, and so is what they are told.
struct
{
  Refusal What = Refusal::None;
  int Number = 0;
  int Calls = 0;
  std::string Word;
  int Words = 0;
  int Version[2] = {};
  int TextureSize = 0;
  int TextureBufferSize = 0;
  bool Lost = false;
  GLenum Error = GL_NO_ERROR;
} Faults;

PFNGLBUFFERDATAPROC BufferData = nullptr;
PFNGLCHECKFRAMEBUFFERSTATUSPROC CheckFramebufferStatus = nullptr;
PFNGLSHADERSOURCEPROC ShaderSource = nullptr;

constexpr GLenum LostContext = 0x0507; // GL_CONTEXT_LOST

bool IsRefused(Refusal what) { return Faults.What == what && ++Faults.Calls == Faults.Number; }

// OpenGL's own function.
template <typename Function>
Function* Find(Function*, const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// The memory of no machine is enough for this: OpenGL itself refuses it.
void GLAPIENTRY FaultyBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  const bool refused = IsRefused(Refusal::Buffers);
  BufferData(target, refused ? GLsizeiptr(1) << 60 : size, refused ? nullptr : data, usage);
}

GLenum GLAPIENTRY FaultyCheckFramebufferStatus(GLenum target)
{
  return IsRefused(Refusal::Framebuffers) ? GL_FRAMEBUFFER_UNSUPPORTED
                                          : CheckFramebufferStatus(target);
}

void GLAPIENTRY FaultyShaderSource(
  GLuint shader, GLsizei count, const GLchar* const* texts, const GLint* lengths)
{
  const bool met = !Faults.Word.empty() && count == 1 && !lengths &&
    std::strstr(texts[0], Faults.Word.c_str()) != nullptr;
  Faults.Words += met ? 1 : 0;
  if (met)
  {
    const GLchar* text = "#error refused by the test\n";
    ShaderSource(shader, 1, &text, nullptr);
    return;
  }
  ShaderSource(shader, count, texts, lengths);
}
}

//------------------------------------------------------------------------------
extern "C"
{
  // A texture that was refused has no image.
  __attribute__((visibility("default"))) void GLAPIENTRY glTexImage2D(GLenum target, GLint level,
    GLint internalFormat, GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
    const void* pixels)
  {
    static auto* real = Find(&glTexImage2D, "glTexImage2D");
    if (IsRefused(Refusal::Textures))
    {
      Faults.Error = GL_OUT_OF_MEMORY;
      real(target, level, internalFormat, 0, 0, border, format, type, nullptr);
      return;
    }
    real(target, level, internalFormat, width, height, border, format, type, pixels);
  }

  __attribute__((visibility("default"))) GLenum GLAPIENTRY glGetError()
  {
    static auto* real = Find(&glGetError, "glGetError");
    const GLenum error = Faults.Lost ? LostContext : Faults.Error;
    Faults.Error = GL_NO_ERROR;
    return error != GL_NO_ERROR ? error : real();
  }

  __attribute__((visibility("default"))) void GLAPIENTRY glGetIntegerv(GLenum name, GLint* values)
  {
    static auto* real = Find(&glGetIntegerv, "glGetIntegerv");
    real(name, values);
    const auto claim = [&](GLenum what, int value) {
      if (name == what && value > 0)
      {
        *values = value;
      }
    };
    claim(GL_MAJOR_VERSION, Faults.Version[0]);
    claim(GL_MINOR_VERSION, Faults.Version[1]);
    claim(GL_MAX_TEXTURE_SIZE, Faults.TextureSize);
    claim(GL_MAX_TEXTURE_BUFFER_SIZE, Faults.TextureBufferSize);
  }
}

namespace airlighttest
{
//------------------------------------------------------------------------------
void InstallFaults()
{
  if (__glewBufferData == FaultyBufferData)
  {
    return;
  }
  BufferData = __glewBufferData;
  CheckFramebufferStatus = __glewCheckFramebufferStatus;
  ShaderSource = __glewShaderSource;
  __glewBufferData = FaultyBufferData;
  __glewCheckFramebufferStatus = FaultyCheckFramebufferStatus;
  __glewShaderSource = FaultyShaderSource;
}

//------------------------------------------------------------------------------
void Refuse(Refusal what, int number)
{
  Faults.What = what;
  Faults.Number = number;
  Faults.Calls = 0;
  Faults.Error = GL_NO_ERROR;
}

int CountCalls() { return Faults.Calls; }

//------------------------------------------------------------------------------
int RefuseShaders(const std::string& word)
{
  const int met = Faults.Words;
  Faults.Word = word;
  Faults.Words = 0;
  return met;
}

//------------------------------------------------------------------------------
void ClaimVersion(int major, int minor)
{
  Faults.Version[0] = major;
  Faults.Version[1] = minor;
}

void ClaimTextureSize(int most) { Faults.TextureSize = most; }

void ClaimTextureBufferSize(int most) { Faults.TextureBufferSize = most; }

void LoseContext(bool lost) { Faults.Lost = lost; }
}
