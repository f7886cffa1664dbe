// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightEdgeSamples.h"

#include "Pass/AirlightMovedCamera.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <vector>

namespace airlight
{
//------------------------------------------------------------------------------
bool EdgeSamples::Render(vtkRenderer* renderer, const glm::ivec2& size, bool blend,
  FrameRecorder& buffers, const GetDisplay& getDisplay, const RenderFrame& renderFrame)
{
  return this->Mean.Begin(
           vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), size.x, size.y) &&
    this->Mean.BindFirst() && renderFrame(nullptr) && getDisplay(this->Display) &&
    this->Mean.FindEdges(this->Display, blend) &&
    this->AddSamples(renderer, size, buffers, renderFrame);
}

//------------------------------------------------------------------------------
// Depths and counts are those of the first frame.
bool EdgeSamples::AddSamples(vtkRenderer* renderer, const glm::ivec2& size, FrameRecorder& buffers,
  const RenderFrame& renderFrame)
{
  std::vector<float> mask;
  if (!buffers.IsEmpty() && !this->Mean.ReadMask(mask))
  {
    return false;
  }
  buffers.BeginMean();
  bool ok = true;
  for (int number = 1; ok && number < EdgeMean::SampleCount; ++number)
  {
    const float weight = 1.0f / static_cast<float>(number + 1);
    const MovedCamera camera(renderer->GetActiveCamera(), EdgeMean::GetOffset(number), size);
    ok = this->Mean.BindSample(weight) && renderFrame(this->Mean.GetMask());
    if (ok)
    {
      buffers.AddToMean(weight, mask);
    }
  }
  EdgeMean::EndSamples();
  buffers.TakeMean();
  buffers.ClearMean();
  return ok;
}

//------------------------------------------------------------------------------
bool EdgeSamples::DrawIntoViewport(const glm::ivec4& viewport, bool blend)
{
  return this->Mean.DrawIntoViewport(viewport, this->Display, blend);
}
}
