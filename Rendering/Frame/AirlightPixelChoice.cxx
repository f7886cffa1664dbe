// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightPixelChoice.h"

#include "AirlightHidingFS.h"
#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
namespace
{
PixelArea FindArea(const std::vector<unsigned char>& drawn, int width, int height)
{
  glm::ivec2 low(width, height);
  glm::ivec2 high(0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      if (drawn[static_cast<size_t>(y) * width + x] != 0)
      {
        low = glm::min(low, glm::ivec2(x, y));
        high = glm::max(high, glm::ivec2(x + 1, y + 1));
      }
    }
  }
  const glm::ivec2 size = glm::max(high - low, 0);
  return { low.x, low.y, size.x, size.y };
}

std::string GetHidingSource() { return std::string("#version 330\n") + AirlightHidingFS; }
}

//------------------------------------------------------------------------------
bool PixelChoice::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool PixelChoice::Apply(
  vtkOpenGLRenderWindow* window, Targets& targets, int width, int height, const Chooser& choose)
{
  if (!targets.Bind({ targets.Distances }, targets.Depth))
  {
    return this->Fail(targets.GetError());
  }
  const size_t count = static_cast<size_t>(width) * height;
  std::vector<float> depths(count);
  std::vector<unsigned char> drawn(count, 1);
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  if (!choose(width, height, depths.data(), drawn.data()))
  {
    return true;
  }
  this->Drawn->SetContext(window);
  if (!this->Drawn->Create2DFromRaw(width, height, 1, VTK_UNSIGNED_CHAR, drawn.data()))
  {
    return this->Fail("the texture of pixels left out could not be made");
  }
  if (!this->HidingQuad.GetOrCompile(window, GetHidingSource()))
  {
    return this->Fail(std::string("the shader of pixels left out") + ProgramMaker::GetReason());
  }
  this->Area = FindArea(drawn, width, height);
  this->Some = true;
  this->Hide(window);
  return true;
}

//------------------------------------------------------------------------------
void PixelChoice::Hide(vtkOpenGLRenderWindow* window)
{
  if (this->Some && this->HidingQuad.GetOrCompile(window, GetHidingSource()))
  {
    this->HidingQuad.DrawDepths(window->GetState(), { { "drawn", this->Drawn } });
  }
}

//------------------------------------------------------------------------------
void PixelChoice::Release(vtkWindow* window)
{
  this->HidingQuad.Release();
  this->Drawn->ReleaseGraphicsResources(window);
}
}
