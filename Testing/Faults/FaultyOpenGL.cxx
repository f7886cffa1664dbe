// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyOpenGL.h"

#include <cstddef>
#include <cstring>
#include <dlfcn.h>

namespace
{
using airlight_test::Function;
using airlight_test::Refusal;

// The functions of OpenGL are global, and so are their settings.
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
  unsigned int Error = 0;
} Faults;

// What OpenGL's headers call these. They are not included: each loader has its own.
constexpr unsigned int NoError = 0;
constexpr unsigned int OutOfMemory = 0x0505;
constexpr unsigned int LostContext = 0x0507;
constexpr unsigned int MaxTextureSize = 0x0D33;
constexpr unsigned int MajorVersion = 0x821B;
constexpr unsigned int MinorVersion = 0x821C;
constexpr unsigned int MaxTextureBufferSize = 0x8C2B;
constexpr unsigned int FramebufferUnsupported = 0x8CDD;

// OpenGL's own function: the one that the loader has got, or that of the libraries behind this
// program.
template <typename Type>
struct Real
{
  const char* Name;
  Type* Call = nullptr;

  Type* Get()
  {
    if (!this->Call)
    {
      this->Call = reinterpret_cast<Type*>(dlsym(RTLD_NEXT, this->Name));
    }
    return this->Call;
  }
};

Real<void(unsigned int, std::ptrdiff_t, const void*, unsigned int)> BufferData{ "glBufferData" };
Real<unsigned int(unsigned int)> CheckFramebufferStatus{ "glCheckFramebufferStatus" };
Real<unsigned int()> GetError{ "glGetError" };
Real<void(unsigned int, int*)> GetIntegerv{ "glGetIntegerv" };
Real<void(unsigned int, int, const char* const*, const int*)> ShaderSource{ "glShaderSource" };
Real<void(unsigned int, int, int, int, int, int, unsigned int, unsigned int, const void*)>
  TexImage2D{ "glTexImage2D" };

bool IsRefused(Refusal what) { return Faults.What == what && ++Faults.Calls == Faults.Number; }
}

//------------------------------------------------------------------------------
extern "C"
{
  // The memory of no machine is enough for this: OpenGL itself refuses it.
  __attribute__((visibility("default"))) void glBufferData(
    unsigned int target, std::ptrdiff_t size, const void* data, unsigned int usage)
  {
    const bool refused = IsRefused(Refusal::Buffers);
    BufferData.Get()(
      target, refused ? std::ptrdiff_t(1) << 60 : size, refused ? nullptr : data, usage);
  }

  __attribute__((visibility("default"))) unsigned int glCheckFramebufferStatus(unsigned int target)
  {
    return IsRefused(Refusal::Framebuffers) ? FramebufferUnsupported
                                            : CheckFramebufferStatus.Get()(target);
  }

  __attribute__((visibility("default"))) void glShaderSource(
    unsigned int shader, int count, const char* const* texts, const int* lengths)
  {
    const bool met = !Faults.Word.empty() && count == 1 && !lengths &&
      std::strstr(texts[0], Faults.Word.c_str()) != nullptr;
    Faults.Words += met ? 1 : 0;
    if (met)
    {
      const char* text = "#error refused by the test\n";
      ShaderSource.Get()(shader, 1, &text, nullptr);
      return;
    }
    ShaderSource.Get()(shader, count, texts, lengths);
  }

  // A texture that was refused has no image.
  __attribute__((visibility("default"))) void glTexImage2D(unsigned int target, int level,
    int internalFormat, int width, int height, int border, unsigned int format, unsigned int type,
    const void* pixels)
  {
    auto* const real = TexImage2D.Get();
    if (IsRefused(Refusal::Textures))
    {
      Faults.Error = OutOfMemory;
      real(target, level, internalFormat, 0, 0, border, format, type, nullptr);
      return;
    }
    real(target, level, internalFormat, width, height, border, format, type, pixels);
  }

  __attribute__((visibility("default"))) unsigned int glGetError()
  {
    const unsigned int error = Faults.Lost ? LostContext : Faults.Error;
    Faults.Error = NoError;
    return error != NoError ? error : GetError.Get()();
  }

  __attribute__((visibility("default"))) void glGetIntegerv(unsigned int name, int* values)
  {
    GetIntegerv.Get()(name, values);
    const auto claim = [&](unsigned int what, int value) {
      if (name == what && value > 0)
      {
        *values = value;
      }
    };
    claim(MajorVersion, Faults.Version[0]);
    claim(MinorVersion, Faults.Version[1]);
    claim(MaxTextureSize, Faults.TextureSize);
    claim(MaxTextureBufferSize, Faults.TextureBufferSize);
  }
}

namespace airlight_test
{
//------------------------------------------------------------------------------
Function ReplaceFunction(const char* name, Function real)
{
  Function replaced = real;
  const auto replace = [&](auto& known, auto* faulty) {
    if (real && std::strcmp(name, known.Name) == 0)
    {
      known.Call = reinterpret_cast<decltype(known.Call)>(real);
      replaced = reinterpret_cast<Function>(faulty);
    }
  };
  replace(BufferData, &glBufferData);
  replace(CheckFramebufferStatus, &glCheckFramebufferStatus);
  replace(GetError, &glGetError);
  replace(GetIntegerv, &glGetIntegerv);
  replace(ShaderSource, &glShaderSource);
  replace(TexImage2D, &glTexImage2D);
  return replaced;
}

//------------------------------------------------------------------------------
void Refuse(Refusal what, int number)
{
  Faults.What = what;
  Faults.Number = number;
  Faults.Calls = 0;
  Faults.Error = NoError;
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
