// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightHeadlessWindow.h"

#include "OpenGL/AirlightHeadlessContext.h"

#include "vtkObjectFactory.h"
#if __has_include("vtk_glew.h")
#include "vtk_glew.h" // until VTK 9.3
#endif

#include <cstdlib>
#include <string>

vtkStandardNewMacro(vtkAirlightHeadlessWindow);

//------------------------------------------------------------------------------
vtkAirlightHeadlessWindow::vtkAirlightHeadlessWindow()
{
  this->SetOffScreenRendering(true);
  this->SetFrameBlitModeToNoBlit();
#if !__has_include("vtk_glew.h")
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) { return airlight::HeadlessContext::Find(name); }, nullptr);
#endif
}

//------------------------------------------------------------------------------
vtkAirlightHeadlessWindow::~vtkAirlightHeadlessWindow() { this->Finalize(); }

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::Finalize()
{
  if (this->Context)
  {
    this->Superclass::Finalize();
    this->Context.reset(); // as VTK's windows do; the next frame has a new one
  }
}

//------------------------------------------------------------------------------
int vtkAirlightHeadlessWindow::GetNumberOfDevices()
{
  return airlight::HeadlessContext::CountDevices();
}

//------------------------------------------------------------------------------
int vtkAirlightHeadlessWindow::SupportsOpenGL()
{
  if (!this->Context && !this->Failed)
  {
    std::string problem;
    this->Context = airlight::HeadlessContext::Make(this->DeviceIndex, problem);
    this->Failed = !this->Context;
    if (this->Failed)
    {
      vtkErrorMacro(<< problem);
    }
  }
  return this->Context ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::MakeCurrent()
{
  if (this->SupportsOpenGL())
  {
    this->Context->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
bool vtkAirlightHeadlessWindow::IsCurrent() { return this->Context && this->Context->IsCurrent(); }

//------------------------------------------------------------------------------
vtkTypeBool vtkAirlightHeadlessWindow::IsDirect() { return this->SupportsOpenGL(); }

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::OpenGLInitContext()
{
#if __has_include("vtk_glew.h")
  if (this->Initialized)
  {
    return;
  }
  // GLEW loads OpenGL's functions first and GLX's then, which fails without an X server. That is no
  // harm, but VTK takes it for one.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
  if (!this->GlewInitValid)
  {
    vtkErrorMacro("GLEW could not be initialised: error " << result << ".");
    return;
  }
  this->ContextCreationTime.Modified();
  GLfloat widths[2] = { 1.0f, 1.0f };
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
  this->MaximumHardwareLineWidth = widths[1];
  this->Initialized = true;
#else
  this->Superclass::OpenGLInitContext();
#endif
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::OpenGLInit()
{
  // Not the superclass's: that would undo VTK's initial state, as the depth function.
  this->vtkOpenGLRenderWindow::OpenGLInit(); // NOLINT(bugprone-parent-virtual-call)
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::PushContext()
{
  // Without a context there is nothing that belongs to it.
  if (this->Context)
  {
    this->Context->Push();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::PopContext()
{
  if (this->Context)
  {
    this->Context->Pop();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::Render()
{
  if (!this->SupportsOpenGL())
  {
    return;
  }
  this->MakeCurrent();
  if (!this->Initialized)
  {
    this->OpenGLInitContext(); // the superclass sets OpenGL's state before it loads OpenGL
    this->OpenGLInit();
  }
  // Not the superclass's: that would save and restore all of OpenGL's state, for those whose
  // context it is.
  this->vtkOpenGLRenderWindow::Render(); // NOLINT(bugprone-parent-virtual-call)
  // VTK leaves a frame's context current, and some who draw rely on that. A window of an X server
  // cannot make its own current then.
  const char* display = std::getenv("DISPLAY");
  if (display && *display)
  {
    this->Context->Release();
  }
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << (this->Context ? "made" : "not made") << "\n";
}
