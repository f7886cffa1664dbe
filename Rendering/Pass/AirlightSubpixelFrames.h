// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture of several frames: each of a camera that is moved by a part of a pixel, and of other
 * points of its lamps.
 */

#ifndef AirlightSubpixelFrames_h
#define AirlightSubpixelFrames_h

#include "Frame/AirlightFramePlan.h"
#include "Frame/AirlightFrameRecorder.h"
#include "Frame/AirlightSubpixelMean.h"

#include <functional>
#include <string>

class vtkRenderer;

namespace airlight
{
class SubpixelFrames
{
public:
  // Is called after each frame with the share that is done. False ends the mean with that frame.
  using Progress = std::function<bool(double)>;

  // Whether a renderer's picture may be the mean of several.
  static bool MayAverage(vtkRenderer* renderer, DebugView view);

  // Frames of a mean of `Count`: the mean has those before `First` already.
  struct Range
  {
    int First;
    int Last;
    int Count;
  };

  // Renders frames of a mean, and of that of their recorded buffers. `renderFrame` renders one into
  // the framebuffer that is bound, at the picture's corner. False if it returns false, or with a
  // reason in GetError().
  bool Render(vtkRenderer* renderer, const glm::ivec4& picture, const Range& range,
    FrameRecorder& buffers, const Progress& progress, const std::function<bool()>& renderFrame);

  // How many frames the mean has.
  int GetDone() const { return this->Done; }

  // Whether lamps with an extent are at other points in each frame. Default: true.
  void SetMovesLamps(bool moves) { this->MovesLamps = moves; }

  vtkTextureObject* GetRadiance() { return this->Mean.GetRadiance(); }

  // As SubpixelMean's.
  bool DrawIntoViewport(const glm::ivec4& picture, const DisplayStage& display, bool blend);

  const std::string& GetError() const { return this->Mean.GetError(); }
  void Release(vtkWindow* window) { this->Mean.Release(window); }

private:
  bool AddFrame(vtkRenderer* renderer, const glm::ivec4& picture, int count, FrameRecorder& buffers,
    const std::function<bool()>& renderFrame);

  SubpixelMean Mean;
  int Done = 0;
  bool MovesLamps = true;
};
}

#endif
