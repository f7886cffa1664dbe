// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The mean of frames whose camera is moved by parts of a pixel: each frame is exact at its places,
 * so that their mean tends to the mean over each pixel, at the edges of surfaces and of shadows.
 */

#ifndef AirlightSubpixelMean_h
#define AirlightSubpixelMean_h

#include "Composite/AirlightDisplayStage.h"
#include "Frame/AirlightMeanPicture.h"
#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightQuad.h"

#include <glm/vec2.hpp>

#include <string>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace airlight
{
class SubpixelMean
{
public:
  // By how many pixels frame `number` of `count` is moved, at most half a one; the first is not. A
  // Kronecker lattice of the golden ratio: even for any count. At straight edges of all directions
  // its error is a sixth of one frame's with 16 frames, a twentieth with 64. Lamps that move with
  // the frames have GetPixelOffset().
  static glm::dvec2 GetOffset(int number, int count);

  // For pictures of this size. False with a reason in GetError(), here and below.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height);

  // Binds and clears the target of one frame; takes it into the mean, in which it has `weight`.
  bool BindFrame();
  bool AddFrame(float weight);

  vtkTextureObject* GetRadiance() { return this->Textures.Scattered; }

  // The mean, and the depths of the last frame, into a viewport of the framebuffer that is bound;
  // `blend`: over what it holds.
  bool DrawIntoViewport(const glm::ivec4& viewport, const DisplayStage& display, bool blend);

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

private:
  bool Fail(const std::string& reason);

  vtkOpenGLRenderWindow* Window = nullptr;
  Targets Textures; // Scene: a frame; Scattered: the mean
  Quad AddQuad;
  MeanPicture Picture;
  std::string Error;
};
}

#endif
