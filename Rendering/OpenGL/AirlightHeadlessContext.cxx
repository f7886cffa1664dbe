// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightHeadlessContext.h"

#if defined(__unix__) && __has_include(<EGL/eglext.h>)
#define AIRLIGHT_HAS_EGL 1
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#endif

#include <algorithm>
#include <cstring>

namespace airlight
{
#ifdef AIRLIGHT_HAS_EGL
namespace
{
// Sets a pointer to the function of that name in a library that is open.
struct Finder
{
  template <typename Function>
  void operator()(Function& function, const char* name) const
  {
    function = reinterpret_cast<Function>(dlsym(this->Opened, name));
  }
  void* Opened;
};

// The functions of libEGL. All are null where it is missing or too old.
class Library
{
public:
  static const Library& Get()
  {
    static const Library library;
    return library;
  }

  bool IsComplete() const { return this->GetPlatformDisplay && this->QueryDevices; }

  PFNEGLGETPROCADDRESSPROC GetProcAddress = nullptr;
  PFNEGLQUERYDEVICESEXTPROC QueryDevices = nullptr;
  PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay = nullptr;
  PFNEGLINITIALIZEPROC Initialize = nullptr;
  PFNEGLBINDAPIPROC BindAPI = nullptr;
  PFNEGLCHOOSECONFIGPROC ChooseConfig = nullptr;
  PFNEGLCREATEPBUFFERSURFACEPROC CreatePbufferSurface = nullptr;
  PFNEGLDESTROYSURFACEPROC DestroySurface = nullptr;
  PFNEGLCREATECONTEXTPROC CreateContext = nullptr;
  PFNEGLDESTROYCONTEXTPROC DestroyContext = nullptr;
  PFNEGLMAKECURRENTPROC MakeCurrent = nullptr;
  PFNEGLGETCURRENTCONTEXTPROC GetCurrentContext = nullptr;
  PFNEGLGETCURRENTDISPLAYPROC GetCurrentDisplay = nullptr;
  PFNEGLGETCURRENTSURFACEPROC GetCurrentSurface = nullptr;

private:
  Library()
  {
    // Stays open until the process ends, as contexts may.
    void* opened = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!opened)
    {
      return;
    }
    const Finder find{ opened };
    find(this->GetProcAddress, "eglGetProcAddress");
    find(this->Initialize, "eglInitialize");
    find(this->BindAPI, "eglBindAPI");
    find(this->ChooseConfig, "eglChooseConfig");
    find(this->CreatePbufferSurface, "eglCreatePbufferSurface");
    find(this->DestroySurface, "eglDestroySurface");
    find(this->CreateContext, "eglCreateContext");
    find(this->DestroyContext, "eglDestroyContext");
    find(this->MakeCurrent, "eglMakeCurrent");
    find(this->GetCurrentContext, "eglGetCurrentContext");
    find(this->GetCurrentDisplay, "eglGetCurrentDisplay");
    find(this->GetCurrentSurface, "eglGetCurrentSurface");
    const auto extension = [this](auto& function, const char* name) {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(this->GetProcAddress(name));
    };
    extension(this->QueryDevices, "eglQueryDevicesEXT");
    extension(this->QueryDeviceString, "eglQueryDeviceStringEXT");
    extension(this->GetPlatformDisplay, "eglGetPlatformDisplayEXT");
  }
};

// The functions of libGLX, if this process has opened it. MakeCurrent is null where it has not.
class GLX
{
public:
  GLX()
  {
    void* opened = dlopen("libGLX.so.0", RTLD_LAZY | RTLD_NOLOAD);
    opened = opened ? opened : dlopen("libGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
    if (!opened)
    {
      return;
    }
    const Finder find{ opened };
    find(this->GetCurrentDisplay, "glXGetCurrentDisplay");
    find(this->GetCurrentDrawable, "glXGetCurrentDrawable");
    find(this->GetCurrentContext, "glXGetCurrentContext");
    find(this->MakeCurrent, "glXMakeCurrent");
    dlclose(opened); // those who draw with it keep it open
  }

  void* (*GetCurrentDisplay)() = nullptr;
  unsigned long (*GetCurrentDrawable)() = nullptr;
  void* (*GetCurrentContext)() = nullptr;
  int (*MakeCurrent)(void*, unsigned long, void*) = nullptr;
};

// A thread has one current context, and EGL refuses to make one current while there is one of GLX.
void ReleaseGLX()
{
  const GLX glx;
  void* display = glx.MakeCurrent ? glx.GetCurrentDisplay() : nullptr;
  if (display)
  {
    glx.MakeCurrent(display, 0, nullptr);
  }
}

// Graphics cards first.
std::vector<EGLDeviceEXT> FindDevices()
{
  const Library& egl = Library::Get();
  EGLint count = 0;
  if (!egl.IsComplete() || !egl.QueryDevices(0, nullptr, &count) || count <= 0)
  {
    return {};
  }
  std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
  egl.QueryDevices(count, devices.data(), &count);
  devices.resize(static_cast<size_t>(std::max(count, 0)));
  std::stable_partition(devices.begin(), devices.end(), [&egl](EGLDeviceEXT device) {
    const char* extensions =
      egl.QueryDeviceString ? egl.QueryDeviceString(device, EGL_EXTENSIONS) : nullptr;
    return !extensions || !std::strstr(extensions, "EGL_MESA_device_software");
  });
  return devices;
}

// Some drivers give exactly the version that they are asked for. VTK needs the core profile.
EGLContext MakeNewest(EGLDisplay display, EGLConfig config)
{
  const EGLint versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 3, 3 }, { 3, 2 } };
  for (const auto& version : versions)
  {
    const EGLint wanted[] = { EGL_CONTEXT_MAJOR_VERSION, version[0], EGL_CONTEXT_MINOR_VERSION,
      version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    EGLContext context = Library::Get().CreateContext(display, config, EGL_NO_CONTEXT, wanted);
    if (context != EGL_NO_CONTEXT)
    {
      return context;
    }
  }
  return EGL_NO_CONTEXT;
}
}

