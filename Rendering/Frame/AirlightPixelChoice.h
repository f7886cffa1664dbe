// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pixels of a frame that are drawn, where several processes draw a part of the scene each and
 * composite their pictures by depth: what another process has nearer need not be drawn here.
 *
 * Whoever composites is asked once the depths of the opaque surfaces are there. At the other pixels
 * the depth becomes 0, the nearest (GeometryPass::HideOthers()): that hides shadow planes and
 * colours, and keeps the later steps from drawing (Quad::MaskedDraw). In the picture they are
 * transparent, at the far end.
 */

#ifndef AirlightPixelChoice_h
#define AirlightPixelChoice_h

#include "OpenGL/AirlightPixelArea.h"
#include "Scene/AirlightFrameScene.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <functional>
#include <string>

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

  // Asks, with the depths of the targets, which are bound afterwards. False with a reason in
  // GetError() where the graphics card cannot.
  bool Ask(const FrameScene& scene, Targets& targets, const Chooser& choose);

  // Those that are drawn, for GeometryPass::SetMask().
  vtkTextureObject* GetMask() { return this->Drawn; }

  // The smallest one with all that are drawn.
  const PixelArea& GetArea() const { return this->Area; }

  // Whether any pixels of this frame are left out.
  bool IsSome() const { return this->Some; }
  void Forget() { this->Some = false; }

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window) { this->Drawn->ReleaseGraphicsResources(window); }

private:
  bool Fail(const std::string& reason);

  vtkNew<vtkTextureObject> Drawn;
  PixelArea Area{ 0, 0, 0, 0 };
  bool Some = false;
  std::string Error;
};
}

#endif
