// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The buffers of vtkAirlightPass::GetBuffer(): images read from the targets of a frame.
 */

#ifndef AirlightFrameRecorder_h
#define AirlightFrameRecorder_h

#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkImageData;

namespace airlight
{
class Targets;

class FrameRecorder
{
public:
  // Reads what the composite and the lights' airlight left in the targets; `several`: light that is
  // scattered more than once, too, whose buffer is otherwise 0. False with a reason in
  // the targets' GetError(), here and below.
  bool Record(Targets& targets, bool several);

  // Reads one light's airlight.
  bool RecordLight(Targets& targets, int light);

  // The mean of several frames, which then takes the place of the last one's and may grow on: each
  // frame has its weight beside the mean of those before. Of several distances there is no mean
  // that any ray has, nor of counts: those stay the last frame's.
  void ClearMean() { this->Means.clear(); }
  // Begins it with the last frame, whose distances and counts stay; and adds another frame where a
  // mask of the pixels is not 0.
  void BeginMean();
  void AddToMean(float weight, const std::vector<float>& mask);
  void AddToMean(float weight);
  void TakeMean();

  // Null for an unknown name.
  vtkImageData* Get(const std::string& name) const;
  void Clear() { this->Buffers.clear(); }
  bool IsEmpty() const { return this->Buffers.empty(); }

private:
  using Images = std::map<std::string, vtkSmartPointer<vtkImageData>>;

  Images Buffers;
  Images Means;
};
}

#endif
