// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RestTimer_h
#define RestTimer_h

#include <functional>

class vtkObject;
class vtkRenderWindowInteractor;

namespace airlight
{

/**
 * Tells when keys and wheel have changed nothing for a while. They have no end, as drags have. From
 * Start() until then, the window counts as one in which something moves.
 *
 * A mouse button ends the waiting without a call: a frame at rest follows its release.
 */
class RestTimer
{
public:
  /**
   * The function is called in the window's event loop.
   */
  RestTimer(vtkRenderWindowInteractor* interactor, std::function<void()> rest);

  RestTimer(const RestTimer&) = delete;
  void operator=(const RestTimer&) = delete;

  /**
   * Something has changed: wait for 0.3 s, again if this was called before.
   */
  void Start();

  /**
   * Do not wait any longer, nor call. The window is at rest. False if there was nothing to wait
   * for.
   */
  bool Stop();

private:
  void Tick(vtkObject* caller, unsigned long event, void* timer);
  void SetStill();
  void Drop();

  vtkRenderWindowInteractor* Interactor;
  std::function<void()> Rest;
  int Timer = 0; // 0 is none
};

}

#endif
