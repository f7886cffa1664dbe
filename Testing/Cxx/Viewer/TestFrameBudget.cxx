// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Which frames are simpler while something moves: for frame times that are made up, with a limit of
// 100 ms.

#include "viewer/FrameBudget.h"

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using airlight::FrameBudget;
using Step = FrameBudget::Step;

namespace
{
constexpr double Limit = 0.1;

bool Passed = true;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Failed: " << what << "\n";
    Passed = false;
  }
}

struct Frame
{
  bool Moving;
  Step Expected;
  double Seconds; // that it then takes
};

void CheckFrames(const std::string& what, const std::vector<Frame>& frames, double limit = Limit)
{
  FrameBudget budget(limit);
  int number = 0;
  for (const Frame& frame : frames)
  {
    const Step step = budget.Begin(frame.Moving);
    Check(step == frame.Expected,
      what + ", frame " + std::to_string(number) + ": step " +
        std::to_string(static_cast<int>(step)));
    budget.End(frame.Seconds);
    ++number;
  }
}

// A quarter of the pixels takes a quarter of the time, as far as is known before.
void CheckStart()
{
  CheckFrames("fast", { { false, Step::Complete, 0.09 }, { true, Step::Complete, 0.09 } });
  CheckFrames("half", { { false, Step::Complete, 0.39 }, { true, Step::HalfSize, 0.09 } });
  CheckFrames("quarter", { { false, Step::Complete, 1.59 }, { true, Step::QuarterSize, 0.09 } });
  CheckFrames("slow", { { false, Step::Complete, 1.61 }, { true, Step::NoShadows, 0.09 } });
  CheckFrames("slowest", { { false, Step::Complete, 6.5 }, { true, Step::EighthSize, 0.09 } });
  CheckFrames("no frame before", { { true, Step::Complete, 9.0 } });
}

void CheckMotion()
{
  CheckFrames("coarser by one, and by as much as needed",
    { { false, Step::Complete, 0.09 }, { true, Step::Complete, 0.11 },
      { true, Step::HalfSize, 0.3 }, // the first of its step
      { true, Step::HalfSize, 0.5 }, { true, Step::NoShadows, 0.5 }, { true, Step::NoShadows, 0.5 },
      { true, Step::EighthSize, 0.5 } });
  CheckFrames("finer only with time to spare",
    { { false, Step::Complete, 1.5 }, { true, Step::QuarterSize, 0.01 },
      { true, Step::QuarterSize, 0.021 }, { true, Step::QuarterSize, 0.019 },
      { true, Step::HalfSize, 0.09 }, { true, Step::HalfSize, 0.021 },
      { true, Step::HalfSize, 0.019 }, { true, Step::Complete, 0.09 } });
  CheckFrames("no step twice",
    { { false, Step::Complete, 0.3 }, { true, Step::HalfSize, 0.09 },
      { true, Step::HalfSize, 0.11 }, { true, Step::QuarterSize, 0.01 },
      { true, Step::QuarterSize, 0.01 }, { true, Step::QuarterSize, 0.01 },
      // but in the next motion
      { false, Step::Complete, 0.3 }, { true, Step::HalfSize, 0.09 } });
}

void CheckRest()
{
  CheckFrames("complete at rest, and then from the last frame at rest",
    { { false, Step::Complete, 9.0 }, { true, Step::EighthSize, 0.2 },
      { false, Step::Complete, 9.0 }, { false, Step::Complete, 0.05 },
      { true, Step::Complete, 0.05 } });
  CheckFrames("no limit",
    { { false, Step::Complete, 9.0 }, { true, Step::Complete, 9.0 },
      { true, Step::Complete, 9.0 } },
    0.0);
}

void CheckTight()
{
  FrameBudget budget(Limit);
  Check(!budget.IsTight(), "before the first frame");
  for (const double seconds : { 0.11, 0.09, 0.11 })
  {
    budget.Begin(false);
    budget.End(seconds);
    Check(budget.IsTight() == (seconds > Limit), "tight after a frame at rest");
  }
  budget.Begin(true);
  budget.End(0.01);
  Check(budget.IsTight(), "tight while frames are simpler");
  FrameBudget none(0.0);
  none.Begin(false);
  none.End(9.0);
  Check(!none.IsTight(), "tight without a limit");
}

void CheckSizes()
{
  Check(FrameBudget::GetPixelSize(Step::Complete) == 1, "complete");
  Check(FrameBudget::GetPixelSize(Step::HalfSize) == 2, "half");
  Check(FrameBudget::GetPixelSize(Step::QuarterSize) == 4, "quarter");
  Check(FrameBudget::GetPixelSize(Step::NoShadows) == 4, "no shadows");
  Check(FrameBudget::GetPixelSize(Step::EighthSize) == 8, "eighth");
}
}

int TestFrameBudget(int, char*[])
{
  CheckStart();
  CheckMotion();
  CheckRest();
  CheckTight();
  CheckSizes();
  return Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
