// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Keeps VTK's errors and warnings, all of them, instead of printing them.
 */

#ifndef FrameMessages_h
#define FrameMessages_h

#include "vtkOutputWindow.h"

#include <string>
#include <vector>

namespace airlight_test
{
class FrameMessages : public vtkOutputWindow
{
public:
  static FrameMessages* New();
  vtkTypeMacro(FrameMessages, vtkOutputWindow);

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override { this->DisplayText(text); }
  void DisplayWarningText(const char* text) override { this->DisplayText(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayText(text); }

  // Those since the last call that are no announced limit of the pass or of VTK.
  std::vector<std::string> TakeUnexpected();

protected:
  FrameMessages() = default;
  ~FrameMessages() override = default;

private:
  std::vector<std::string> Texts;
};
}

#endif
