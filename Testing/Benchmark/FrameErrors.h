// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameErrors_h
#define FrameErrors_h

#include "FrameScene.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <map>

namespace benchmarks
{
/**
 * How far the airlight of each way of drawing a scene is from the exact one of the same view: the
 * root of the mean squared error over the mean. Pixels on edges where the two see different
 * surfaces do not count: that is not an error of the airlight.
 */
class FrameErrors
{
public:
  // What is exact is vtkAirlightReference at 160 x 120 pixels, which takes seconds to minutes. The
  // window has that size while this lives, and its own again afterwards. Or, for scenes with props
  // that the reference does not know, the shadow planes at the window's own size, which the tests
  // compare with it.
  enum class Exact
  {
    Reference,
    Planes
  };
  FrameErrors(FrameScene& scene, Exact exact);
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
  vtkSmartPointer<vtkDataArray> Airlight;
  vtkSmartPointer<vtkDataArray> Depth;
  int Size[2];
};
}

#endif
