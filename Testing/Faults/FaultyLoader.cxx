// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The ways by which a loader gets the addresses of OpenGL's functions. GLEW is linked with
// glXGetProcAddressARB() or eglGetProcAddress(). glad opens libGL or libEGL and looks for these two
// there: it is given this program instead, whose functions come first.

#include "FaultyOpenGL.h"

#include <cstring>
#include <dlfcn.h>

using airlight_test::Function;

extern "C"
{
  Function glXGetProcAddress(const char* name);
  Function glXGetProcAddressARB(const char* name);
  Function eglGetProcAddress(const char* name);
}

namespace
{
template <typename Type>
Type FindNext(const char* name)
{
  return reinterpret_cast<Type>(dlsym(RTLD_NEXT, name));
}

// glad looks for the getters by themselves, too.
Function Replace(const char* name, Function real)
{
  if (std::strcmp(name, "glXGetProcAddress") == 0)
  {
    return reinterpret_cast<Function>(glXGetProcAddress);
  }
  if (std::strcmp(name, "glXGetProcAddressARB") == 0)
  {
    return reinterpret_cast<Function>(glXGetProcAddressARB);
  }
  if (std::strcmp(name, "eglGetProcAddress") == 0)
  {
    return reinterpret_cast<Function>(eglGetProcAddress);
  }
  return airlight_test::ReplaceFunction(name, real);
}

bool IsOpenGL(const char* library)
{
  for (const char* name : { "libGL.so", "libEGL.so" })
  {
    if (library && std::strncmp(library, name, std::strlen(name)) == 0)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
extern "C"
{
  __attribute__((visibility("default"))) Function glXGetProcAddress(const char* name)
  {
    static auto* const real = FindNext<Function (*)(const char*)>("glXGetProcAddress");
    return Replace(name, real(name));
  }

  __attribute__((visibility("default"))) Function glXGetProcAddressARB(const char* name)
  {
    static auto* const real = FindNext<Function (*)(const char*)>("glXGetProcAddressARB");
    return Replace(name, real(name));
  }

  __attribute__((visibility("default"))) Function eglGetProcAddress(const char* name)
  {
    static auto* const real = FindNext<Function (*)(const char*)>("eglGetProcAddress");
    return Replace(name, real(name));
  }

  // With RTLD_GLOBAL the library's functions are found behind this program's.
  __attribute__((visibility("default"))) void* dlopen(const char* name, int mode) noexcept
  {
    static auto* const real = FindNext<void* (*)(const char*, int)>("dlopen");
    if (!IsOpenGL(name))
    {
      return real(name, mode);
    }
    return real(name, mode | RTLD_GLOBAL) ? real(nullptr, RTLD_NOW) : nullptr;
  }
}
