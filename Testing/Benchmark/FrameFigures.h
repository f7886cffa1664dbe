// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Figures that follow from the medians of several rows. *Extra* is a median minus that of the plain
 * frame of the same scene; *shadows* that of shadow planes minus that of no shadows.
 */

#ifndef FrameFigures_h
#define FrameFigures_h

#include "FrameRows.h"

namespace benchmarks
{
struct Figure
{
  std::string Name;
  double Clock;      // from the medians by the clock
  double Processors; // from those of the processors' time
};

// Those for which there are rows; NaN where the times are too short for the figure: a logarithm
// of nothing, or a share of it.
std::vector<Figure> DeriveFigures(const Rows& rows);
}

#endif
