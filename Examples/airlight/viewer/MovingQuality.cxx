// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/MovingQuality.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace airlight
{

namespace
{
constexpr double MovingUpdateRate = 1.0; // of a window; at rest it is far lower
}

//------------------------------------------------------------------------------
MovingQuality::MovingQuality(vtkRenderer* renderer, double limit)
  : Renderer(renderer)
  , Budget(limit)
  , Pass(vtkAirlightPass::SafeDownCast(renderer->GetPass()))
{
  if (this->Pass)
  {
    this->Size->SetDelegatePass(this->Pass);
    renderer->SetPass(this->Size);
  }
}

//------------------------------------------------------------------------------
bool MovingQuality::IsMoving() const
{
  return this->Renderer->GetRenderWindow()->GetDesiredUpdateRate() >= MovingUpdateRate;
}

//------------------------------------------------------------------------------
void MovingQuality::BeginFrame()
{
  const FrameBudget::Step step = this->Budget.Begin(this->IsMoving());
  if (this->Pass && step != this->Step)
  {
    this->Apply(step);
  }
}

//------------------------------------------------------------------------------
void MovingQuality::ReturnTechnique()
{
  if (!this->HasShadows())
  {
    this->Apply(FrameBudget::Step::QuarterSize);
  }
}

//------------------------------------------------------------------------------
void MovingQuality::EndFrame(double seconds)
{
  this->LastTime = seconds;
  this->Times[static_cast<std::size_t>(this->Step)] = seconds;
  this->Budget.End(seconds);
}

//------------------------------------------------------------------------------
double MovingQuality::GetFrameTime() const
{
  const double time = this->Times[static_cast<std::size_t>(this->Step)];
  return time > 0.0 ? time : this->LastTime;
}

//------------------------------------------------------------------------------
void MovingQuality::Apply(FrameBudget::Step step)
{
  const int size = FrameBudget::GetPixelSize(step);
  const bool shadows = step < FrameBudget::Step::NoShadows;
  this->Size->SetPixelSize(size);
  this->Pass->SetAnnotations(size == 1);
  if (!shadows && this->HasShadows())
  {
    this->Technique = this->Pass->GetShadowTechnique();
    this->Pass->SetShadowTechniqueToNone();
  }
  else if (shadows && !this->HasShadows())
  {
    this->Pass->SetShadowTechnique(this->Technique);
  }
  this->Step = step;
}

//------------------------------------------------------------------------------
std::string MovingQuality::GetText() const
{
  switch (this->Step)
  {
    case FrameBudget::Step::HalfSize:
      return "1/2 size";
    case FrameBudget::Step::QuarterSize:
      return "1/4 size";
    case FrameBudget::Step::NoShadows:
      return "1/4 size, no shadows";
    case FrameBudget::Step::EighthSize:
      return "1/8 size, no shadows";
    default:
      return "";
  }
}

}
