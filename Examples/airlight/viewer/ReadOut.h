// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadOut_h
#define ReadOut_h

#include <vtkNew.h>
#include <vtkTextActor.h>

#include <string>

class vtkRenderer;

namespace airlight
{

/**
 * Add an empty text to a picture: white on a dim ground, legible on fog as on night.
 */
void AddText(vtkRenderer* renderer, vtkTextActor* actor);

/**
 * The texts that the viewer writes over its picture: the state at the top, and under it the keys or
 * how to see them.
 */
class ReadOut
{
public:
  explicit ReadOut(vtkRenderer* renderer);

  void SetText(const std::string& text);
  void SetHelp(const std::string& text);

  /**
   * Leave so many pixels free below the keys. Default: 0.
   */
  void SetHelpBottom(int pixels);

  ///@{
  /**
   * The state is shown at first, the keys are not.
   */
  void SetVisible(bool visible);
  bool GetVisible() const { return this->Visible; }
  void SetHelpVisible(bool visible);
  bool GetHelpVisible();
  ///@}

private:
  vtkNew<vtkTextActor> State;
  vtkNew<vtkTextActor> Help;
  bool Visible = true;
};

}

#endif
