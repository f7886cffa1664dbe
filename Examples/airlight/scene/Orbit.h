// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Orbit_h
#define Orbit_h

#include "scene/Scene.h"
#include "scene/SceneBuilder.h"

namespace airlight
{

/**
 * A turntable: the camera goes once around its focal point, about CameraSettings::GetUp(), and to
 * the right. Lamps stay where they are. Each state is a function of the frame's number alone. Frame
 * 0 is the scene as it was read, and after `period` frames everything is back there.
 */
class Orbit
{
public:
  Orbit(const Scene& scene, const RenderedScene& rendered, int period);

  void SetFrame(int frame);

  /**
   * Keep the exposure of the last picture, so that those that follow do not flicker.
   */
  void KeepExposure();

private:
  Scene Start;
  RenderedScene Rendered;
  int Period;
};

}

#endif
