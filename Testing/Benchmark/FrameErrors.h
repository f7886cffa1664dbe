// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameErrors_h
#define FrameErrors_h

#include "FrameScene.h"
#include "vtkAirlightReference.h"

#include <map>

namespace benchmarks
{
/**
 * How far the airlight of each way of drawing a scene is from vtkAirlightReference of the same view
 * at 160 x 120 pixels: the root of the mean squared error over the mean. Pixels on edges where the
 * two see different surfaces do not count: that is not an error of the airlight.
 *
 * The window has the size of these pictures while this lives, and its own again afterwards.
 */
class FrameErrors
{
public:
  // Computes the reference of what the camera sees now: seconds to minutes.
  explicit FrameErrors(FrameScene& scene);
  ~FrameErrors();
  FrameErrors(const FrameErrors&) = delete;
  void operator=(const FrameErrors&) = delete;

  // Plain frames have no airlight; NaN where no pixel sees any.
  double Measure(const Way& way);

  // The number of steps n of the ray march that reaches the error while n - 1 does not, found by
  // bisection; where errors go up and down it is one of several such n. 0 where the most steps that
  // the pass allows do not reach it.
  int FindSteps(double error);

private:
  FrameScene& Scene;
  vtkNew<vtkAirlightReference> Reference;
  int Size[2];
};
}

#endif
