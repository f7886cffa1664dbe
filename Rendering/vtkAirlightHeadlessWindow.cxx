// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlightHeadlessWindow.h"

#include "OpenGL/AirlightHeadlessContext.h"

#include "vtkObjectFactory.h"
#if __has_include("vtk_glew.h")
#include "vtk_glew.h" // until VTK 9.3
#endif

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
vtkAirlightHeadlessWindow::~vtkAirlightHeadlessWindow()
{
  // While there is a context. The superclass would do so without.
  if (this->Context)
  {
    this->Finalize();
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
  this->Initialized = true;
#else
  this->Superclass::OpenGLInitContext();
#endif
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
  this->Context->Release();
}

//------------------------------------------------------------------------------
void vtkAirlightHeadlessWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << (this->Context ? "made" : "not made") << "\n";
}
