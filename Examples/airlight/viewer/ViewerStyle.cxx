// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/ViewerStyle.h"

#include "viewer/Viewer.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <string>

namespace airlight
{

vtkStandardNewMacro(ViewerStyle);

//------------------------------------------------------------------------------
void ViewerStyle::OnLeftButtonDown()
{
  if (this->Interactor->GetControlKey() && !this->Interactor->GetShiftKey())
  {
    this->DragsLamp = true;
    return;
  }
  this->Superclass::OnLeftButtonDown();
}

//------------------------------------------------------------------------------
void ViewerStyle::OnLeftButtonUp()
{
  if (this->DragsLamp)
  {
    this->DragsLamp = false;
    return;
  }
  this->Superclass::OnLeftButtonUp();
}

//------------------------------------------------------------------------------
void ViewerStyle::OnMouseMove()
{
  if (!this->DragsLamp)
  {
    this->Superclass::OnMouseMove();
    return;
  }
  const int* now = this->Interactor->GetEventPosition();
  const int* before = this->Interactor->GetLastEventPosition();
  this->Owner->DragLamp(now[0] - before[0], now[1] - before[1]);
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
  const std::string quits = "qQeE";
  if (quits.find(this->Interactor->GetKeyCode()) != std::string::npos)
  {
    this->Superclass::OnChar();
  }
}

}
