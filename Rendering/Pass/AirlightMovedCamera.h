// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A camera whose picture is moved by a part of a pixel, until this goes out of scope.
 */

#ifndef AirlightMovedCamera_h
#define AirlightMovedCamera_h

#include "vtkSmartPointer.h"

#include <glm/vec2.hpp>

class vtkCamera;
class vtkMatrix4x4;

namespace airlight
{
class MovedCamera
{
public:
  // `offset` and `size` in pixels: of a picture in tiles, a camera shows one.
  MovedCamera(vtkCamera* camera, const glm::dvec2& offset, const glm::dvec2& size);
  ~MovedCamera();
  MovedCamera(const MovedCamera&) = delete;
  void operator=(const MovedCamera&) = delete;

private:
  vtkCamera* Camera;
  double Center[2];
  vtkSmartPointer<vtkMatrix4x4> Projection; // if the camera has a matrix of its own
};
}

#endif
