// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightIdleRender.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

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
  this->Timer = interactor->CreateOneShotTimer(Delay);
}

//------------------------------------------------------------------------------
void IdleRender::Cancel()
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Observer);
    this->DestroyTimers();
  }
  this->Interactor = nullptr;
  this->Observer = 0;
  this->Timer = 0;
}

//------------------------------------------------------------------------------
// Interactors of VTK's own windows destroy timers that have rung but for their entries, which must
// not be destroyed while they ring: X11's would fail. Generic interactors let them ring on.
void IdleRender::DestroyTimers()
{
  if (this->Timer)
  {
    this->Interactor->DestroyTimer(this->Timer);
  }
  if (!*this->Rendering || this->Interactor->IsA("vtkGenericRenderWindowInteractor"))
  {
    for (const int timer : this->Spent)
    {
      this->Interactor->DestroyTimer(timer);
    }
    this->Spent.clear();
  }
}

//------------------------------------------------------------------------------
bool IdleRender::TakeRinging()
{
  const bool rung = this->Rung;
  this->Rung = false;
  return rung;
}

//------------------------------------------------------------------------------
// Generic interactors name the last timer that anybody made. This may be deleted while the window
// renders.
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
  idle->Spent.push_back(idle->Timer);
  idle->Timer = 0;
  idle->Rung = true; // until the picture, which applications may draw later
  const std::shared_ptr<bool> rendering = idle->Rendering;
  *rendering = true;
  idle->Cancel();
  interactor->Render();
  *rendering = false;
}
}
