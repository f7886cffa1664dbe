// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightEdgeMean.h"

#include "AirlightEdgesFS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace airlight
{
namespace
{
// A step between neighbours that is not above this is no edge: at most half of it is lost. In the
// dark a staircase of 8 is seen.
constexpr float Contrast = 3.0f / 255.0f;
}

//------------------------------------------------------------------------------
glm::dvec2 EdgeMean::GetOffset(int number)
{
  constexpr double offsets[SampleCount][2] = { { 0.0, 0.0 }, { 0.112, 0.405 }, { -0.407, -0.105 },
    { 0.295, -0.300 } };
  return { offsets[number][0], offsets[number][1] };
}

//------------------------------------------------------------------------------
bool EdgeMean::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool EdgeMean::Begin(vtkOpenGLRenderWindow* window, int width, int height)
{
  this->Window = window;
  this->Width = width;
  this->Height = height;
  if (!this->Textures.Prepare(window, width, height, {}))
  {
    return this->Fail(this->Textures.GetError());
  }
  ForgetErrors();
  bool ok = true;
  if (this->Mask->GetHandle() == 0)
  {
    this->Mask->SetContext(window);
    ok = this->Mask->AllocateDepth(width, height, vtkTextureObject::Fixed32);
  }
  this->Mask->Resize(width, height);
  return (ok && !IsOutOfMemory()) ||
    this->Fail("no memory on the graphics card for the edges of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels: make the window smaller, or call MultisamplingOff()");
}

//------------------------------------------------------------------------------
bool EdgeMean::Bind(vtkTextureObject* colour, vtkTextureObject* depth)
{
  return this->Textures.Bind({ colour }, depth) || this->Fail(this->Textures.GetError());
}

//------------------------------------------------------------------------------
bool EdgeMean::BindFirst()
{
  if (!this->Bind(this->Textures.Scene, this->Textures.Depth))
  {
    return false;
  }
  // In upper layers the frame is blended over what is here.
  this->Textures.Clear(0.0f);
  this->Textures.ClearDepth();
  return true;
}

bool EdgeMean::BindSample(float weight)
{
  glBlendColor(0.0f, 0.0f, 0.0f, weight);
  return this->Bind(this->Textures.Scene, this->Mask);
}

void EdgeMean::EndSamples() { glBlendColor(0.0f, 0.0f, 0.0f, 0.0f); }

//------------------------------------------------------------------------------
bool EdgeMean::FindEdges(const DisplayStage& display, bool blend)
{
  vtkShaderProgram* program = this->EdgesQuad.GetOrCompile(this->Window,
    "#version 330\n" + Define("AIRLIGHT_BLENDED", blend) +
      Define("AIRLIGHT_TONE_MAPPING", static_cast<int>(display.Curve)) +
      Define("AIRLIGHT_COLOR_SPACE", static_cast<int>(display.Space)) + AirlightEdgesFS);
  if (!program)
  {
    return this->Fail(std::string("the shader that finds edges") + ProgramMaker::GetReason());
  }
  if (!this->Textures.Bind({}, this->Mask))
  {
    return this->Fail(this->Textures.GetError());
  }
  program->SetUniformf("airlightExposure", static_cast<float>(display.Exposure));
  program->SetUniformf("contrast", Contrast);
  this->EdgesQuad.DrawDepths(this->Window->GetState(), { { "radiances", this->Textures.Scene } });
  return true;
}

//------------------------------------------------------------------------------
bool EdgeMean::ReadMask(std::vector<float>& mask)
{
  if (!this->Bind(this->Textures.Scene, this->Mask))
  {
    return false;
  }
  mask.resize(static_cast<size_t>(this->Width) * this->Height);
  glReadPixels(0, 0, this->Width, this->Height, GL_DEPTH_COMPONENT, GL_FLOAT, mask.data());
  return true;
}

//------------------------------------------------------------------------------
bool EdgeMean::DrawIntoViewport(const glm::ivec4& viewport, const DisplayStage& display, bool blend)
{
  const MeanPicture::Mean mean{ this->Textures.Scene, this->Textures.Depth,
    { viewport.x, viewport.y } };
  return this->Picture.DrawIntoViewport(this->Window, mean, viewport, display, blend) ||
    this->Fail(MeanPicture::GetError());
}

//------------------------------------------------------------------------------
void EdgeMean::Release(vtkWindow* window)
{
  this->EdgesQuad.Release();
  this->Picture.Release();
  this->Textures.Release(window);
  this->Mask->ReleaseGraphicsResources(window);
}
}
