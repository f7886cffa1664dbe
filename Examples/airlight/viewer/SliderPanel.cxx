// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/SliderPanel.h"

#include "viewer/LevelSlider.h"

#include <vtkRenderWindowInteractor.h>

#include <algorithm>

namespace airlight
{

namespace
{
// Pixels
constexpr int LeastWidth = 480;
constexpr int LeastHeight = 300;
constexpr int PanelHeight = 44;
constexpr int Margin = 16;
constexpr int Gap = 28;
constexpr int LongestSlider = 260;
}

//------------------------------------------------------------------------------
SliderPanel::SliderPanel(
  vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, const std::vector<Level>& levels)
  : Renderer(renderer)
{
  interactor->EnableRenderOff(); // a widget that is switched on renders
  for (const Level& level : levels)
  {
    this->Sliders.push_back(std::make_unique<LevelSlider>(interactor, renderer, level));
  }
  interactor->EnableRenderOn();
}

//------------------------------------------------------------------------------
SliderPanel::~SliderPanel() = default;

//------------------------------------------------------------------------------
int SliderPanel::GetHeight() const
{
  const int* size = this->Renderer->GetSize();
  const bool shown =
    this->Visible && !this->Sliders.empty() && size[0] >= LeastWidth && size[1] >= LeastHeight;
  return shown ? PanelHeight : 0;
}

//------------------------------------------------------------------------------
void SliderPanel::Update()
{
  const bool shown = this->GetHeight() > 0;
  const auto count = static_cast<int>(this->Sliders.size());
  const int room = this->Renderer->GetSize()[0] - 2 * Margin - (count - 1) * Gap;
  const int length = std::min(room / std::max(count, 1), LongestSlider);
  int left = Margin;
  for (const auto& slider : this->Sliders)
  {
    slider->Update(shown, left, length);
    left += length + Gap;
  }
}

}
