// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Knows which window's OpenGL objects the pass has. They are freed while that window can still do
 * it: before its context goes, and before the pass draws in another window.
 */

#ifndef AirlightContext_h
#define AirlightContext_h

#include "vtkTextureObject.h"

#include <functional>

class vtkWindow;

// VTK tells its own OpenGL objects alone when a context goes, so this is one, a texture without
// texels.
class AirlightContext : public vtkTextureObject
{
public:
  static AirlightContext* New();
  vtkTypeMacro(AirlightContext, vtkTextureObject);

  // What frees the objects; called with their window, whose context is current. It is called when
  // SetContext() gets another window or null, too.
  void SetRelease(const std::function<void(vtkWindow*)>& release) { this->Free = release; }

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  AirlightContext();
  ~AirlightContext() override;

private:
  AirlightContext(const AirlightContext&) = delete;
  void operator=(const AirlightContext&) = delete;

  std::function<void(vtkWindow*)> Free;
};

#endif
