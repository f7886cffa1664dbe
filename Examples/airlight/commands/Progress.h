// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Progress_h
#define Progress_h

#include <chrono>

namespace airlight
{

/**
 * A bar on the error stream that says how many frames are done and how long the rest will take.
 * Nothing is printed if the error stream is not a terminal.
 */
class Progress
{
public:
  /**
   * Time begins here. `all` is the number of frames, at least 1.
   */
  explicit Progress(int all);

  /**
   * Ends the line if not all are done, so that an error has one of its own.
   */
  ~Progress();

  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  void Show(int done);

private:
  int All;
  bool Visible;
  bool Open = false; // the line
  std::chrono::steady_clock::time_point Start;
};

}

#endif
