// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightScenePass.h"

#include "vtkObjectFactory.h"
#include "vtkRenderState.h"

vtkStandardNewMacro(AirlightScenePass);

//------------------------------------------------------------------------------
void AirlightScenePass::PrepareLights(vtkRenderer* renderer)
{
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
}

//------------------------------------------------------------------------------
void AirlightScenePass::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->ClearLights(renderer);
  this->PrepareLights(renderer);
  this->UpdateGeometry(renderer, s->GetFrameBuffer());
}
