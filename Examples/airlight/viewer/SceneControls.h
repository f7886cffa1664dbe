// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneControls_h
#define SceneControls_h

#include "scene/SceneBuilder.h"

#include <vtkCamera.h>
#include <vtkNew.h>

#include <cstddef>
#include <string>

namespace airlight
{

/**
 * What of a rendered scene keys and mouse change: technique, debug view, visibility, lamps, and the
 * camera back to where it was. Draws nothing. Without a medium there are only lamps and camera.
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
  void DragLamp(int right, int up);

  /**
   * Technique, view, visibility and chosen lamp, a line each.
   */
  std::string GetState() const;

  /**
   * Null without lamps.
   */
  vtkLight* GetLamp() const;

private:
  bool ChangePass(const std::string& name);
  bool ChangeLamp(const std::string& name);
  void ChangeTechnique(int step);
  void ChangeView(int step);
  void ChangeVisibility(double factor);
  std::string GetLampText() const;

  RenderedScene Rendered;
  vtkNew<vtkCamera> StartCamera;
  std::size_t Lamp = 0;
};

}

#endif
