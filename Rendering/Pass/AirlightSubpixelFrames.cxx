// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSubpixelFrames.h"

#include "Pass/AirlightMovedCamera.h"
#include "Scene/AirlightLampSamples.h"
#include "Scene/AirlightScrambledNet.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <optional>

namespace airlight
{
//------------------------------------------------------------------------------
// A renderer that keeps depths of others is drawn among them, by one frame. Cameras off their axis
// cannot be moved, and what debug views show are no colours.
bool SubpixelFrames::MayAverage(vtkRenderer* renderer, DebugView view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return renderer->GetErase() && !renderer->GetPreserveDepthBuffer() &&
    !camera->GetUseOffAxisProjection() &&
    (view == DebugView::Shaded || view == DebugView::AirlightOnly);
}

//------------------------------------------------------------------------------
// The frame that is not moved is the last one: its depths stay.
bool SubpixelFrames::Render(vtkRenderer* renderer, const glm::ivec4& picture, const Range& range,
  FrameRecorder& buffers, const Progress& progress, const std::function<bool()>& renderFrame)
{
  this->Done = range.First;
  bool ok = true;
  if (range.First == 0)
  {
    buffers.ClearMean();
    ok = this->Mean.Begin(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()),
      picture.x + picture.z, picture.y + picture.w);
  }
  bool goesOn = true;
  while (ok && goesOn && this->Done < range.Last)
  {
    ok = this->AddFrame(renderer, picture, range.Count, buffers, renderFrame);
    goesOn = ok && progress(static_cast<double>(this->Done) / range.Count);
  }
  if (ok && range.First < range.Last)
  {
    buffers.TakeMean();
  }
  return ok;
}

//------------------------------------------------------------------------------
bool SubpixelFrames::AddFrame(vtkRenderer* renderer, const glm::ivec4& picture, int count,
  FrameRecorder& buffers, const std::function<bool()>& renderFrame)
{
  const int number = count - 1 - this->Done;
  const bool movesLamps = this->MovesLamps && HasMovingLamps(renderer);
  const MovedCamera camera(renderer->GetActiveCamera(),
    movesLamps ? GetPixelOffset(number) : SubpixelMean::GetOffset(number, count),
    { picture.z, picture.w });
  std::optional<MovedLamps> lamps;
  if (movesLamps)
  {
    lamps.emplace(renderer, number);
  }
  if (!this->Mean.BindFrame() || !renderFrame())
  {
    return false;
  }
  ++this->Done;
  const float weight = 1.0f / static_cast<float>(this->Done);
  buffers.AddToMean(weight);
  return this->Mean.AddFrame(weight);
}

//------------------------------------------------------------------------------
bool SubpixelFrames::DrawIntoViewport(
  const glm::ivec4& picture, const DisplayStage& display, bool blend)
{
  return this->Mean.DrawIntoViewport(picture, display, blend);
}
}
