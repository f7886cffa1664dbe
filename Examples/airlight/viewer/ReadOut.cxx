// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/ReadOut.h"

#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace airlight
{

namespace
{
constexpr int FontSize = 14;
constexpr double RingRadius = 9.0; // pixels
constexpr double Margin = 0.01;    // of the picture

// White on a dim ground, legible on fog as on night.
void AddText(vtkRenderer* renderer, vtkTextActor* actor, double y)
{
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontFamilyToCourier();
  style->SetFontSize(FontSize);
  style->SetColor(1.0, 1.0, 1.0);
  style->SetBackgroundColor(0.0, 0.0, 0.0);
  style->SetBackgroundOpacity(0.5);
  style->SetJustificationToLeft();
  vtkCoordinate* place = actor->GetPositionCoordinate();
  place->SetCoordinateSystemToNormalizedViewport();
  place->SetValue(Margin, y);
  renderer->AddActor2D(actor);
}
}

//------------------------------------------------------------------------------
ReadOut::ReadOut(vtkRenderer* renderer)
{
  AddText(renderer, this->State, 1.0 - Margin);
  this->State->GetTextProperty()->SetVerticalJustificationToTop();
  AddText(renderer, this->Help, Margin);
  this->Help->GetTextProperty()->SetVerticalJustificationToBottom();
  this->Help->VisibilityOff();

  vtkNew<vtkRegularPolygonSource> circle;
  circle->SetNumberOfSides(24);
  circle->SetRadius(RingRadius);
  circle->GeneratePolygonOff();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(circle->GetOutputPort());
  this->Ring->SetMapper(mapper);
  this->Ring->GetProperty()->SetColor(1.0, 0.8, 0.2);
  this->Ring->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  this->Ring->VisibilityOff();
  renderer->AddActor2D(this->Ring);
}

//------------------------------------------------------------------------------
void ReadOut::SetText(const std::string& text) { this->State->SetInput(text.c_str()); }

//------------------------------------------------------------------------------
void ReadOut::SetHelp(const std::string& text) { this->Help->SetInput(text.c_str()); }

//------------------------------------------------------------------------------
void ReadOut::SetLamp(const Vector3& place, bool visible)
{
  this->LampVisible = visible;
  this->Ring->GetPositionCoordinate()->SetValue(place[0], place[1], place[2]);
  this->Ring->SetVisibility(this->Visible && this->LampVisible);
}

//------------------------------------------------------------------------------
void ReadOut::SetVisible(bool visible)
{
  this->Visible = visible;
  this->State->SetVisibility(visible);
  this->Ring->SetVisibility(this->Visible && this->LampVisible);
}

//------------------------------------------------------------------------------
void ReadOut::SetHelpVisible(bool visible) { this->Help->SetVisibility(visible); }

//------------------------------------------------------------------------------
bool ReadOut::GetHelpVisible() { return this->Help->GetVisibility() != 0; }

}
