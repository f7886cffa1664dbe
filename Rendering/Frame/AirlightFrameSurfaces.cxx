// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the scene's surfaces are drawn, and what their shaders are told of a frame.

#include "Frame/AirlightFrame.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool Frame::BindScene()
{
  if (!this->Textures.Bind({ this->Textures.Scene }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  // What a layer above others does not draw stays transparent.
  this->ClearTarget(0.0f);
  this->BlendColours();
  return true;
}

//------------------------------------------------------------------------------
void Frame::BlendColours()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

//------------------------------------------------------------------------------
bool Frame::BindSceneAndDistances()
{
  std::vector<vtkTextureObject*> targets = { this->Textures.Scene, this->Textures.Distances };
  if (this->Plan.ShadowingLight >= 0)
  {
    targets.push_back(this->Textures.WithoutLight);
  }
  if (!this->Textures.Bind(targets, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Window->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float none[4] = { -1.0f, 0.0f, 0.0f, 0.0f };
  glClearBufferfv(GL_COLOR, 1, none);
  this->Textures.DrawInto(1);
  // What the background does not clear.
  const bool erases = this->Renderer->GetErase() && this->Window->GetErase();
  if (!erases || this->Renderer->Transparent())
  {
    this->ClearTarget(0.0f);
  }
  if (!erases || this->Renderer->GetPreserveDepthBuffer())
  {
    this->ClearDepth();
  }
  this->BlendColours();
  this->Window->GetState()->vtkglDepthFunc(GL_LEQUAL);
  return true;
}

//------------------------------------------------------------------------------
// What is in the dark picture where no surface is nobody reads. To blend is more work, and may
// round what an opaque fragment writes.
void Frame::BeginSurfaces()
{
  if (this->Plan.SingleGeometryPass)
  {
    this->Textures.DrawInto(this->Plan.ShadowingLight >= 0 ? 3 : 2);
  }
  if (this->Plan.AllOpaque)
  {
    this->Window->GetState()->vtkglDisable(GL_BLEND);
  }
  else if (this->Plan.SingleGeometryPass)
  {
    glDisablei(GL_BLEND, 1); // distances
  }
}

//------------------------------------------------------------------------------
void Frame::EndSurfaces()
{
  if (this->Plan.AllOpaque)
  {
    this->Window->GetState()->vtkglEnable(GL_BLEND);
  }
  else if (this->Plan.SingleGeometryPass)
  {
    glEnablei(GL_BLEND, 1); // as VTK's record has it
  }
}

//------------------------------------------------------------------------------
void Frame::SetMapRays(const CameraUniforms* rays, int x, int y)
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
  values.VolumeNodes = this->Plan.VolumeNodes;
  values.Media = &this->Media;
  values.SceneLights = &this->SceneLights;
  values.Lit = this->Textures.Scattered;
  values.MoreLit = this->HasMoreLit() ? this->Textures.Lit : this->Textures.Scattered;
  values.Data = this->Data.GetTexture();
  values.ScatteredIrradiance = this->Plan.ScatteredSurfaceLight;
  values.EncodedInput = this->Plan.EncodedInput;
  values.Records = this->Plan.TranslucentFragments ? &this->FragmentLists : nullptr;
  values.Transmittances = &this->SurfaceTransmittance;
  // Without records the bits are those of the opaque surface, which lies behind the layers.
  values.UseLit = this->Plan.Shadows != ShadowMethod::None && this->Plan.SurfaceShadows &&
    (stage != SurfaceStage::Translucent ? !this->Plan.SingleGeometryPass
                                        : values.Records != nullptr);
  return values;
}

//------------------------------------------------------------------------------
void Frame::FitToTarget(SurfaceUniforms& values)
{
  for (vtkTextureObject* texture : values.GetTextures())
  {
    texture->Activate();
  }
  int viewport[4];
  this->Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[0] == 0 && viewport[1] == 0 && viewport[2] == this->Width &&
    viewport[3] == this->Height)
  {
    return;
  }
  const CameraUniforms target(this->Renderer, viewport[2], viewport[3]);
  if (target.IsValid())
  {
    values.ViewportX = viewport[0];
    values.ViewportY = viewport[1];
    values.Pixels = this->Rays->GetPixelsFrom(target);
  }
}
}
