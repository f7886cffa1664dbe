// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Renders with a delegate, and then moves the background slightly in front of the far end of the
 * depth buffer. IceT ignores pixels at that end, and would lose the medium in front of an empty
 * background.
 */

#ifndef AirlightFarPass_h
#define AirlightFarPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>

class vtkOpenGLQuadHelper;

class AirlightFarPass : public vtkRenderPass
{
public:
  static AirlightFarPass* New();
  vtkTypeMacro(AirlightFarPass, vtkRenderPass);

  void SetDelegate(vtkRenderPass* delegate);
  // If off, it only renders with the delegate.
  void SetMoves(bool moves) { this->Moves = moves; }
  // Called between the two.
  void SetRendered(const std::function<void()>& rendered) { this->Rendered = rendered; }

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  AirlightFarPass();
  ~AirlightFarPass() override;
  AirlightFarPass(const AirlightFarPass&) = delete;
  void operator=(const AirlightFarPass&) = delete;

  vtkSmartPointer<vtkRenderPass> Delegate;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::function<void()> Rendered;
  bool Moves = false;
};

#endif
