// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A clipping range that also has lamps in it, which are none of the props by which renderers choose
 * it.
 */

#ifndef AirlightWiderRange_h
#define AirlightWiderRange_h

#include <glm/vec2.hpp>

class vtkCamera;

namespace airlight
{
// A camera whose clipping range has another one in it, until this goes out of scope.
class WiderRange
{
public:
  WiderRange(vtkCamera* camera, const glm::dvec2& range);
  ~WiderRange();
  WiderRange(const WiderRange&) = delete;
  void operator=(const WiderRange&) = delete;

private:
  vtkCamera* Camera;
  double Range[2];
};
}

#endif
