// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/LevelSlider.h"

#include "viewer/ReadOut.h"

#include <vtkCommand.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace airlight
{

namespace
{
constexpr int LabelDigits = 3;

// Pixels
constexpr double Bottom = 13.0; // the tube's middle
constexpr double LabelBottom = 24.0;
constexpr double TubeWidth = 4.0;
constexpr double BeadLength = 10.0;
constexpr double BeadWidth = 16.0;

void SetColor(vtkProperty2D* property, double red, double green, double blue, double opacity)
{
  property->SetColor(red, green, blue);
  property->SetOpacity(opacity);
}
}

//------------------------------------------------------------------------------
LevelSlider::LevelSlider(
  vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, const Level& level)
  : Own(level)
{
  this->SetLook();
  this->Shape->SetMinimumValue(level.Minimum);
  this->Shape->SetMaximumValue(level.Maximum);
  AddText(renderer, this->Label);
  this->Widget->KeyPressActivationOff(); // or the key i would switch it off
  this->Widget->SetInteractor(interactor);
  this->Widget->SetCurrentRenderer(renderer);
  this->Widget->SetRepresentation(this->Shape);
  this->Widget->SetAnimationModeToJump();
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this, &LevelSlider::Move);
  this->Widget->AddObserver(vtkCommand::StartInteractionEvent, this, &LevelSlider::Begin);
  this->Widget->AddObserver(vtkCommand::EndInteractionEvent, this, &LevelSlider::End);
  this->Widget->EnabledOn();
}

//------------------------------------------------------------------------------
void LevelSlider::SetLook()
{
  this->Shape->ShowSliderLabelOff();
  this->Shape->SetEndCapLength(0.0);
  this->Shape->SetEndCapWidth(0.0);
  SetColor(this->Shape->GetTubeProperty(), 0.6, 0.6, 0.6, 0.7);
  SetColor(this->Shape->GetSliderProperty(), 0.95, 0.95, 0.95, 1.0);
  SetColor(this->Shape->GetSelectedProperty(), 1.0, 0.8, 0.2, 1.0);
  this->Shape->GetPoint1Coordinate()->SetCoordinateSystemToDisplay();
  this->Shape->GetPoint2Coordinate()->SetCoordinateSystemToDisplay();
  this->Label->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
}

//------------------------------------------------------------------------------
void LevelSlider::Update(bool wanted, int left, int length)
{
  const bool visible = wanted || this->Slides;
  this->Shape->SetVisibility(visible);
  this->Label->SetVisibility(visible);
  this->Widget->SetProcessEvents(visible);
  this->Shape->SetValue(this->Own.Get());
  this->Shown = this->Shape->GetValue();
  if (visible)
  {
    this->Place(left, length);
    this->Label->SetInput(this->Own.GetText(LabelDigits).c_str());
  }
}

//------------------------------------------------------------------------------
void LevelSlider::Place(int left, int length)
{
  this->Shape->GetPoint1Coordinate()->SetValue(left, Bottom);
  this->Shape->GetPoint2Coordinate()->SetValue(left + length, Bottom);
  this->Label->GetPositionCoordinate()->SetValue(left, LabelBottom);
  // VTK's sizes are parts of the window's width and height.
  const int* size = this->Widget->GetCurrentRenderer()->GetSize();
  this->Shape->SetSliderLength(BeadLength / size[0]);
  this->Shape->SetSliderWidth(BeadWidth / size[1]);
  this->Shape->SetTubeWidth(TubeWidth / size[1]);
}

//------------------------------------------------------------------------------
void LevelSlider::Begin() { this->Slides = true; }

//------------------------------------------------------------------------------
void LevelSlider::End()
{
  this->Slides = false;
  this->Move();
}

//------------------------------------------------------------------------------
void LevelSlider::Move()
{
  const double value = this->Shape->GetValue();
  if (value != this->Shown) // a press alone changes nothing
  {
    this->Shown = value;
    this->Own.Set(value);
  }
}

}
