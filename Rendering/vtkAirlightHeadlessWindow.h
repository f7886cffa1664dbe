// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightHeadlessWindow
 * @brief   a render window without a screen, with the newest OpenGL that a device gives
 *
 * For servers, containers and tests. The pictures of this window are read with
 * vtkWindowToImageFilter or from the buffers of vtkAirlightPass.
 * @code
 *   vtkNew<vtkAirlightHeadlessWindow> window;
 *   window->SetSize(800, 600);
 *   window->AddRenderer(renderer);
 *   window->Render();
 * @endcode
 * The window has a context of its own, made by EGL: of OpenGL 4.6, or of the next older version
 * down to 3.2. VTK's own windows ask for 3.2, and some drivers then give exactly that, with which
 * vtkAirlightPass has no shadow planes (they need 4.3).
 *
 * Errors: where there is no context, one error says why and names the remedy, SupportsOpenGL()
 * returns 0, and Render() renders nothing.
 *
 * Platforms: those with EGL, as Linux. Elsewhere each window is an error.
 *
 * @sa vtkAirlightPass vtkEGLRenderWindow
 */

#ifndef vtkAirlightHeadlessWindow_h
#define vtkAirlightHeadlessWindow_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkGenericOpenGLRenderWindow.h"

#include <memory> // for the context

namespace airlight
{
class HeadlessContext;
}

class VTKAIRLIGHT_EXPORT vtkAirlightHeadlessWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkAirlightHeadlessWindow* New();
  vtkTypeMacro(vtkAirlightHeadlessWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The number of devices that EGL finds. 0 where EGL is missing. SetDeviceIndex() chooses the one
   * that draws, before the window is used; they are counted from 0 (default): graphics cards first,
   * in EGL's order, then software.
   */
  int GetNumberOfDevices() override;

  ///@{
  /**
   * What VTK asks of a window. The first makes the context, Finalize() ends it.
   */
  int SupportsOpenGL() override;
  void MakeCurrent() override;
  bool IsCurrent() override;
  vtkTypeBool IsDirect() override;
  void Finalize() override;
  void OpenGLInitContext() override;
  void OpenGLInit() override;
  void PushContext() override;
  void PopContext() override;
  void Render() override;
  ///@}

protected:
  vtkAirlightHeadlessWindow();
  ~vtkAirlightHeadlessWindow() override;

private:
  vtkAirlightHeadlessWindow(const vtkAirlightHeadlessWindow&) = delete;
  void operator=(const vtkAirlightHeadlessWindow&) = delete;

  bool Failed = false;
  std::unique_ptr<airlight::HeadlessContext> Context;
};

#endif
