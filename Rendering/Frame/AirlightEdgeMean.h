// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame whose edges are smooth: its pixels that differ from their neighbours are the mean of four
 * frames, of which the last three are drawn at those pixels alone.
 *
 * Airlight and shades are smooth inside a pixel but at the edges of surfaces and of shadows, and
 * whatever is drawn is exact at its place: samples are wasted elsewhere. A texture of depths, 1 at
 * edges and 0 elsewhere, lets the depth test reject all other pixels of a draw before its shader.
 */

#ifndef AirlightEdgeMean_h
#define AirlightEdgeMean_h

#include "Composite/AirlightDisplayStage.h"
#include "Frame/AirlightMeanPicture.h"
#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightQuad.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkWindow;

namespace airlight
{
class EdgeMean
{
public:
  static constexpr int SampleCount = 4;

  // By how many pixels a frame is moved, at most half a one; the first is not. The others are the
  // corners of a triangle around it: of four places, one in the middle, about the best at straight
  // edges of all directions, where the error is 0.39 of one frame's.
  static glm::dvec2 GetOffset(int number);

  // For pictures of this size. False with a reason in GetError(), here and below.
  bool Begin(vtkOpenGLRenderWindow* window, int width, int height);

  // Binds the target of the first frame; makes the mask of its edges; binds the target of another
  // frame, which is drawn into the mean with a weight; and ends that.
  bool BindFirst();
  bool FindEdges(const DisplayStage& display, bool blend);
  bool BindSample(float weight);
  static void EndSamples();

  vtkTextureObject* GetRadiance() { return this->Textures.Scene; }
  vtkTextureObject* GetMask() { return this->Mask; }

  // By pixel, whether it is in the mask.
  bool ReadMask(std::vector<float>& mask);

  // The picture and the depths of its first frame into a viewport (x, y, width, height) of the
  // framebuffer that is bound; `blend`: over what it holds.
  bool DrawIntoViewport(const glm::ivec4& viewport, const DisplayStage& display, bool blend);

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

private:
  bool Fail(const std::string& reason);
  bool Bind(vtkTextureObject* colour, vtkTextureObject* depth);

  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
  Targets Textures; // Scene: the mean, at first the first frame
  vtkNew<vtkTextureObject> Mask;
  Quad EdgesQuad;
  MeanPicture Picture;
  std::string Error;
};
}

#endif
