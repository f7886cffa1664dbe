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

// The same bytes.
void CheckSameFrame(
  const std::string& what, const FrameRecord& a, const FrameRecord& b, Problems& problems);

// Less light and less lit length in `less`, within the error bounds of both.
void CheckNotBrighter(
  const std::string& what, const FrameRecord& less, const FrameRecord& more, Problems& problems);
}

#endif
