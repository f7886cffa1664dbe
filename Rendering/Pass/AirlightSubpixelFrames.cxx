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
bool SubpixelFrames::Render(vtkRenderer* renderer, const glm::ivec4& picture, int count,
  FrameRecorder& buffers, const Progress& progress, const std::function<bool()>& renderFrame)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  // Of a picture in tiles, a camera shows one.
  const glm::dvec2 size(picture.z, picture.w);
  buffers.BeginMean();
  bool ok = this->Mean.Begin(window, picture.x + picture.z, picture.y + picture.w);
  bool goesOn = true;
  for (int number = count - 1; ok && goesOn && number >= 0; --number)
  {
    const MovedCamera camera(
      renderer->GetActiveCamera(), 2.0 * SubpixelMean::GetOffset(number, count) / size);
    std::optional<MovedLamps> lamps;
    if (this->MovesLamps)
    {
      lamps.emplace(renderer, number);
    }
    ok = this->Mean.BindFrame() && renderFrame();
    if (ok)
    {
      const int done = count - number;
      const float weight = 1.0f / static_cast<float>(done);
      buffers.AddToMean(weight);
      ok = this->Mean.AddFrame(weight);
      goesOn = progress(static_cast<double>(done) / count);
    }
  }
  if (ok)
  {
    buffers.TakeMean();
  }
  return ok;
}

//------------------------------------------------------------------------------
bool SubpixelFrames::DrawIntoViewport(
  const glm::ivec4& picture, const DisplayStage& display, bool blend)
{
  return this->Mean.DrawIntoViewport(picture, display, blend);
}
}