//------------------------------------------------------------------------------
std::unique_ptr<HeadlessContext> HeadlessContext::Make(int device, std::string& problem)
{
  const Library& egl = Library::Get();
  if (!egl.IsComplete())
  {
    problem = egl.GetProcAddress
      ? "The library libEGL of this system finds no devices (EGL_EXT_device_enumeration): install "
        "a "
        "newer driver or Mesa, or draw under an X server, for instance with xvfb-run."
      : "The library libEGL.so.1 is missing: install it (Debian and Ubuntu: libegl1 and "
        "libegl-mesa0), or draw under an X server, for instance with xvfb-run.";
    return nullptr;
  }
  const std::vector<EGLDeviceEXT> devices = FindDevices();
  if (device < 0 || static_cast<size_t>(device) >= devices.size())
  {
    problem = devices.empty()
      ? "EGL has no device: install a driver (Mesa's software renderer, Debian and Ubuntu: "
        "libegl-mesa0), and let this user open /dev/dri or /dev/nvidia*."
      : "EGL has no device " + std::to_string(device) + ": choose one from 0 to " +
        std::to_string(devices.size() - 1) + ".";
    return nullptr;
  }
  problem = "EGL's device " + std::to_string(device) +
    " gives no context of OpenGL 3.2 or later: choose another device, install the driver of the "
    "graphics card, or let this user open /dev/dri or /dev/nvidia*.";
  EGLDisplay display =
    egl.GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(device)], nullptr);
  if (display == EGL_NO_DISPLAY || !egl.Initialize(display, nullptr, nullptr) ||
    !egl.BindAPI(EGL_OPENGL_API))
  {
    return nullptr;
  }
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_NONE };
  const EGLint size[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!egl.ChooseConfig(display, wanted, &config, 1, &count) || count == 0)
  {
    return nullptr;
  }
  std::unique_ptr<HeadlessContext> made(new HeadlessContext);
  made->Display = display;
  made->Surface = egl.CreatePbufferSurface(display, config, size);
  made->Context = MakeNewest(display, config);
  if (!made->MakeCurrent())
  {
    return nullptr;
  }
  problem.clear();
  return made;
}

