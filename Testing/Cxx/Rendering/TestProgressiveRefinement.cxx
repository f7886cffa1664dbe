// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetProgressiveRefinement(): pictures add frames to a mean until it is complete,
// and then equal the one that has all frames at once. Each change starts the mean again.

#include "AirlightTestTools.h"
#include "RefinedScene.h"

#include "vtkAirlightLight.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

using namespace airlight_test;

namespace
{
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
// A window that gets another size, or is closed and opened again, with a part of the mean in it.
void TestWindowInProgress()
{
  RefinedScene scene;
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "larger", [&] { scene.Window->SetSize(130, 101); } },
    { "smaller", [&] { scene.Window->SetSize(31, 70); } },
    { "closed", [&] { scene.Window->Finalize(); } },
  };
  for (const auto& change : changes)
  {
    const std::string name = change.first;
    scene.Ball->Modified();
    scene.Window->Render();
    scene.Window->Render();
    Check(scene.Pass->GetAccumulatedFrames() == 2, name + ": a part of the mean");
    change.second();
    scene.Window->Render();
    Check(scene.Pass->GetAccumulatedFrames() == 1, name + ": the mean starts again");
    scene.Finish();
    const Picture refined = Capture(scene.Window);
    Check(refined == scene.CaptureAtOnce(), name + ": and is that of the window");
  }
}

// The same between two frames of one picture, as an observer may do. That picture may be broken,
// the next one not.
void TestWindowInPicture()
{
  RefinedScene scene;
  scene.Pass->ProgressiveRefinementOff();
  scene.Window->Render();
  vtkNew<vtkCallbackCommand> change;
  change->SetClientData(scene.Window);
  change->SetCallback([](vtkObject*, unsigned long, void* window, void* share) {
    if (*static_cast<double*>(share) > 0.4 && *static_cast<double*>(share) < 0.6)
    {
      static_cast<vtkRenderWindow*>(window)->SetSize(120, 50);
    }
  });
  const unsigned long observer = scene.Pass->AddObserver(vtkCommand::ProgressEvent, change);
  scene.Window->Render();
  scene.Pass->RemoveObserver(observer);
  const Picture after = Capture(scene.Window);
  Check(after.size() == 3 * 120 * 50, "the window has its new size");
  Check(scene.Pass->GetAccumulatedFrames() == Count, "all frames of it");
  scene.Pass->ProgressiveRefinementOn();
  scene.Finish();
  Check(Capture(scene.Window) == after, "and the mean is the new size's");
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
}

//------------------------------------------------------------------------------
int TestProgressiveRefinement(int, char*[])
{
  TestGrowth();
  TestChanges();
  TestAnnotations();
  TestCount();
  TestChangeInProgress();
  TestWindowInProgress();
  TestWindowInPicture();
  TestMoving();
  TestBuffers();
  TestNoRefinement();
  TestVisibleLamps();
  TestLinkedViews();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
