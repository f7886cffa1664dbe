// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/ViewerStyle.h"

#include "viewer/Viewer.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>

namespace airlight
{

namespace
{
constexpr int LampState = 1000; // none of VTK's
}

vtkStandardNewMacro(ViewerStyle);

//------------------------------------------------------------------------------
void ViewerStyle::OnLeftButtonDown()
{
  const int* place = this->Interactor->GetEventPosition();
  const bool control = this->Interactor->GetControlKey() && !this->Interactor->GetShiftKey();
  if (this->State != VTKIS_NONE || (!this->Owner->TakeLamp(place[0], place[1]) && !control))
  {
    this->Superclass::OnLeftButtonDown();
    return;
  }
  this->DragsLamp = true;
  this->DragPlace = { place[0], place[1] };
  this->StartState(LampState); // during which frames may be simpler
}

//------------------------------------------------------------------------------
void ViewerStyle::OnLeftButtonUp()
{
  if (this->DragsLamp)
  {
    this->DragsLamp = false;
    this->StopState();
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

//------------------------------------------------------------------------------
void ViewerStyle::OnMouseMove()
{
  const int* now = this->Interactor->GetEventPosition();
  if (!this->DragsLamp)
  {
    if (this->State == VTKIS_NONE)
    {
      this->Owner->PointAt(now[0], now[1]);
    }
    this->Superclass::OnMouseMove();
    return;
  }
  this->Owner->DragLamp(now[0] - this->DragPlace[0], now[1] - this->DragPlace[1]);
  this->DragPlace = { now[0], now[1] };
}

//------------------------------------------------------------------------------
void ViewerStyle::OnMouseWheelForward()
{
  if (!this->Zoom(1.0))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

//------------------------------------------------------------------------------
void ViewerStyle::OnMouseWheelBackward()
{
  if (!this->Zoom(-1.0))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

//------------------------------------------------------------------------------
bool ViewerStyle::Zoom(double direction)
{
  const int* place = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(place[0], place[1]);
  if (!this->CurrentRenderer || !this->Owner->DeferRest())
  {
    return false; // VTK draws a frame at rest after each step
  }
  this->Dolly(std::pow(1.1, 0.2 * direction * this->MotionFactor * this->MouseWheelMotionFactor));
  return true;
}

//------------------------------------------------------------------------------
void ViewerStyle::OnKeyPress()
{
  const char* key = this->Interactor->GetKeySym();
  if (key)
  {
    this->Owner->PressKey(key);
  }
}

//------------------------------------------------------------------------------
void ViewerStyle::OnChar()
{
  const char key = this->Interactor->GetKeyCode();
  if (key == 'q' || key == 'Q')
  {
    this->Superclass::OnChar();
  }
}

}
