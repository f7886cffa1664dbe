// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightSubpixelFrames.h"

#include "Scene/AirlightLampSamples.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <optional>

namespace airlight
{
namespace
{
// A camera whose picture is moved by parts of the window's half size, until this goes out of scope.
class MovedCamera
{
public:
  MovedCamera(vtkCamera* camera, const glm::dvec2& offset)
    : Camera(camera)
  {
    this->Camera->GetWindowCenter(this->Center);
    this->Camera->SetWindowCenter(this->Center[0] + offset.x, this->Center[1] + offset.y);
  }
  ~MovedCamera() { this->Camera->SetWindowCenter(this->Center[0], this->Center[1]); }
  MovedCamera(const MovedCamera&) = delete;
  void operator=(const MovedCamera&) = delete;

private:
  vtkCamera* Camera;
  double Center[2];
};
}

//------------------------------------------------------------------------------
// A renderer that keeps depths of others is drawn among them, by one frame. Cameras with a matrix
// of their own cannot be moved, and what debug views show are no colours.
bool SubpixelFrames::MayAverage(vtkRenderer* renderer, DebugView view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return renderer->GetErase() && !renderer->GetPreserveDepthBuffer() &&
    !camera->GetUseOffAxisProjection() && !camera->GetUseExplicitProjectionTransformMatrix() &&
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
  // Of a picture in tiles, a camera shows one.
  const glm::dvec2 size(picture.z, picture.w);
  const MovedCamera camera(
    renderer->GetActiveCamera(), 2.0 * SubpixelMean::GetOffset(number, count) / size);
  std::optional<MovedLamps> lamps;
  if (this->MovesLamps)
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
