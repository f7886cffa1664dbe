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
// An interactor without an event loop has no timers yet, and is told so by none.
void IdleRender::Request(vtkRenderWindowInteractor* interactor)
{
  if (this->Timer && this->Interactor == interactor)
  {
    return;
  }
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
  if (this->Interactor && this->Observer)
  {
    this->Interactor->RemoveObserver(this->Observer);
    if (this->Timer)
    {
      this->Interactor->DestroyTimer(this->Timer);
    }
  }
  this->Interactor = nullptr;
  this->Observer = 0;
  this->Timer = 0;
}

//------------------------------------------------------------------------------
// This may be deleted while the window renders.
void IdleRender::OnTimer(vtkObject*, unsigned long, void* self, void* timer)
{
  auto* idle = static_cast<IdleRender*>(self);
  if (!timer || *static_cast<int*>(timer) != idle->Timer)
  {
    return;
  }
  vtkRenderWindowInteractor* interactor = idle->Interactor;
  idle->Timer = 0; // VTK destroys it: its X11 interactor fails if observers do
  idle->Cancel();
  const std::shared_ptr<bool> rendering = idle->Rendering;
  *rendering = true;
  interactor->Render();
  *rendering = false;
}
}
