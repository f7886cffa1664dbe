// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What media leave of the lights on their ways to the surfaces of all pixels.
 *
 * A way through an image, or a closed surface, is a walk of hundreds of steps. Here it is made once
 * for each pixel, in a step of the full screen. In the shaders of mappers it would be made for each
 * fragment of each triangle; and as graphics processors, and software renderers more so, shade
 * groups of pixels, triangles of a pixel take several times as long.
 */

#ifndef AirlightLightWaysPass_h
#define AirlightLightWaysPass_h

#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightFrameScene.h"

#include <string>
#include <vector>

namespace airlight
{
class LightWaysPass
{
public:
  // Draws a layer of the targets' texture, above another, for each of so many lights: the first
  // ones that the media dim. False with a reason in GetError() where OpenGL refuses.
  bool Draw(const FrameScene& scene, int layers, Targets& targets);
  const std::string& GetError() const { return this->Error; }

  // For each light of the scene its layer, or -1: the mappers' shaders walk the ways of the others.
  static std::vector<int> GetLayers(const FrameScene& scene, int count);

  void Release() { this->Ways.Release(); }

private:
  Quad Ways;
  std::string Error;
};
}

#endif
