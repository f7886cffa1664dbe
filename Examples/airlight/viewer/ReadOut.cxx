// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/ReadOut.h"

#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace airlight
{

namespace
{
constexpr int FontSize = 14;
constexpr int HelpFontSize = 12;
constexpr double Margin = 0.01;    // of the picture
constexpr double HelpMargin = 5.0; // pixels
const char* const Hint = "h: keys";
}

//------------------------------------------------------------------------------
void AddText(vtkRenderer* renderer, vtkTextActor* actor)
{
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontFamilyToCourier();
  style->SetFontSize(FontSize);
  style->SetColor(1.0, 1.0, 1.0);
  style->SetBackgroundColor(0.0, 0.0, 0.0);
  style->SetBackgroundOpacity(0.5);
  style->SetJustificationToLeft();
  renderer->AddActor2D(actor);
}

//------------------------------------------------------------------------------
ReadOut::ReadOut(vtkRenderer* renderer)
{
  AddText(renderer, this->State);
  this->State->GetTextProperty()->SetVerticalJustificationToTop();
  this->State->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->State->GetPositionCoordinate()->SetValue(Margin, 1.0 - Margin);
  AddText(renderer, this->Help);
  this->Help->GetTextProperty()->SetFontSize(HelpFontSize);
  this->Help->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
  this->SetHelpBottom(0);
  this->Help->VisibilityOff();
}

//------------------------------------------------------------------------------
void ReadOut::SetText(const std::string& text)
{
  this->State->SetInput((this->GetHelpVisible() ? text : text + "\n" + Hint).c_str());
}

//------------------------------------------------------------------------------
void ReadOut::SetHelp(const std::string& text) { this->Help->SetInput(text.c_str()); }

//------------------------------------------------------------------------------
void ReadOut::SetHelpBottom(int pixels)
{
  this->Help->GetPositionCoordinate()->SetValue(HelpMargin, HelpMargin + pixels);
}

//------------------------------------------------------------------------------
void ReadOut::SetVisible(bool visible)
{
  this->Visible = visible;
  this->State->SetVisibility(visible);
}

//------------------------------------------------------------------------------
void ReadOut::SetHelpVisible(bool visible) { this->Help->SetVisibility(visible); }

//------------------------------------------------------------------------------
bool ReadOut::GetHelpVisible() { return this->Help->GetVisibility() != 0; }

}
