// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetProgressiveRefinement(): pictures add frames to a mean until it is complete,
// and then equal the one that has all frames at once. Each change starts the mean again. An
// interactor asks for the frames by itself.

#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightLight.h"
#include "vtkCallbackCommand.h"
#include "vtkElevationFilter.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRendererCollection.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Count = 6;

// With a ball whose size a filter of its pipeline sets, and a plane that cuts it.
class RefinedScene : public WindowScene
{
public:
  RefinedScene()
    : WindowScene(96, 72)
  {
    this->Source->SetThetaResolution(24);
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Filter->GetOutputPort());
    mapper->ScalarVisibilityOff();
    this->Plane->SetOrigin(0.0, 0.0, -5.0);
    this->Plane->SetNormal(0.0, 0.0, 1.0);
    mapper->AddClippingPlane(this->Plane);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(0.2, 1.3, 0.0);
    this->Renderer->AddActor(actor);
    this->Image->SetDimensions(2, 2, 1);
    this->Image->AllocateScalars(VTK_FLOAT, 1);
    this->Image->GetPointData()->GetScalars()->Fill(128.0);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(this->Image);
    this->Table->SetRange(0.0, 255.0);
    this->Table->Build();
    texture->SetLookupTable(this->Table);
    this->Floor->SetTexture(texture);
    this->Lamp = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    this->Lamp->SetTransformMatrix(this->Matrix);
    this->Pass->SetSubpixelFrames(Count);
    this->Pass->ProgressiveRefinementOn();
  }

  void Finish()
  {
    for (int i = 0; i < Count; ++i)
    {
      this->Window->Render();
    }
  }

  Picture CaptureAtOnce()
  {
    this->Pass->ProgressiveRefinementOff();
    const Picture picture = Capture(this->Window);
    this->Pass->ProgressiveRefinementOn();
    return picture;
  }

  vtkNew<vtkImageData> Image;
  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkMatrix4x4> Matrix; // of the lamp
  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkElevationFilter> Filter;
  vtkNew<vtkPlane> Plane;
  vtkLight* Lamp = nullptr;
};

void CountEvents(vtkObject* object, unsigned long event, int& count)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&count);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  object->AddObserver(event, command);
}

//------------------------------------------------------------------------------
void TestGrowth()
{
  RefinedScene scene;
  int frames = 0;
  CountEvents(scene.Pass, vtkCommand::ProgressEvent, frames);
  Check(scene.Pass->GetAccumulatedFrames() == 0, "no picture yet");
  const Picture first = Capture(scene.Window);
  Picture before = first;
  for (int i = 2; i <= Count; ++i)
  {
    const Picture picture = Capture(scene.Window);
    Check(scene.Pass->GetAccumulatedFrames() == i && frames == i, Text("frame ", i));
    Check(picture != before, Text("picture ", i, " is another"));
    before = picture;
  }
  Check(Capture(scene.Window) == before && frames == Count, "complete: no further frame is drawn");
  Check(scene.Pass->GetAccumulatedFrames() == Count, "and all are in the mean");
  Check(scene.CaptureAtOnce() == before, "the same picture as at once");
  Check(Capture(scene.Window) == first, "and the mean starts again");
}

