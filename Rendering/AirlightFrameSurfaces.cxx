// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the shaders of the scene's surfaces are told of a frame.

#include "AirlightFrame.h"

#include "AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

namespace airlight
{
//------------------------------------------------------------------------------
void Frame::SetMapRays(const View* rays, int x, int y)
{
  this->MapRays = rays;
  this->MapX = x;
  this->MapY = y;
}

//------------------------------------------------------------------------------
SurfaceUniforms Frame::GetSurfaceUniforms(SurfaceStage stage)
{
  SurfaceUniforms values;
  values.Stage = stage;
  values.Rays = this->MapRays ? this->MapRays : &*this->Rays;
  values.ViewportX = this->MapRays ? this->MapX : 0;
  values.ViewportY = this->MapRays ? this->MapY : 0;
  values.Width = this->Width;
  values.Height = this->Height;
  values.VolumeNodes = this->Settings.VolumeNodes;
  values.Media = &this->Media;
  values.Lamps = &this->Lamps;
  values.Lit = this->Textures.Lit;
  values.Data = this->Data.GetTexture();
  values.Glow = this->Settings.SurfaceGlow;
  values.EncodedInput = this->Settings.EncodedInput;
  values.Records = this->Settings.LayerRecords ? &this->LayerLists : nullptr;
  values.Dims = &this->SurfaceDimming;
  // Without records the bits are those of the opaque surface, which lies behind the layers.
  values.UseLit = this->Settings.Shadows != ShadowMethod::None && this->Settings.SurfaceShadows &&
    (stage != SurfaceStage::Layer || values.Records);
  return values;
}

//------------------------------------------------------------------------------
void Frame::FitToTarget(SurfaceUniforms& values)
{
  for (vtkTextureObject* texture : { values.Lit, values.Data })
  {
    if (texture)
    {
      texture->Activate();
    }
  }
  int viewport[4];
  this->Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[0] == 0 && viewport[1] == 0 && viewport[2] == this->Width &&
    viewport[3] == this->Height)
  {
    return;
  }
  const View target(this->Renderer, viewport[2], viewport[3]);
  if (target.IsValid())
  {
    values.ViewportX = viewport[0];
    values.ViewportY = viewport[1];
    values.Pixels = this->Rays->GetPixelsFrom(target);
  }
}
}
