// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightFrame.h"

#include "AirlightCompositeFS.h"
#include "AirlightOpenGL.h"
#include "AirlightViewShader.h"

#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool Frame::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool Frame::Upload(vtkOpenGLRenderWindow* window, const std::vector<Texels>& arrays)
{
  return this->Data.Update(window, arrays) || this->Fail(this->Data.GetError());
}

//------------------------------------------------------------------------------
bool Frame::Begin(vtkRenderer* renderer, const f64::AirlightMedia& media,
  const std::vector<Lamp>& lamps, const View& view, const FrameSettings& settings, int width,
  int height)
{
  this->Renderer = renderer;
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Media = media;
  this->Lamps = lamps;
  this->Rays = view;
  this->Settings = settings;
  this->Width = width;
  this->Height = height;
  if (!this->Textures.Prepare(this->Window, width, height, settings.Record))
  {
    return this->Fail(this->Textures.GetError());
  }
  if (settings.Shadows &&
    !this->Boundaries.Prepare(this->Window, width, height, settings.MemoryLimit))
  {
    return this->Fail(this->Boundaries.GetError());
  }
  return true;
}

//------------------------------------------------------------------------------
void Frame::ClearTarget(float value)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(value, value, value, value);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

//------------------------------------------------------------------------------
bool Frame::BindDistances()
{
  if (!this->Textures.Bind({ this->Textures.Distances }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->ClearTarget(-1.0f);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::BindScene()
{
  if (!this->Textures.Bind({ this->Textures.Scene }, this->Textures.Depth))
  {
    return this->Fail(this->Textures.GetError());
  }
  // What a layer above others does not draw stays transparent.
  this->ClearTarget(0.0f);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkTextureObject*> Frame::GetScatterTargets()
{
  std::vector<vtkTextureObject*> targets = { this->Textures.Scattered, this->Textures.Lit };
  if (this->Settings.Record)
  {
    targets.push_back(this->Textures.Counts);
    targets.push_back(this->Textures.Single);
  }
  return targets;
}

//------------------------------------------------------------------------------
bool Frame::ScatterLights()
{
  if (!this->Textures.Bind(this->GetScatterTargets(), nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->ClearTarget(0.0f);
  this->Buffers.clear();
  const std::vector<Caster>* casters =
    this->Settings.Shadows ? &this->Casters.Collect(this->Renderer) : nullptr;
  this->Volumes.resize(this->Lamps.size());
  for (size_t k = 0; k < this->Lamps.size(); ++k)
  {
    const Lamp& lamp = this->Lamps[k];
    if (lamp.Scatters() && lamp.CastsShadows && casters &&
      this->Volumes[k].Update(*casters, lamp.World, *this->Rays))
    {
      this->Boundaries.SetVolumes(static_cast<int>(k), this->Volumes[k]);
    }
    if (lamp.Scatters() && !this->ScatterLight(static_cast<int>(k)))
    {
      return false;
    }
    if (this->Settings.Record && !this->RecordSingle(static_cast<int>(k)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads one light's airlight and clears its target for the next one.
bool Frame::RecordSingle(int index)
{
  if (!this->Textures.Bind({ this->Textures.Single }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Buffers["Airlight:" + std::to_string(index)] = this->Textures.Read(0, 0, 3);
  this->ClearTarget(0.0f);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::ReadyComposite(bool record, int x, int y)
{
  const std::string source = std::string("#version 330\n") + (record ? RecordDefinition : "") +
    GetScatteringSource(this->Media, AIRLIGHT_POINT_CLOSED, false) + AirlightViewShader +
    AirlightCompositeFS;
  Quad& quad = record ? this->RecordQuad : this->CompositeQuad;
  vtkShaderProgram* program = quad.Ready(this->Window, source);
  if (!program)
  {
    return this->Fail("the composite shader did not compile: " + quad.GetError());
  }
  SetMediaUniforms(program, "media", this->Media);
  this->Rays->SetUniforms(program, x, y);
  if (record)
  {
    program->SetUniformf("error", ClosedFormError);
  }
  return true;
}

//------------------------------------------------------------------------------
void Frame::DrawComposite(Quad& quad)
{
  quad.Draw({ { "distances", this->Textures.Distances }, { "scene", this->Textures.Scene },
    { "sceneDepth", this->Textures.Depth }, { "scattered", this->Textures.Scattered },
    { "airlightData", this->Data.GetTexture() },
    { "counts", &quad == &this->RecordQuad ? this->Textures.Counts.Get() : nullptr } });
}

//------------------------------------------------------------------------------
bool Frame::Composite(int x, int y, bool blend)
{
  // Where the target's viewport does not begin at 0, gl_FragCoord does not either.
  if (!this->ReadyComposite(false, x, y))
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglViewport(x, y, this->Width, this->Height);
  state->vtkglScissor(x, y, this->Width, this->Height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  if (blend)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
  {
    state->vtkglDisable(GL_BLEND);
  }
  this->DrawComposite(this->CompositeQuad);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  return true;
}

//------------------------------------------------------------------------------
bool Frame::Record()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (!this->ReadyComposite(true, 0, 0))
  {
    return false;
  }
  if (!this->Textures.Bind({ this->Textures.Radiance, this->Textures.Airlight,
                             this->Textures.Surface, this->Textures.Transmittance },
        nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->DrawComposite(this->RecordQuad);
  this->Buffers["Radiance"] = this->Textures.Read(0, 0, 3);
  this->Buffers["Airlight"] = this->Textures.Read(1, 0, 3);
  this->Buffers["Surface"] = this->Textures.Read(2, 0, 3);
  this->Buffers["Transmittance"] = this->Textures.Read(3, 0, 3);
  this->Buffers["ErrorBound"] = this->Textures.Read(1, 3, 1);
  if (!this->Textures.Bind(
        { this->Textures.Scattered, this->Textures.Counts, this->Textures.Distances }, nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->Buffers["LitLength"] = this->Textures.Read(0, 3, 1);
  this->Buffers["BoundaryCount"] = this->Textures.Read(1, 0, 1);
  this->Buffers["Depth"] = this->Textures.Read(2, 0, 1);
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* Frame::GetBuffer(const std::string& name)
{
  const auto it = this->Buffers.find(name);
  return it != this->Buffers.end() ? it->second.Get() : nullptr;
}

//------------------------------------------------------------------------------
SurfaceUniforms Frame::GetSurfaceUniforms(SurfaceStage stage)
{
  SurfaceUniforms values;
  values.Stage = stage;
  values.Rays = &*this->Rays;
  values.Media = &this->Media;
  values.Lamps = &this->Lamps;
  values.Lit = this->Textures.Lit;
  values.Data = this->Data.GetTexture();
  values.Glow = this->Settings.SurfaceGlow;
  values.UseLit = this->Settings.Shadows && this->Settings.SurfaceShadows;
  return values;
}

//------------------------------------------------------------------------------
void Frame::Release(vtkWindow* window)
{
  for (Quad& quad : this->ResolveQuads)
  {
    quad.Release();
  }
  this->CompositeQuad.Release();
  this->RecordQuad.Release();
  this->Boundaries.Release();
  this->Casters.Clear();
  this->Volumes.clear();
  this->Textures.Release(window);
  this->Data.Release(window);
}
}
