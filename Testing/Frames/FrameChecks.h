// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is true of every frame, whatever it shows.
 */

#ifndef FrameChecks_h
#define FrameChecks_h

#include "FrameStage.h"

#include <string>
#include <vector>

namespace airlight_test
{
using Problems = std::vector<std::string>;

// Numbers in their ranges, and buffers that agree with each other and with the picture.
void CheckFrame(const FrameScene& scene, const FrameRecord& frame, Problems& problems);

// How far two pictures of one scene may differ by rounding.
struct FrameRounding
{
  double Relative = 0.0; // of all buffers
  bool Blends = false;   // the radiance holds colours that VTK has blended in half precision
  int Levels = 0;        // of the picture's 256
};

// The same values, but for the rounding: without one, the same bytes.
void CheckSameFrame(const std::string& what, const FrameRecord& a, const FrameRecord& b,
  const FrameRounding& rounding, Problems& problems);

// Less light and less lit length in `less`, within the error bounds of both.
void CheckNotBrighter(
  const std::string& what, const FrameRecord& less, const FrameRecord& more, Problems& problems);
}

#endif
