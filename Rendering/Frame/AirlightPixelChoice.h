// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pixels of a frame that are drawn, where several processes draw a part of the scene each and
 * composite their pictures by depth: what another process has nearer need not be drawn here.
 *
 * Whoever composites is asked once the depths of the opaque surfaces are there. At the other pixels
 * the depth becomes 0, the nearest: that hides shadow planes and colours, and keeps the later steps
 * from drawing (Quad::MaskedDraw). In the picture they are transparent, at the far end.
 */

#ifndef AirlightPixelChoice_h
#define AirlightPixelChoice_h

#include "OpenGL/AirlightPixelArea.h"
#include "OpenGL/AirlightQuad.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace airlight
{
class Targets;

class PixelChoice
{
public:
  // vtkAirlightPass::PixelChooser.
  using Chooser =
    std::function<bool(int width, int height, const float* depths, unsigned char* drawn)>;

  // Asks, and hides the others in the depth of the targets. False with a reason in GetError() where
  // the graphics card cannot.
  bool Apply(
    vtkOpenGLRenderWindow* window, Targets& targets, int width, int height, const Chooser& choose);

  // Hides them in the depth that is bound, if the frame has any.
  void Hide(vtkOpenGLRenderWindow* window);

  // The smallest one with all that are drawn.
  const PixelArea& GetArea() const { return this->Area; }

  // Whether any pixels of this frame are left out.
  bool IsSome() const { return this->Some; }
  void Forget() { this->Some = false; }

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

private:
  bool Fail(const std::string& reason);

  Quad HidingQuad;
  vtkNew<vtkTextureObject> Drawn;
  PixelArea Area{ 0, 0, 0, 0 };
  bool Some = false;
  std::string Error;
};
}

#endif
