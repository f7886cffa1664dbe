// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lets each rank of a parallel ParaView draw only the pixels at which it has the nearest surface:
 * all ranks exchange the depths of a frame before the medium is computed, and the first one draws
 * the background. Otherwise each of them computes the whole picture's medium, and IceT throws most
 * of it away.
 *
 * All ranks must take part in each exchange, as often as the others: each frame has one, either
 * when the pass asks (Choose()), or at its end (End()), for a rank whose pass does not: that one
 * draws all its pixels.
 */

#ifndef AirlightRemoteDepths_h
#define AirlightRemoteDepths_h

#include <array>
#include <vector>

class vtkMultiProcessController;

namespace airlight
{
class RemoteDepths
{
public:
  // Begins a frame: all ranks must call it together. `possible`: depths may be exchanged, on all
  // ranks alike. If the sizes of the ranks' pictures differ, nothing is.
  void Begin(vtkMultiProcessController* controller, bool possible, const std::array<int, 2>& size);

  // vtkAirlightPass::PixelChooser.
  bool Choose(int width, int height, const float* depths, unsigned char* drawn);

  // Whether the frame has left the background to the first rank.
  bool LeavesBackground() const { return this->BackgroundLeft; }

  // How many pixels the last frame has left to them.
  long long GetLeftOut() const { return this->LeftOut; }

  // Ends it, before the pictures are composited.
  void End();

private:
  std::vector<float> FindNearest(const float* depths);

  vtkMultiProcessController* Controller = nullptr; // of a frame whose exchange is still to come
  int Width = 0;
  int Height = 0;
  bool BackgroundLeft = false;
  long long LeftOut = 0;
};
}

#endif
