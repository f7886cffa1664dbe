// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetProgressiveRefinement(): an interactor asks for the frames of a mean by
// itself, until the picture is complete, the scene never rests, or something ends.

#include "AirlightTestTools.h"
#include "RefinedScene.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
// An interactor whose timers the test lets ring.
class TimedInteractor : public vtkRenderWindowInteractor
{
public:
  static TimedInteractor* New();
  vtkTypeMacro(TimedInteractor, vtkRenderWindowInteractor);

  void Initialize() override
  {
    this->Initialized = 1;
    this->Enable();
  }
  using vtkRenderWindowInteractor::GrabFocus;
  using vtkRenderWindowInteractor::ReleaseFocus;
  bool HasTimer() const { return !this->Timers.empty(); }
  void Ring()
  {
    int timer = this->Timers.front();
    this->Timers.erase(this->Timers.begin()); // it rings once
    this->Ringing = timer;
    this->InvokeEvent(vtkCommand::TimerEvent, &timer);
    this->Ringing = 0;
  }

protected:
  int InternalCreateTimer(int timer, int type, unsigned long) override
  {
    Check(type == OneShotTimer, "timers that ring once");
    this->Timers.push_back(timer);
    return timer;
  }
  int InternalDestroyTimer(int timer) override
  {
    Check(timer != this->Ringing, "X11's interactor fails if a timer is destroyed while it rings");
    this->Timers.erase(
      std::remove(this->Timers.begin(), this->Timers.end(), timer), this->Timers.end());
    return 1;
  }

private:
  std::vector<int> Timers;
  int Ringing = 0;
};

vtkStandardNewMacro(TimedInteractor);

class InteractiveScene : public RefinedScene
{
public:
  InteractiveScene()
  {
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->Initialize();
    CountEvents(this->Window, vtkCommand::EndEvent, this->Renders);
  }

  // How often it rings until it rings no more.
  int RingOn()
  {
    int rings = 0;
    for (; this->Interactor->HasTimer() && rings < 100; ++rings)
    {
      this->Interactor->Ring();
    }
    return rings;
  }

  vtkNew<TimedInteractor> Interactor;
  int Renders = 0;
};

//------------------------------------------------------------------------------
void TestInteractor()
{
  InteractiveScene scene;
  scene.Interactor->Render();
  Check(scene.Pass->GetAccumulatedFrames() == 1, "one frame at once");
  const int rings = scene.RingOn();
  Check(rings == Count - 1 && scene.Renders == Count, Text("the others by themselves: ", rings));
  const Picture refined = Capture(scene.Window);
  Check(!scene.Interactor->HasTimer(), "and no more");
  Check(refined == scene.CaptureAtOnce(), "the same picture as at once");
  Check(!scene.Interactor->HasTimer(), "what is complete at once asks for nothing");
  scene.Ball->Modified();
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Interactor->Render();
  Check(!scene.Interactor->HasTimer(), "nor what moves");
}

//------------------------------------------------------------------------------
// A scene that changes with each picture is not refined for ever.
void TestRestlessScene()
{
  InteractiveScene scene;
  vtkNew<vtkCallbackCommand> change;
  change->SetClientData(scene.Ball);
  change->SetCallback([](vtkObject*, unsigned long, void* ball, void*) {
    static_cast<vtkActor*>(ball)->AddPosition(0.001, 0.0, 0.0);
  });
  scene.Window->AddObserver(vtkCommand::StartEvent, change);
  scene.Interactor->Render();
  const int rings = scene.RingOn();
  Check(rings <= 4, Text("restless, after ", rings, " more pictures"));
  Check(scene.Pass->GetAccumulatedFrames() == Count, "restless, it has all frames in the end");
}

//------------------------------------------------------------------------------
// Two passes in a window with a scene that is never at rest.
void TestTwoPasses()
{
  InteractiveScene scene;
  RefinedScene other;
  Place(other, scene.Window, 0.5, 0.0, 1.0, 1.0);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkCallbackCommand> change;
  change->SetClientData(scene.Renderer->GetRenderWindow());
  change->SetCallback([](vtkObject*, unsigned long, void* window, void*) {
    vtkRendererCollection* renderers = static_cast<vtkRenderWindow*>(window)->GetRenderers();
    vtkCollectionSimpleIterator it = nullptr;
    renderers->InitTraversal(it);
    while (vtkRenderer* renderer = renderers->GetNextRenderer(it))
    {
      renderer->GetActors()->GetLastActor()->AddPosition(0.001, 0.0, 0.0);
    }
  });
  scene.Window->AddObserver(vtkCommand::StartEvent, change);
  scene.Interactor->Render();
  int rings = 0;
  while (scene.Interactor->HasTimer() && rings < 50)
  {
    scene.Interactor->Ring();
    ++rings;
  }
  Check(rings <= 12, Text("two restless scenes come to an end after ", rings));
}

