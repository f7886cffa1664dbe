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

class vtkImageData;

namespace airlight
{
class Targets;

class FrameRecorder
{
public:
  // Reads what the composite and the lights' airlight left in the targets. False with a reason in
  // the targets' GetError(), here and below.
  bool Record(Targets& targets);

  // Reads one light's airlight.
  bool RecordLight(Targets& targets, int light);

  // Null for an unknown name.
  vtkImageData* Get(const std::string& name) const;
  void Clear() { this->Buffers.clear(); }

private:
  std::map<std::string, vtkSmartPointer<vtkImageData>> Buffers;
};
}

#endif
