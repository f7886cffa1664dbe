// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The delegate that vtkAirlightPass uses when it is given none: all that a renderer without a pass
 * would draw.
 */

#ifndef AirlightScenePass_h
#define AirlightScenePass_h

#include "vtkRenderPass.h"

class AirlightScenePass : public vtkRenderPass
{
public:
  static AirlightScenePass* New();
  vtkTypeMacro(AirlightScenePass, vtkRenderPass);

  void Render(const vtkRenderState* s) override;

  // Brings the lights of the renderer into place (headlights and camera lights follow the camera)
  // and into its mappers.
  void PrepareLights(vtkRenderer* renderer);

protected:
  AirlightScenePass() = default;
  ~AirlightScenePass() override = default;

private:
  AirlightScenePass(const AirlightScenePass&) = delete;
  void operator=(const AirlightScenePass&) = delete;
};

#endif