//------------------------------------------------------------------------------
// Toolkits have interactors that name other timers, and repeat them until they are destroyed.
void TestToolkit()
{
  RefinedScene scene;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.Window);
  interactor->Initialize();
  int created = 0;
  int destroyed = 0;
  CountEvents(interactor, vtkCommand::CreateTimerEvent, created);
  CountEvents(interactor, vtkCommand::DestroyTimerEvent, destroyed);
  scene.Window->Render();
  Check(created == 1, "a timer of the toolkit");
  interactor->CreateRepeatingTimer(1000); // another's, by which ours would not be named
  for (int i = 0; i < 2 * Count; ++i)
  {
    interactor->TimerEvent();
  }
  Check(scene.Pass->GetAccumulatedFrames() == Count, "the toolkit's timers refine");
  Check(
    destroyed == created - 1, Text("and end: ", created, " created, ", destroyed, " destroyed"));
}

//------------------------------------------------------------------------------
// Styles render with each timer while a button is pressed, before or after the pass has, or in its
// place.
void TestStyle()
{
  vtkNew<vtkCallbackCommand> style;
  style->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkRenderWindow* window = static_cast<vtkRenderWindowInteractor*>(caller)->GetRenderWindow();
    window->SetDesiredUpdateRate(15.0);
    window->Render();
    window->SetDesiredUpdateRate(0.0001);
    window->Render();
  });
  InteractiveScene before;
  before.Interactor->AddObserver(vtkCommand::TimerEvent, style);
  before.Interactor->Render();
  InteractiveScene after;
  after.Interactor->Render();
  after.Interactor->AddObserver(vtkCommand::TimerEvent, style);
  InteractiveScene focus;
  focus.Interactor->Render();
  focus.Interactor->AddObserver(vtkCommand::TimerEvent, style);
  focus.Interactor->GrabFocus(style);
  for (int i = 0; i < 10; ++i)
  {
    before.Interactor->Ring();
    after.Interactor->Ring();
    focus.Interactor->Ring();
  }
  focus.Interactor->ReleaseFocus();
  Check(
    before.Interactor->HasTimer() && after.Interactor->HasTimer() && focus.Interactor->HasTimer(),
    "a restless window goes on");
}

//------------------------------------------------------------------------------
// Timers of a pass and of an interactor that are no more.
void TestEnd()
{
  InteractiveScene scene;
  scene.Interactor->Render();
  Check(scene.Interactor->HasTimer(), "a request");
  scene.Renderer->SetPass(nullptr);
  scene.Pass = nullptr;
  Check(scene.RingOn() <= 1, "of a pass that draws no more");
  RefinedScene other;
  {
    vtkNew<TimedInteractor> interactor;
    interactor->SetRenderWindow(other.Window);
    interactor->Initialize();
    interactor->Render();
    other.Window->SetInteractor(nullptr);
  }
  other.Finish();
  Check(other.Pass->GetAccumulatedFrames() == Count, "an interactor that is no more");
}

//------------------------------------------------------------------------------
// A window that is closed, and one that is no more, while an interactor has a timer for them.
void TestClosedWindow()
{
  InteractiveScene scene;
  scene.Interactor->Render();
  scene.Window->Finalize();
  scene.RingOn();
  Check(!scene.Interactor->HasTimer(), "a closed window comes to an end");
  scene.Window->Render();
  scene.Finish();
  const Picture refined = Capture(scene.Window);
  Check(refined == scene.CaptureAtOnce(), "and has its picture when it is opened again");
  vtkSmartPointer<vtkAirlightPass> pass;
  vtkSmartPointer<TimedInteractor> interactor;
  {
    InteractiveScene closed;
    closed.Interactor->Render();
    pass = closed.Pass;
    interactor = closed.Interactor;
    Check(interactor->HasTimer(), "a timer");
    interactor->SetRenderWindow(nullptr);
  }
  for (int i = 0; i < 2 && interactor->HasTimer(); ++i)
  {
    interactor->Ring();
  }
  RefinedScene next;
  next.Renderer->SetPass(pass);
  next.Pass = pass;
  next.Finish();
  Check(pass->GetAccumulatedFrames() == Count, "the pass of a window that is no more");
}
}

//------------------------------------------------------------------------------
int TestRefiningInteractors(int, char*[])
{
  TestInteractor();
  TestRestlessScene();
  TestTwoPasses();
  TestToolkit();
  TestStyle();
  TestEnd();
  TestClosedWindow();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
