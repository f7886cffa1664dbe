// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightIdleRender.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr unsigned long Delay = 1; // in milliseconds: input that waits comes first
}

//------------------------------------------------------------------------------
IdleRender::IdleRender()
{
  this->Callback->SetClientData(this);
  this->Callback->SetCallback(&IdleRender::OnTimer);
  this->Watch->SetClientData(this);
  this->Watch->SetCallback(&IdleRender::NoteTimer);
  this->Watch->PassiveObserverOn(); // before all others, also those that have the focus
}

IdleRender::~IdleRender() { this->Cancel(); }

//------------------------------------------------------------------------------
// Interactors without an event loop have no timers yet.
void IdleRender::Request(vtkRenderWindowInteractor* interactor)
{
  this->Cancel();
  if (!interactor->GetInitialized())
  {
    return;
  }
  this->Interactor = interactor;
  this->Observer = interactor->AddObserver(vtkCommand::TimerEvent, this->Callback);
  this->Watcher = interactor->AddObserver(vtkCommand::TimerEvent, this->Watch);
  this->Timer = interactor->CreateOneShotTimer(Delay);
}

//------------------------------------------------------------------------------
void IdleRender::Cancel()
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Observer);
    this->Interactor->RemoveObserver(this->Watcher);
    if (this->Timer)
    {
      this->Spent.push_back(this->Timer);
    }
    this->DestroyTimers();
  }
  this->Interactor = nullptr;
  this->Observer = 0;
  this->Watcher = 0;
  this->Timer = 0;
}

//------------------------------------------------------------------------------
// An entry that is destroyed while its timer rings breaks the loop of X11's interactor over them,
// and interactor styles render while a button is pressed, with each timer. Nobody says when it has
// ended: the last one that rang stays until another one has.
void IdleRender::DestroyTimers()
{
  const auto stay = std::partition(
    this->Spent.begin(), this->Spent.end(), [this](int timer) { return timer == this->Ringing; });
  std::for_each(
    stay, this->Spent.end(), [this](int timer) { this->Interactor->DestroyTimer(timer); });
  this->Spent.erase(stay, this->Spent.end());
}

//------------------------------------------------------------------------------
bool IdleRender::TakeRinging()
{
  const bool rung = this->Rung;
  this->Rung = false;
  return rung;
}

//------------------------------------------------------------------------------
// Generic interactors name the last timer that anybody made.
void IdleRender::NoteTimer(vtkObject* caller, unsigned long, void* self, void* timer)
{
  if (timer && !caller->IsA("vtkGenericRenderWindowInteractor"))
  {
    static_cast<IdleRender*>(self)->Ringing = *static_cast<int*>(timer);
  }
}

//------------------------------------------------------------------------------
// This may be deleted while the window renders.
void IdleRender::OnTimer(vtkObject* caller, unsigned long, void* self, void* timer)
{
  auto* idle = static_cast<IdleRender*>(self);
  vtkRenderWindowInteractor* interactor = idle->Interactor;
  if (!idle->Timer || interactor != caller ||
    (!interactor->IsA("vtkGenericRenderWindowInteractor") &&
      (!timer || *static_cast<int*>(timer) != idle->Timer)))
  {
    return;
  }
  idle->Rung = true; // until the picture, which applications may draw later
  idle->Cancel();
  interactor->Render();
}
}
