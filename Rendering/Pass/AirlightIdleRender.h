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

#include <memory>
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
  static void OnTimer(vtkObject* caller, unsigned long event, void* self, void* timer);

  vtkNew<vtkCallbackCommand> Callback;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  int Timer = 0;
  std::vector<int> Spent; // timers that have rung
  unsigned long Observer = 0;
  bool Rung = false;
  std::shared_ptr<bool> Rendering = std::make_shared<bool>(false);
};
}

#endif
