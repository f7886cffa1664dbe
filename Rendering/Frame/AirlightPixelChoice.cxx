// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightPixelChoice.h"

#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"

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
}

//------------------------------------------------------------------------------
bool PixelChoice::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool PixelChoice::Ask(const FrameScene& scene, Targets& targets, const Chooser& choose)
{
  if (!targets.Bind({ targets.Distances }, targets.Depth))
  {
    return this->Fail(targets.GetError());
  }
  const size_t count = static_cast<size_t>(scene.Width) * scene.Height;
  std::vector<float> depths(count);
  std::vector<unsigned char> drawn(count, 1);
  glReadPixels(0, 0, scene.Width, scene.Height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  if (!choose(scene.Width, scene.Height, depths.data(), drawn.data()))
  {
    return true;
  }
  this->Drawn->SetContext(scene.Window);
  if (!this->Drawn->Create2DFromRaw(scene.Width, scene.Height, 1, VTK_UNSIGNED_CHAR, drawn.data()))
  {
    return this->Fail("the texture of pixels left out could not be made");
  }
  this->Area = FindArea(drawn, scene.Width, scene.Height);
  this->Some = true;
  return true;
}
}
