// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameBudget_h
#define FrameBudget_h

namespace airlight
{

/**
 * How much of a frame is left out for it to take no longer than it may while something moves.
 *
 * A frame at rest is complete. The first frame of a motion follows from the last one at rest, by
 * the number of pixels. A frame that takes too long makes the next one as much simpler as needed,
 * and at least by one step; a frame that leaves time for the step before makes the next one that.
 * A step that took too long is not tried again in the same motion. The first frame of each step
 * is not judged: it allocates textures and compiles shaders.
 */
class FrameBudget
{
public:
  enum class Step
  {
    Complete,
    HalfSize,    ///< half as many pixels in width and height
    QuarterSize, ///< a quarter of them
    NoShadows,   ///< a quarter, and no shadows
    EighthSize   ///< an eighth, and no shadows
  };

  /**
   * Unit: seconds. 0 is no limit: all frames are complete.
   */
  explicit FrameBudget(double limit)
    : Limit(limit)
  {
  }

  /**
   * The step for the next frame.
   */
  Step Begin(bool moving);

  /**
   * The frame has taken so many seconds.
   */
  void End(double seconds);

  /**
   * Whether a motion would begin with frames that are not complete.
   */
  bool IsTight() const { return this->Limit > 0.0 && this->First != Step::Complete; }

  /**
   * A pixel of such a frame is as wide and high as so many of the window.
   */
  static int GetPixelSize(Step step);

private:
  Step FindStep(double seconds, Step drawn) const;
  bool LeavesTime(double seconds) const;

  double Limit;
  Step First = Step::Complete; // of the next motion
  Step Now = Step::Complete;
  Step Next = Step::Complete;
  Step Finest = Step::Complete; // that this motion may have
  bool Moving = false;
  bool Fresh = false; // the first frame of this step
};

}

#endif