//------------------------------------------------------------------------------
void TestChanges()
{
  RefinedScene scene;
  vtkNew<vtkActor> another;
  another->SetMapper(scene.Cube->GetMapper());
  another->SetPosition(-2.0, -1.0, 2.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "camera", [&] { camera->Azimuth(2.0); } },
    { "actor", [&] { scene.Ball->AddPosition(0.1, 0.0, 0.0); } },
    { "filter", [&] { scene.Source->SetRadius(0.7); } },
    { "plane", [&] { scene.Plane->SetOrigin(0.0, 0.0, 0.1); } },
    { "property", [&] { scene.Cube->GetProperty()->SetColor(1.0, 0.2, 0.2); } },
    { "opacity", [&] { scene.Cube->GetProperty()->SetOpacity(0.5); } },
    { "opaque again", [&] { scene.Cube->GetProperty()->SetOpacity(1.0); } },
    { "hidden", [&] { scene.Ball->VisibilityOff(); } },
    { "texture",
      [&] {
        scene.Image->GetPointData()->GetScalars()->Fill(250.0);
        scene.Image->Modified();
      } },
    { "light's matrix", [&] { scene.Matrix->SetElement(0, 3, 0.5); } },
    { "texture's table", [&] { scene.Table->SetTableValue(128, 1.0, 0.5, 0.2); } },
    { "key", [&] { vtkAirlightPass::SetCastsShadow(scene.Cube, false); } },
    { "added", [&] { scene.Renderer->AddActor(another); } },
    { "removed", [&] { scene.Renderer->RemoveActor(another); } },
    { "light", [&] { scene.Lamp->SetPosition(2.0, 4.0, 2.0); } },
    { "light's key", [&] { vtkAirlightLight::SetRadius(scene.Lamp, 0.3); } },
    { "medium", [&] { scene.Medium->SetScattering(0.1, 0.05, 0.05); } },
    { "background", [&] { scene.Renderer->SetBackground(0.1, 0.0, 0.2); } },
    { "pass", [&] { scene.Pass->SetShadowTechniqueToRayMarch(); } },
    { "frames", [&] { scene.Pass->SetSubpixelFrames(Count - 1); } },
    { "size", [&] { scene.Window->SetSize(90, 70); } },
  };
  for (const auto& change : changes)
  {
    const std::string name = change.first;
    scene.Finish();
    scene.Window->Render();
    Check(
      scene.Pass->GetAccumulatedFrames() == scene.Pass->GetSubpixelFrames(), name + ": at rest");
    change.second();
    scene.Window->Render();
    Check(scene.Pass->GetAccumulatedFrames() == 1, name + ": the mean starts again");
    scene.Finish();
    const Picture refined = Capture(scene.Window);
    Check(refined == scene.CaptureAtOnce(), name + ": the picture is the new one's");
  }
}

//------------------------------------------------------------------------------
// Annotations follow without a new frame.
void TestAnnotations()
{
  RefinedScene scene;
  vtkNew<vtkTextActor> text;
  text->SetInput("1");
  text->GetTextProperty()->SetFontSize(30);
  scene.Renderer->AddActor2D(text);
  scene.Finish();
  const Picture before = Capture(scene.Window);
  int frames = 0;
  CountEvents(scene.Pass, vtkCommand::ProgressEvent, frames);
  text->SetInput("2");
  const Picture after = Capture(scene.Window);
  Check(after != before && frames == 0, "a text changes and no frame is drawn");
  Check(after == scene.CaptureAtOnce(), "to what it is with all frames at once");
}

//------------------------------------------------------------------------------
// Observers of the progress know the number, as those who show it need.
void TestCount()
{
  RefinedScene scene;
  vtkNew<vtkCallbackCommand> count;
  count->SetCallback([](vtkObject* pass, unsigned long, void*, void* share) {
    const int frames = static_cast<vtkAirlightPass*>(pass)->GetAccumulatedFrames();
    Check(frames == std::lround(*static_cast<double*>(share) * Count),
      Text("the number in its progress: ", frames));
  });
  scene.Pass->AddObserver(vtkCommand::ProgressEvent, count);
  scene.Finish();
  Check(scene.Pass->GetAccumulatedFrames() == Count, "the number of all frames");
}

//------------------------------------------------------------------------------
// A change during a picture is none of the picture before.
void TestChangeInProgress()
{
  RefinedScene scene;
  vtkNew<vtkCallbackCommand> change;
  change->SetClientData(scene.Ball);
  change->SetCallback([](vtkObject*, unsigned long, void* ball, void* share) {
    if (*static_cast<double*>(share) > 0.4 && *static_cast<double*>(share) < 0.6)
    {
      static_cast<vtkActor*>(ball)->AddPosition(0.3, 0.0, 0.0);
    }
  });
  const unsigned long observer = scene.Pass->AddObserver(vtkCommand::ProgressEvent, change);
  for (int i = 0; i < 3; ++i)
  {
    scene.Window->Render();
  }
  scene.Pass->RemoveObserver(observer);
  scene.Window->Render();
  Check(scene.Pass->GetAccumulatedFrames() == 1, "a change between frames starts again");
  scene.Finish();
  const Picture refined = Capture(scene.Window);
  Check(refined == scene.CaptureAtOnce(), "and is in all of the mean");
}

