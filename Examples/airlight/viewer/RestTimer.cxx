// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/RestTimer.h"

#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <utility>

namespace airlight
{

namespace
{
constexpr unsigned long Wait = 300;   // ms
constexpr float BeforeWidgets = 0.9F; // a priority
}

//------------------------------------------------------------------------------
RestTimer::RestTimer(vtkRenderWindowInteractor* interactor, std::function<void()> rest)
  : Interactor(interactor)
  , Rest(std::move(rest))
{
  interactor->AddObserver(vtkCommand::TimerEvent, this, &RestTimer::Tick);
  for (const auto event : { vtkCommand::LeftButtonPressEvent, vtkCommand::MiddleButtonPressEvent,
         vtkCommand::RightButtonPressEvent })
  {
    interactor->AddObserver(event, this, &RestTimer::Drop, BeforeWidgets);
  }
}

//------------------------------------------------------------------------------
void RestTimer::Start()
{
  this->Drop();
  this->Timer = this->Interactor->CreateOneShotTimer(Wait);
  this->Interactor->GetRenderWindow()->SetDesiredUpdateRate(
    this->Interactor->GetDesiredUpdateRate());
}

//------------------------------------------------------------------------------
bool RestTimer::Stop()
{
  if (this->Timer == 0)
  {
    return false;
  }
  this->Drop();
  this->SetStill();
  return true;
}

//------------------------------------------------------------------------------
void RestTimer::SetStill()
{
  this->Interactor->GetRenderWindow()->SetDesiredUpdateRate(this->Interactor->GetStillUpdateRate());
}

//------------------------------------------------------------------------------
void RestTimer::Tick(vtkObject*, unsigned long, void* timer)
{
  // Logs of events have timers, too, but not which.
  if (timer && this->Timer != 0 && *static_cast<int*>(timer) == this->Timer)
  {
    this->Timer = 0; // VTK destroys it after this call
    this->SetStill();
    this->Rest();
  }
}

//------------------------------------------------------------------------------
void RestTimer::Drop()
{
  if (this->Timer != 0)
  {
    this->Interactor->DestroyTimer(this->Timer);
    this->Timer = 0;
  }
}

}
