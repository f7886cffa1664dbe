// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EglWindow.h"

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkObjectFactory.h"
#include "vtk_glew.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace benchmarks
{
namespace
{
struct EglContext
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLSurface Surface = EGL_NO_SURFACE;
  EGLContext Context = EGL_NO_CONTEXT;

  bool MakeCurrent() const
  {
    return eglMakeCurrent(this->Display, this->Surface, this->Surface, this->Context) == EGL_TRUE;
  }
};

// Contexts belong to the process, and so does an EGL display.
EglContext& GetContext()
{
  static EglContext context;
  return context;
}

template <typename Function>
Function Find(const char* name)
{
  const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (!function)
  {
    throw std::runtime_error(std::string("--egl: this EGL lacks ") + name +
      "; leave --egl out and give the program an X server");
  }
  return function;
}

// Graphics cards first.
std::vector<EGLDeviceEXT> FindDevices()
{
  const auto queryDevices = Find<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto queryString = Find<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  EGLint count = 0;
  queryDevices(0, nullptr, &count);
  std::vector<EGLDeviceEXT> devices(static_cast<size_t>(std::max(count, 0)));
  queryDevices(count, devices.data(), &count);
  devices.resize(static_cast<size_t>(std::max(count, 0)));
  std::stable_partition(devices.begin(), devices.end(), [queryString](EGLDeviceEXT device) {
    const char* extensions = queryString(device, EGL_EXTENSIONS);
    return !extensions || !std::strstr(extensions, "EGL_MESA_device_software");
  });
  return devices;
}

// An OpenGL context of the core profile, as VTK's other windows ask for: drivers give the newest
// version. The surface is never drawn into.
bool Start(EGLDeviceEXT device, EglContext& context)
{
  const auto getDisplay = Find<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  context.Display = getDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  if (context.Display == EGL_NO_DISPLAY || !eglInitialize(context.Display, nullptr, nullptr) ||
    !eglBindAPI(EGL_OPENGL_API))
  {
    return false;
  }
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_NONE };
  const EGLint profile[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  const EGLint size[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(context.Display, wanted, &config, 1, &count) || count == 0)
  {
    return false;
  }
  context.Surface = eglCreatePbufferSurface(context.Display, config, size);
  context.Context = eglCreateContext(context.Display, config, EGL_NO_CONTEXT, profile);
  return context.MakeCurrent();
}

//------------------------------------------------------------------------------
// A window of VTK that was given its context from outside.
class EglWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static EglWindow* New();
  vtkTypeMacro(EglWindow, vtkGenericOpenGLRenderWindow);

  void MakeCurrent() override { GetContext().MakeCurrent(); }
  bool IsCurrent() override { return eglGetCurrentContext() == GetContext().Context; }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }

  // As VTK's other windows: the superclass would save and restore all of OpenGL's state, for those
  // whose context it is.
  void Render() override
  {
    if (!this->Initialized)
    {
      this->OpenGLInit();
    }
    this->vtkOpenGLRenderWindow::Render(); // NOLINT(bugprone-parent-virtual-call)
  }

  // GLEW loads OpenGL's functions first and GLX's then, which fails without an X server. That is
  // no harm, but VTK takes it for one.
  void OpenGLInitContext() override
  {
    const GLenum result = glewInit();
    this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    if (!this->GlewInitValid)
    {
      vtkErrorMacro("GLEW could not be initialised: error " << result << ".");
      return;
    }
    this->ContextCreationTime.Modified();
    this->Initialized = true;
  }

protected:
  EglWindow() { this->SetFrameBlitModeToNoBlit(); }
};

vtkStandardNewMacro(EglWindow);
}

//------------------------------------------------------------------------------
void StartEgl()
{
  if (GetContext().MakeCurrent())
  {
    return; // has been started
  }
  for (const EGLDeviceEXT device : FindDevices())
  {
    if (Start(device, GetContext()))
    {
      return;
    }
  }
  throw std::runtime_error(
    "--egl: no device of EGL draws with OpenGL; is the graphics card's driver "
    "installed, and this user allowed to open /dev/dri or /dev/nvidia*?");
}

//------------------------------------------------------------------------------
vtkRenderWindow* MakeEglWindow() { return EglWindow::New(); }
}
