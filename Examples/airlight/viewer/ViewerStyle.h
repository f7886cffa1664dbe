// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ViewerStyle_h
#define ViewerStyle_h

#include <vtkInteractorStyleTrackballCamera.h>

#include <array>

namespace airlight
{

class Viewer;

/**
 * The mouse turns, moves and zooms the camera as in other programs of VTK, but the left button
 * drags a lamp that it is pressed on, and with Ctrl the viewer's chosen lamp. Keys go to the
 * viewer; of VTK's own only q, which quits, is left.
 */
class ViewerStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static ViewerStyle* New();
  vtkTypeMacro(ViewerStyle, vtkInteractorStyleTrackballCamera);

  void SetOwner(Viewer* owner) { this->Owner = owner; }

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseMove() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override;

private:
  bool Zoom(double direction);

  Viewer* Owner = nullptr;
  bool DragsLamp = false;
  std::array<int, 2> DragPlace = { 0, 0 }; // pixels; of the mouse, while keys have places, too
};

}

#endif
