// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of smooth edges share: means of pictures over pixels by hand, and what pictures
 * of vtkAirlightPass::SetSubpixelFrames() and SetMultisampling() have in common.
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
class Scene;

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

// Of all values of a colour buffer, relative to the larger of the expected value and the mean;
// sorted.
std::vector<double> GetRelativeErrors(vtkImageData* image, const Means& expected);

// What makes the edges of a scene's pictures smooth, in its own window or another.
using Smoothing = std::function<void(Scene& scene, vtkRenderWindow* window)>;

// Two renderers side by side, the second of which does not begin at the window's corner, draw what
// one draws alone, in windows of this size.
void CheckViewports(int width, int height, const Smoothing& smooth);

// A picture in four tiles of this size is that of a larger window to 1 of 255. Pixels at the
// borders of tiles may be left out.
void CheckTiles(int width, int height, const Smoothing& smooth, bool borders);

// Buffers of a smooth picture beside those of one frame, and the 8-bit picture itself, which is not
// dithered: what a mean is, and what is the first frame's.
void CheckBuffers(const Buffers& one, const Buffers& smooth, const Picture& picture);
}

#endif
