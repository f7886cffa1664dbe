// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadOut_h
#define ReadOut_h

#include "formats/Vector3.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkTextActor.h>

#include <string>

class vtkRenderer;

namespace airlight
{

/**
 * What the viewer writes over its picture: the state at the top, the keys at the bottom, and a ring
 * around the lamp that the keys move. All of it is drawn over the medium.
 */
class ReadOut
{
public:
  explicit ReadOut(vtkRenderer* renderer);

  void SetText(const std::string& text);
  void SetHelp(const std::string& text);

  /**
   * Put the ring around a place in the world. Hidden, it goes where the camera does not see it.
   */
  void SetLamp(const Vector3& place, bool visible);

  ///@{
  /**
   * State and ring are shown at first, the keys are not.
   */
  void SetVisible(bool visible);
  bool GetVisible() const { return this->Visible; }
  void SetHelpVisible(bool visible);
  bool GetHelpVisible();
  ///@}

private:
  vtkNew<vtkTextActor> State;
  vtkNew<vtkTextActor> Help;
  vtkNew<vtkActor2D> Ring;
  bool Visible = true;
  bool LampVisible = false;
};

}

#endif
