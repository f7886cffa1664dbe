// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws with a pass, and then brings the background a little before the far end of the depth
 * buffer. IceT takes no pixels from that end: the medium before an empty background would be lost.
 */

#ifndef AirlightFarPass_h
#define AirlightFarPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <memory>

class vtkOpenGLQuadHelper;

class AirlightFarPass : public vtkRenderPass
{
public:
  static AirlightFarPass* New();
  vtkTypeMacro(AirlightFarPass, vtkRenderPass);

  void SetDelegate(vtkRenderPass* delegate);
  // Off, it only draws with the delegate.
  void SetMoves(bool moves) { this->Moves = moves; }

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  AirlightFarPass();
  ~AirlightFarPass() override;
  AirlightFarPass(const AirlightFarPass&) = delete;
  void operator=(const AirlightFarPass&) = delete;

  vtkSmartPointer<vtkRenderPass> Delegate;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  bool Moves = false;
};

#endif
