// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SliderPanel_h
#define SliderPanel_h

#include "viewer/SceneLevels.h"

#include <memory>
#include <vector>

class vtkRenderWindowInteractor;

namespace airlight
{

class LevelSlider;

/**
 * Sliders for levels, side by side at the bottom of the window, drawn over the medium. They take
 * the mouse before the interactor's style does, and render while they are moved.
 */
class SliderPanel
{
public:
  /**
   * The levels have to outlive the panel. The interactor needs its window before.
   */
  SliderPanel(
    vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, const std::vector<Level>& levels);
  ~SliderPanel();

  SliderPanel(const SliderPanel&) = delete;
  void operator=(const SliderPanel&) = delete;

  /**
   * Follow the levels and the window's size, before a frame.
   */
  void Update();

  /**
   * Default: true. In windows below 480 x 300 pixels sliders are hidden anyway.
   */
  void SetVisible(bool visible) { this->Visible = visible; }

  /**
   * The pixels that the panel covers at the bottom of the window; 0 if hidden.
   */
  int GetHeight() const;

private:
  vtkRenderer* Renderer;
  std::vector<std::unique_ptr<LevelSlider>> Sliders;
  bool Visible = true;
};

}

#endif
