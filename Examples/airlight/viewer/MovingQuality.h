// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovingQuality_h
#define MovingQuality_h

#include "viewer/FrameBudget.h"
#include "viewer/ReducedSizePass.h"

#include <vtkAirlightPass.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
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
  void EndFrame(double seconds);
  ///@}

  /**
   * Before a key may choose another technique: to the chosen one, until the next frame.
   */
  void ReturnTechnique();

  /**
   * Whether the window is in motion.
   */
  bool IsMoving() const;

  /**
   * Whether complete frames take longer than they may while something moves.
   */
  bool IsSlow() const { return this->Budget.IsTight(); }

  /**
   * Whether the frame has the shadows that were chosen.
   */
  bool HasShadows() const { return this->Step < FrameBudget::Step::NoShadows; }

  /**
   * How long the last frame took that was reduced as this one, or, if this is the first, the last
   * frame. Unit: seconds.
   */
  double GetFrameTime() const;

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
  std::array<double, 5> Times = { 0.0, 0.0, 0.0, 0.0, 0.0 }; // seconds, by step; 0 is unknown
  double LastTime = 0.0;                                     // of the last frame
  int Technique = vtkAirlightPass::AUTOMATIC;                // to return to
};

}

#endif
