// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovingQuality_h
#define MovingQuality_h

#include "viewer/FrameBudget.h"
#include "viewer/ReducedSizePass.h"

#include <vtkAirlightPass.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkRenderer;

namespace airlight
{

/**
 * Makes frames simpler while something moves, as FrameBudget says: fewer pixels, then no shadows.
 * Frames at rest are drawn as if this were not there.
 */
class MovingQuality
{
public:
  /**
   * The renderer's pass is wrapped in one that renders fewer pixels. The limit is in seconds; 0 is
   * none.
   */
  MovingQuality(vtkRenderer* renderer, double limit);

  MovingQuality(const MovingQuality&) = delete;
  void operator=(const MovingQuality&) = delete;

  ///@{
  /**
   * Before each frame, and after it with the seconds that it took.
   */
  void BeginFrame();
  void EndFrame(double seconds) { this->Budget.End(seconds); }
  ///@}

  /**
   * What of the frame is reduced; empty if nothing is.
   */
  std::string GetText() const;

private:
  void Apply(FrameBudget::Step step);

  vtkRenderer* Renderer;
  FrameBudget Budget;
  FrameBudget::Step Step = FrameBudget::Step::Complete;
  vtkSmartPointer<vtkAirlightPass> Pass;
  vtkNew<ReducedSizePass> Size;
  int Technique = vtkAirlightPass::AUTOMATIC; // to return to
};

}

#endif
