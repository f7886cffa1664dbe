// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LevelSlider_h
#define LevelSlider_h

#include "viewer/SceneLevels.h"

#include <vtkNew.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>

class vtkRenderWindowInteractor;

namespace airlight
{

/**
 * A slider on the screen for a level of the scene, with name and value above it.
 */
class LevelSlider
{
public:
  /**
   * The level has to outlive the slider.
   */
  LevelSlider(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer, const Level& level);

  LevelSlider(const LevelSlider&) = delete;
  void operator=(const LevelSlider&) = delete;

  /**
   * Follow the level, and lie at the window's bottom from a column on, in pixels. While it is
   * dragged it stays, since a hidden slider would miss the mouse's release.
   */
  void Update(bool wanted, int left, int length);

private:
  void SetLook();
  void Place(int left, int length);
  void Begin();
  void Move();
  void End();

  const Level& Own;
  vtkNew<vtkSliderRepresentation2D> Shape;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkTextActor> Label;
  bool Slides = false; // from the mouse's press to its release
  double Shown = 0.0;  // the shape's value as last set, from the level or to it
};

}

#endif
