// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneControls_h
#define SceneControls_h

#include "scene/SceneBuilder.h"
#include "viewer/SceneLevels.h"

#include <vtkCamera.h>
#include <vtkNew.h>

#include <cstddef>
#include <string>
#include <vector>

namespace airlight
{

/**
 * What of a rendered scene keys, mouse and sliders change: technique, debug view, visibility and
 * other levels, lamps, and the camera back to where it was. Draws nothing. Without a medium there
 * are only lamps, camera and exposure.
 */
class SceneControls
{
public:
  explicit SceneControls(const RenderedScene& rendered);

  /**
   * Do what a key says, named as vtkRenderWindowInteractor::GetKeySym() does. False for others.
   */
  bool PressKey(const std::string& name);

  /**
   * Move the chosen lamp by pixels of the picture.
   */
  void DragLamp(double right, double up);

  /**
   * Technique, view, levels and chosen lamp, a line each.
   */
  std::string GetState() const;

  /**
   * The technique of the last frame is that of the state, after a frame with the chosen one.
   */
  void NoteTechnique();

  ///@{
  /**
   * The chosen lamp: null without lamps, and its number in the scene. A number that no lamp has is
   * ignored.
   */
  vtkLight* GetLamp() const;
  int GetLampNumber() const { return static_cast<int>(this->Lamp); }
  void ChooseLamp(int number);
  ///@}

  /**
   * What sliders change.
   */
  const std::vector<Level>& GetLevels() const { return this->Levels.GetLevels(); }

private:
  bool ChangePass(const std::string& name);
  bool ChangeLamp(const std::string& name);
  void ChangeTechnique(int step);
  void ChangeView(int step);
  void ChangeVisibility(double factor);
  std::string GetLampText() const;

  RenderedScene Rendered;
  SceneLevels Levels;
  vtkNew<vtkCamera> StartCamera;
  std::size_t Lamp = 0;
  int Technique = vtkAirlightPass::NONE;
};

}

#endif
