// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/FrameBudget.h"

#include <algorithm>

namespace airlight
{

namespace
{
using Step = FrameBudget::Step;

constexpr double Reserve = 1.25; // before a finer step is tried

// A share of the time of complete frames, if pixels were all. How long shadows take is not known:
// as long as four times the pixels.
double GetShare(Step step)
{
  const double size = FrameBudget::GetPixelSize(step);
  return (step < Step::NoShadows ? 1.0 : 0.25) / (size * size);
}

Step GetCoarser(Step step)
{
  return step == Step::EighthSize ? step : static_cast<Step>(static_cast<int>(step) + 1);
}

Step GetFiner(Step step)
{
  return step == Step::Complete ? step : static_cast<Step>(static_cast<int>(step) - 1);
}
}

//------------------------------------------------------------------------------
int FrameBudget::GetPixelSize(Step step)
{
  switch (step)
  {
    case Step::Complete:
      return 1;
    case Step::HalfSize:
      return 2;
    case Step::EighthSize:
      return 8;
    default:
      return 4;
  }
}

//------------------------------------------------------------------------------
Step FrameBudget::Begin(bool moving)
{
  Step step = Step::Complete;
  if (moving && this->Limit > 0.0)
  {
    step = this->Moving ? this->Next : this->First;
    this->Finest = this->Moving ? this->Finest : Step::Complete;
  }
  this->Fresh = step != this->Now;
  this->Now = step;
  this->Next = step;
  this->Moving = moving;
  return step;
}

//------------------------------------------------------------------------------
void FrameBudget::End(double seconds)
{
  if (!this->Moving)
  {
    this->First = this->FindStep(seconds, Step::Complete);
    return;
  }
  if (this->Fresh)
  {
    return;
  }
  if (seconds > this->Limit)
  {
    this->Finest = GetCoarser(this->Now);
    this->Next = std::max(this->Finest, this->FindStep(seconds, this->Now));
  }
  else if (this->Now > this->Finest && this->LeavesTime(seconds))
  {
    this->Next = GetFiner(this->Now);
  }
}

//------------------------------------------------------------------------------
Step FrameBudget::FindStep(double seconds, Step drawn) const
{
  Step step = drawn;
  while (step != Step::EighthSize && seconds * GetShare(step) / GetShare(drawn) > this->Limit)
  {
    step = GetCoarser(step);
  }
  return step;
}

//------------------------------------------------------------------------------
bool FrameBudget::LeavesTime(double seconds) const
{
  return 4.0 * Reserve * seconds <= this->Limit;
}

}