//------------------------------------------------------------------------------
HeadlessContext::~HeadlessContext()
{
  const Library& egl = Library::Get();
  if (!egl.IsComplete())
  {
    return;
  }
  this->Release();
  if (this->Context != EGL_NO_CONTEXT)
  {
    egl.DestroyContext(this->Display, this->Context);
  }
  if (this->Surface != EGL_NO_SURFACE)
  {
    egl.DestroySurface(this->Display, this->Surface);
  }
}

//------------------------------------------------------------------------------
int HeadlessContext::CountDevices() { return static_cast<int>(FindDevices().size()); }

//------------------------------------------------------------------------------
HeadlessContext::Function HeadlessContext::Find(const char* name)
{
  return Library::Get().GetProcAddress ? Library::Get().GetProcAddress(name) : nullptr;
}

//------------------------------------------------------------------------------
bool HeadlessContext::MakeCurrent() const
{
  ReleaseGLX();
  return this->Context != EGL_NO_CONTEXT &&
    Library::Get().MakeCurrent(this->Display, this->Surface, this->Surface, this->Context) ==
    EGL_TRUE;
}

//------------------------------------------------------------------------------
void HeadlessContext::Release() const
{
  if (this->IsCurrent())
  {
    Library::Get().MakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

//------------------------------------------------------------------------------
HeadlessContext::Current HeadlessContext::GetCurrent()
{
  const GLX glx;
  Current current;
  current.Display = glx.MakeCurrent ? glx.GetCurrentDisplay() : nullptr;
  if (current.Display)
  {
    current.Drawable = glx.GetCurrentDrawable();
    current.Context = glx.GetCurrentContext();
    return current;
  }
  const Library& egl = Library::Get();
  if (egl.IsComplete())
  {
    current.Display = egl.GetCurrentDisplay();
    current.Surface = egl.GetCurrentSurface(EGL_DRAW);
    current.Context = egl.GetCurrentContext();
  }
  return current;
}

//------------------------------------------------------------------------------
void HeadlessContext::Push()
{
  this->Before.push_back(GetCurrent());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void HeadlessContext::Pop()
{
  if (this->Before.empty())
  {
    return;
  }
  const Current before = this->Before.back();
  this->Before.pop_back();
  this->Release();
  if (before.Drawable)
  {
    GLX().MakeCurrent(before.Display, before.Drawable, before.Context);
  }
  else if (before.Context)
  {
    Library::Get().MakeCurrent(before.Display, before.Surface, before.Surface, before.Context);
  }
}

//------------------------------------------------------------------------------
bool HeadlessContext::IsCurrent() const
{
  return this->Context != EGL_NO_CONTEXT && Library::Get().GetCurrentContext() == this->Context;
}
#else
//------------------------------------------------------------------------------
std::unique_ptr<HeadlessContext> HeadlessContext::Make(int, std::string& problem)
{
  problem = "This Airlight was built without EGL, which Linux has: use vtkRenderWindow.";
  return nullptr;
}

//------------------------------------------------------------------------------
HeadlessContext::~HeadlessContext() = default;
int HeadlessContext::CountDevices() { return 0; }
HeadlessContext::Function HeadlessContext::Find(const char*) { return nullptr; }
bool HeadlessContext::MakeCurrent() const { return false; }
void HeadlessContext::Release() const {}
void HeadlessContext::Push() {}
void HeadlessContext::Pop() {}
bool HeadlessContext::IsCurrent() const { return false; }
#endif
}
