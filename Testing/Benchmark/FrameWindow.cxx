// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameWindow.h"

#include "vtkAirlightHeadlessWindow.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <cstdlib>
#include <stdexcept>

namespace benchmarks
{
//------------------------------------------------------------------------------
WindowMaker::WindowMaker(bool egl)
  : IsEgl(egl)
{
  if (egl)
  {
    if (!vtkNew<vtkAirlightHeadlessWindow>()->SupportsOpenGL())
    {
      throw std::runtime_error("--egl: there is no context of OpenGL; VTK's message says why");
    }
    return;
  }
  // VTK would end the program in its first frame.
  const char* display = std::getenv("DISPLAY");
  if (vtkNew<vtkRenderWindow>()->IsA("vtkXOpenGLRenderWindow") && (!display || !*display))
  {
    throw std::runtime_error(
      "DISPLAY names no X server; take --egl, or run under: xvfb-run -a -s \"-noreset\"");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> WindowMaker::Make(int width, int height) const
{
  vtkSmartPointer<vtkRenderWindow> window;
  if (this->IsEgl)
  {
    window = vtkSmartPointer<vtkAirlightHeadlessWindow>::New();
  }
  else
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
  }
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

//------------------------------------------------------------------------------
OpenGLNames GetOpenGLNames(vtkRenderWindow* window)
{
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->Render();
  window->RemoveRenderer(renderer);
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(window)->GetState();
  OpenGLNames names = { state->GetVendor(), state->GetRenderer(), state->GetVersion(), false };
  for (const char* software : { "llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer" })
  {
    names.IsSoftware = names.IsSoftware || names.Renderer.find(software) != std::string::npos;
  }
  return names;
}
}
