// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Renders a window once more as soon as its interactor has nothing else to do.
 */

#ifndef AirlightIdleRender_h
#define AirlightIdleRender_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkObject;
class vtkRenderWindowInteractor;

namespace airlight
{
class IdleRender
{
public:
  IdleRender();
  ~IdleRender();
  IdleRender(const IdleRender&) = delete;
  void operator=(const IdleRender&) = delete;

  // By a timer of this interactor, whose event loop must run. A request that was made before counts
  // no more: its timer may be lost.
  void Request(vtkRenderWindowInteractor* interactor);
  void Cancel();

  // Whether the next picture is what was requested. True once a request.
  bool TakeRinging();

private:
  void DestroyTimers();
  static void NoteTimer(vtkObject* caller, unsigned long event, void* self, void* timer);
  static void OnTimer(vtkObject* caller, unsigned long event, void* self, void* timer);

  vtkNew<vtkCallbackCommand> Callback;
  vtkNew<vtkCallbackCommand> Watch;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  int Timer = 0;
  int Ringing = 0;        // the last timer that rang, of whomever; not of generic interactors
  std::vector<int> Spent; // timers to be destroyed
  unsigned long Observer = 0;
  unsigned long Watcher = 0;
  bool Rung = false;
};
}

#endif
