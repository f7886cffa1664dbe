// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameOutput_h
#define FrameOutput_h

#include "FrameFigures.h"
#include "FrameRows.h"
#include "FrameWindow.h"

namespace benchmarks
{
/**
 * Where times were taken, and how quiet it was.
 */
struct Machine
{
  OpenGLNames OpenGL;
  std::string VTKVersion;
  unsigned Processors = 0;
  double LoadBefore = 0.0; // processes that ran or waited to, mean of the last minute
  double LoadAfter = 0.0;
};

/**
 * The results as text: for readers, for spreadsheets and for programs. Times are medians with both
 * quartiles; ratios are those of medians to the plain frame's.
 */
class FrameOutput
{
public:
  // Keeps references to both.
  FrameOutput(const Machine& machine, const Rows& rows);

  std::string GetMarkdown() const;
  std::string GetCsv() const;  // rows alone
  std::string GetJson() const; // null stands for what was not measured

private:
  double GetRatio(const Row& row, Times Row::*kind) const;
  std::string GetMarkdownHead() const;
  std::string GetMarkdownRow(const Row& row) const;
  std::string GetMarkdownFigures() const;

  const Machine& Where;
  const Rows& Measured;
};
}

#endif
