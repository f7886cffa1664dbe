// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightTargets.h"

#include "MapperShaders/AirlightSurfaceShader.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
Targets::Targets() = default;
Targets::~Targets() = default;

//------------------------------------------------------------------------------
bool Targets::Allocate(vtkTextureObject* texture, int components, int layers)
{
  const int height = layers * this->Height;
  if (texture->GetHandle() != 0 && texture->GetComponents() != components)
  {
    texture->ReleaseGraphicsResources(this->Window);
  }
  if (texture->GetHandle() == 0)
  {
    texture->SetContext(this->Window);
    texture->SetFormat(components == 1 ? GL_RED : components == 2 ? GL_RG : GL_RGBA);
    texture->SetInternalFormat(components == 1 ? GL_R32F : components == 2 ? GL_RG32F : GL_RGBA32F);
    texture->SetDataType(GL_FLOAT);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->SetWrapS(vtkTextureObject::ClampToEdge);
    texture->SetWrapT(vtkTextureObject::ClampToEdge);
    return texture->Allocate2D(this->Width, height, components, VTK_FLOAT);
  }
  texture->Resize(this->Width, height);
  return true;
}

//------------------------------------------------------------------------------
bool Targets::Prepare(vtkOpenGLRenderWindow* window, int width, int height, const Needs& needs)
{
  const int most = vtkTextureObject::GetMaximumTextureSize(window);
  if (width > most || height > most)
  {
    this->Error = "the viewport of " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels exceeds the largest texture of " + std::to_string(most) +
      ": make the window smaller, and large pictures of tiles with "
      "vtkWindowToImageFilter::SetScale()";
    return false;
  }
  this->Window = window;
  this->Width = width;
  this->Height = height;
  this->Framebuffer->SetContext(window);
  ForgetErrors();
  bool ok = this->Allocate(this->Distances, 1) && this->Allocate(this->Scene, 4) &&
    this->Allocate(this->Scattered, 4) &&
    (needs.SceneLights <= BitsPerChannel || this->Allocate(this->Lit, 4)) &&
    (!needs.Drawn || this->Allocate(this->Drawn, 2)) &&
    (!needs.WithoutLight || this->Allocate(this->WithoutLight, 4)) &&
    (needs.LightLayers == 0 || this->Allocate(this->LightWays, 4, needs.LightLayers));
  if (this->Depth->GetHandle() == 0)
  {
    this->Depth->SetContext(window);
    ok = ok &&
      (window->GetStencilCapable()
          ? this->Depth->AllocateDepthStencil(width, height)
          : this->Depth->AllocateDepth(width, height, vtkTextureObject::Fixed32));
  }
  this->Depth->Resize(width, height);
  if (needs.Record || needs.Radiance)
  {
    ok = ok && this->Allocate(this->Radiance, 4);
  }
  if (needs.Record)
  {
    ok = ok && this->Allocate(this->Counts, 4) && this->Allocate(this->Single, 4) &&
      this->Allocate(this->Airlight, 4) && this->Allocate(this->Surface, 4) &&
      this->Allocate(this->Transmittance, 4);
  }
  if (needs.Several)
  {
    ok = ok && this->Allocate(this->SeveralOfLights, 4) && this->Allocate(this->Several, 4);
  }
  ok = ok && !IsOutOfMemory();
  this->Error = ok ? ""
                   : "no memory on the graphics card for textures of " + std::to_string(width) +
      " x " + std::to_string(height) + " pixels: make the window smaller";
  return ok;
}

//------------------------------------------------------------------------------
bool Targets::Bind(const std::vector<vtkTextureObject*>& colours, vtkTextureObject* depth)
{
  this->Framebuffer->Bind();
  const int count = static_cast<int>(colours.size());
  for (int i = 0; i < std::max(count, this->ColourCount); ++i)
  {
    if (i < count)
    {
      this->Framebuffer->AddColorAttachment(i, colours[i]);
    }
    else
    {
      this->Framebuffer->RemoveColorAttachment(i);
    }
  }
  this->ColourCount = count;
  if (depth)
  {
    this->Framebuffer->AddDepthAttachment(depth);
  }
  else
  {
    this->Framebuffer->RemoveDepthAttachment();
  }
  if (count > 0)
  {
    this->Framebuffer->ActivateDrawBuffers(count);
    this->Framebuffer->ActivateReadBuffer(0);
  }
  else
  {
    this->Framebuffer->DeactivateDrawBuffers();
    this->Framebuffer->DeactivateReadBuffer();
  }
  const int width = count > 0 ? static_cast<int>(colours[0]->GetWidth()) : this->Width;
  const int height = count > 0 ? static_cast<int>(colours[0]->GetHeight()) : this->Height;
  this->Framebuffer->StartNonOrtho(width, height);
  vtkOpenGLState* state = this->Window->GetState();
  this->DrawInto(count);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  const char* description = "";
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, description))
  {
    this->Error = std::string("the graphics card cannot draw into its floating-point textures (") +
      description + "): make the window smaller, update the graphics driver, or use another";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// VTK's record of the draw buffers outlives the framebuffer that had them, and the next one that
// asks for as many would not get them.
void Targets::DrawInto(int count)
{
  unsigned int buffers[8] = { GL_NONE };
  for (int i = 0; i < count && i < 8; ++i)
  {
    buffers[i] = GL_COLOR_ATTACHMENT0 + i;
  }
  this->Window->GetState()->vtkglDrawBuffers(8, buffers);
}

//------------------------------------------------------------------------------
void Targets::Clear(float colour, float alpha)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(colour, colour, colour, alpha);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
}

//------------------------------------------------------------------------------
void Targets::ClearDepth()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
}

//------------------------------------------------------------------------------
vtkOpenGLFramebufferObject* Targets::GetFramebuffer() { return this->Framebuffer; }

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Targets::Read(
  unsigned int attachment, int firstComponent, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Width, this->Height, 1);
  image->AllocateScalars(VTK_FLOAT, components);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  std::vector<float> pixels(4 * static_cast<size_t>(this->Width) * this->Height);
  this->Framebuffer->ActivateReadBuffer(attachment);
  // Rows of four floats need no alignment set, and VTK's record of it would not know.
  glReadPixels(0, 0, this->Width, this->Height, GL_RGBA, GL_FLOAT, pixels.data());
  for (size_t i = 0; i < pixels.size() / 4; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      out[components * i + c] = pixels[4 * i + firstComponent + c];
    }
  }
  return image;
}

//------------------------------------------------------------------------------
void Targets::Release(vtkWindow* window)
{
  for (vtkTextureObject* texture :
    { this->Distances.Get(), this->Drawn.Get(), this->Depth.Get(), this->LightWays.Get(),
      this->Scene.Get(), this->WithoutLight.Get(), this->Scattered.Get(), this->Lit.Get(),
      this->Counts.Get(), this->Single.Get(), this->SeveralOfLights.Get(), this->Several.Get(),
      this->Radiance.Get(), this->Airlight.Get(), this->Surface.Get(), this->Transmittance.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->ColourCount = 0;
}
}