//------------------------------------------------------------------------------
// One frame while the user moves something; at rest, the mean.
void TestMoving()
{
  RefinedScene scene;
  scene.Finish();
  const Picture mean = Capture(scene.Window);
  scene.Window->SetDesiredUpdateRate(15.0);
  Check(Capture(scene.Window) != mean && scene.Pass->GetAccumulatedFrames() == 1,
    "one frame while something moves");
  scene.Window->SetDesiredUpdateRate(0.0001);
  scene.Finish();
  Check(Capture(scene.Window) == mean, "and the mean at rest");
}

//------------------------------------------------------------------------------
void TestBuffers()
{
  RefinedScene scene;
  scene.Pass->RecordBuffersOn();
  scene.Finish();
  vtkNew<vtkImageData> refined;
  refined->DeepCopy(scene.Pass->GetBuffer("Radiance"));
  scene.Pass->ProgressiveRefinementOff();
  scene.Window->Render();
  Check(AreSame(refined, scene.Pass->GetBuffer("Radiance")), "the same buffers as at once");
}

//------------------------------------------------------------------------------
// What cannot be refined has all frames at once; what cannot be averaged, one.
void TestNoRefinement()
{
  RefinedScene scene;
  scene.Pass->SetDebugViewToBoundaryCount();
  scene.Window->Render();
  Check(scene.Pass->GetAccumulatedFrames() == 1, "counts have one frame");
  scene.Pass->SetDebugViewToShaded();
  scene.Window->SetTileScale(2);
  scene.Window->Render();
  Check(scene.Pass->GetAccumulatedFrames() == Count, "tiles have all at once");
}

//------------------------------------------------------------------------------
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
  bool HasTimer() const { return !this->Timers.empty(); }
  void Ring()
  {
    int timer = this->Timers.front();
    this->Timers.erase(this->Timers.begin()); // it rings once
    this->InvokeEvent(vtkCommand::TimerEvent, &timer);
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
    this->Timers.erase(
      std::remove(this->Timers.begin(), this->Timers.end(), timer), this->Timers.end());
    return 1;
  }

private:
  std::vector<int> Timers;
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
// Lamps that are seen, near and beyond the camera's clipping range.
void TestVisibleLamps()
{
  RefinedScene scene;
  vtkAirlightLight::SetRadius(scene.Lamp, 0.3);
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  scene.Lamp->SetPosition(0.5, 2.0, 3.0);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  for (const double factor : { 1.0, 0.3 })
  {
    double range[2];
    scene.Renderer->ResetCameraClippingRange();
    camera->GetClippingRange(range);
    camera->SetClippingRange(range[0], range[0] + factor * (range[1] - range[0]));
    scene.Finish();
    Check(scene.Pass->GetAccumulatedFrames() == Count, Text("a visible lamp, ", factor));
    const Picture refined = Capture(scene.Window);
    Check(refined == scene.CaptureAtOnce(), "and the picture of all frames at once");
  }
}

//------------------------------------------------------------------------------
// Two views of the same actors, light and camera, whose passes move them in turn.
void TestLinkedViews()
{
  RefinedScene scene;
  vtkAirlightLight::SetRadius(scene.Lamp, 0.3);
  RefinedScene other;
  other.Renderer->RemoveAllViewProps();
  other.Renderer->RemoveAllLights();
  other.Renderer->AddLight(scene.Lamp);
  for (vtkActor* actor : { scene.Floor, scene.Ball, scene.Cube })
  {
    other.Renderer->AddActor(actor);
  }
  other.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  Place(other, scene.Window, 0.5, 0.0, 1.0, 1.0);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  scene.Finish();
  Check(scene.Pass->GetAccumulatedFrames() == Count && other.Pass->GetAccumulatedFrames() == Count,
    Text("linked views: ", scene.Pass->GetAccumulatedFrames(), " and ",
      other.Pass->GetAccumulatedFrames()));
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
}

//------------------------------------------------------------------------------
int TestProgressiveRefinement(int, char*[])
{
  TestGrowth();
  TestChanges();
  TestAnnotations();
  TestCount();
  TestChangeInProgress();
  TestMoving();
  TestBuffers();
  TestNoRefinement();
  TestInteractor();
  TestRestlessScene();
  TestTwoPasses();
  TestVisibleLamps();
  TestLinkedViews();
  TestToolkit();
  TestEnd();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
