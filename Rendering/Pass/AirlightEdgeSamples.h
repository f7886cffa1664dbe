// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A picture with four samples at its edges: one frame, and at the pixels where that has edges three
 * more of a camera that is moved by parts of a pixel (EdgeMean).
 */

#ifndef AirlightEdgeSamples_h
#define AirlightEdgeSamples_h

#include "Frame/AirlightEdgeMean.h"
#include "Frame/AirlightFrameRecorder.h"

#include <functional>
#include <string>

class vtkRenderer;

namespace airlight
{
class EdgeSamples
{
public:
  // Renders a frame into the framebuffer that is bound, from its corner on, at the pixels of a mask
  // alone if it is not null.
  using RenderFrame = std::function<bool(vtkTextureObject* mask)>;

  // How the picture is shown, once it has its first frame. False as RenderFrame.
  using GetDisplay = std::function<bool(DisplayStage& display)>;

  // Renders the picture of a viewport of this size, and its recorded buffers; `blend`: it will be
  // drawn over what the framebuffer holds. False if one of these
  // returns false, or with a reason in GetError().
  bool Render(vtkRenderer* renderer, const glm::ivec2& size, bool blend, FrameRecorder& buffers,
    const GetDisplay& getDisplay, const RenderFrame& renderFrame);

  vtkTextureObject* GetRadiance() { return this->Mean.GetRadiance(); }

  // As EdgeMean's.
  bool DrawIntoViewport(const glm::ivec4& viewport, bool blend);

  const std::string& GetError() const { return this->Mean.GetError(); }
  void Release(vtkWindow* window) { this->Mean.Release(window); }

private:
  bool AddSamples(vtkRenderer* renderer, const glm::ivec2& size, FrameRecorder& buffers,
    const RenderFrame& renderFrame);

  EdgeMean Mean;
  DisplayStage Display;
};
}

#endif
