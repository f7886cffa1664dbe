// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Means of pictures over pixels by hand, to compare vtkAirlightPass::SetSubpixelFrames() with.
 */

#ifndef AirlightTestMeans_h
#define AirlightTestMeans_h

#include "AirlightTestBuffers.h"

#include <functional>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;

namespace airlight_test
{
using Means = std::vector<double>;

// The mean of pictures on a grid of 16 x 16 places in each pixel of a renderer that fills its
// window.
Means AverageByHand(vtkRenderWindow* window, vtkRenderer* renderer);

// The same of what `capture` returns.
Means AverageByHand(
  vtkRenderWindow* window, vtkRenderer* renderer, const std::function<Picture()>& capture);

// The root mean square of the differences, over the values that one frame has wrong by more than 4
// steps of 255: the edges.
double GetEdgeError(const Means& expected, const Picture& one, const Picture& picture);
}

#endif
