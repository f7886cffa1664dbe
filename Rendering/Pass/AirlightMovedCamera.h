// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A camera whose picture is moved by a part of a pixel, until this goes out of scope.
 */

#ifndef AirlightMovedCamera_h
#define AirlightMovedCamera_h

#include "vtkCamera.h"

#include <glm/vec2.hpp>

namespace airlight
{
class MovedCamera
{
public:
  // `offset` and `size` in pixels: of a picture in tiles, a camera shows one.
  MovedCamera(vtkCamera* camera, const glm::dvec2& offset, const glm::dvec2& size)
    : Camera(camera)
  {
    this->Camera->GetWindowCenter(this->Center);
    const glm::dvec2 moved = 2.0 * offset / size;
    this->Camera->SetWindowCenter(this->Center[0] + moved.x, this->Center[1] + moved.y);
  }
  ~MovedCamera() { this->Camera->SetWindowCenter(this->Center[0], this->Center[1]); }
  MovedCamera(const MovedCamera&) = delete;
  void operator=(const MovedCamera&) = delete;

private:
  vtkCamera* Camera;
  double Center[2];
};
}

#endif
