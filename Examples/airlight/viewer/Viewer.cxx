// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/Viewer.h"

#include "commands/OptionText.h"
#include "formats/Files.h"
#include "formats/ImageFile.h"
#include "formats/Picture.h"
#include "formats/UserError.h"
#include "viewer/EventLog.h"
#include "viewer/ViewerStyle.h"

#include <vtkInteractorEventRecorder.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

namespace airlight
{

namespace
{
// Keys on the number pad and in the top row that mean the same.
const std::map<std::string, std::string> SameKeys = { { "equal", "plus" }, { "KP_Add", "plus" },
  { "KP_Subtract", "minus" }, { "KP_Left", "Left" }, { "KP_Right", "Right" }, { "KP_Up", "Up" },
  { "KP_Down", "Down" }, { "KP_Prior", "Prior" }, { "KP_Next", "Next" } };

// That are kept down
const std::vector<std::string> HeldKeys = { "plus", "minus", "Left", "Right", "Up", "Down", "Prior",
  "Next" };

std::string FindFreeFile(const std::string& pattern)
{
  int number = 0;
  while (std::filesystem::exists(NumberFile("--screenshots", pattern, number)))
  {
    ++number;
  }
  return NumberFile("--screenshots", pattern, number);
}
}

//------------------------------------------------------------------------------
const char* Viewer::GetKeys()
{
  return R"(  t, T               shadow technique: next, previous
  v, V               view: picture, airlight only, boundary count, outlines of
                     shadows
  +, -               visibility: times 1.25, by 1.25
  drag a lamp's dot  choose and move that lamp
  arrows, Ctrl+drag  move the chosen lamp
  Page Up, Page Down move it away, near
  n                  choose the next lamp
  e                  automatic exposure again
  p                  sliders on, off
  s                  screenshot of the window
  i                  read-out, dots and sliders on, off
  h                  these keys on, off
  r                  the first view again
  drag, Shift+drag   turn, move; wheel: zoom
  q                  quit)";
}

//------------------------------------------------------------------------------
Viewer::Viewer(const Scene& scene, const RenderSettings& settings, const ViewerSettings& viewer)
  : Settings(viewer)
{
  if (CheckImageFile(NumberFile("--screenshots", viewer.Screenshots, 0)) != ImageFormat::Png)
  {
    throw UserError("--screenshots " + viewer.Screenshots + ": a screenshot is a .png");
  }
  if (!viewer.Record.empty())
  {
    CheckOutputFile(viewer.Record);
  }
  this->Log = viewer.Play.empty() ? "" : ReadEventLog(viewer.Play);
  this->Rendered = BuildScene(scene, settings);
  this->Controls = std::make_unique<SceneControls>(this->Rendered);
  this->Pass = vtkAirlightPass::SafeDownCast(this->Rendered.Renderer->GetPass());
  this->Refinement = std::make_unique<RestRefinement>(this->Pass, viewer.Frames);
  this->Quality = std::make_unique<MovingQuality>(this->Rendered.Renderer, 1e-3 * viewer.FrameTime);
  this->Text = std::make_unique<ReadOut>(this->Rendered.Renderer);
  this->Text->SetHelp(Viewer::GetKeys());
  this->Markers = std::make_unique<LampMarkers>(this->Rendered.Renderer, this->Rendered.Lights);
  vtkNew<ViewerStyle> style;
  style->SetOwner(this);
  this->Interactor->SetInteractorStyle(style);
  this->Interactor->SetRenderWindow(this->Rendered.Window);
  this->Sliders = std::make_unique<SliderPanel>(
    this->Interactor, this->Rendered.Renderer, this->Controls->GetLevels());
  this->Rest = std::make_unique<RestTimer>(this->Interactor, [this] { this->DrawAtRest(); });
}

//------------------------------------------------------------------------------
void Viewer::Run()
{
  vtkRenderWindow* window = this->Rendered.Window;
  window->AddObserver(vtkCommand::StartEvent, this, &Viewer::StartFrame);
  window->AddObserver(vtkCommand::EndEvent, this, &Viewer::EndFrame);
  if (this->Pass)
  {
    this->Pass->AddObserver(vtkCommand::ProgressEvent, this, &Viewer::NoteFrame);
  }
  this->Interactor->AddObserver(vtkCommand::ExitEvent, this, &Viewer::Quit);
  this->Interactor->Initialize();
  this->DrawTwice();
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(this->Interactor);
  recorder->SetKeyPressActivation(false); // or the key i would start and stop it
  if (!this->Log.empty())
  {
    recorder->ReadFromInputStringOn();
    recorder->SetInputString(this->Log.c_str());
    recorder->Play();
  }
  if (!this->Done && !this->Settings.Record.empty())
  {
    recorder->SetFileName(this->Settings.Record.c_str());
    recorder->On();
    recorder->Record();
  }
  if (!this->Done)
  {
    this->Live = true;
    if (this->Settings.Record.empty()) // or its timers would be recorded
    {
      this->Refinement->Start();
      this->Interactor->Render();
    }
    this->Interactor->Start();
  }
  if (!this->Error.empty())
  {
    throw UserError(this->Error);
  }
}

//------------------------------------------------------------------------------
void Viewer::PressKey(const std::string& name)
{
  if (this->Done) // the rest of a log that quits before its end
  {
    return;
  }
  const auto same = SameKeys.find(name);
  const std::string key = same == SameKeys.end() ? name : same->second;
  this->Quality->ReturnTechnique();
  try
  {
    if (key == "s")
    {
      if (this->Rest->Stop())
      {
        this->DrawTwice();
      }
      this->Refinement->Finish(this->Rendered);
      this->SaveScreenshot();
    }
    else if (this->ChangeText(key) || this->Controls->PressKey(key))
    {
      this->DrawChange(key);
    }
  }
  catch (const UserError& error) // not through VTK's event loop
  {
    this->Fail(error.what());
  }
}

//------------------------------------------------------------------------------
bool Viewer::ChangeText(const std::string& name)
{
  if (name == "i")
  {
    this->Text->SetVisible(!this->Text->GetVisible());
    return true;
  }
  if (name == "h")
  {
    this->Text->SetHelpVisible(!this->Text->GetHelpVisible());
    return true;
  }
  if (name == "p")
  {
    this->ShowsSliders = !this->ShowsSliders;
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
bool Viewer::TakeLamp(int x, int y)
{
  const int lamp = this->Markers->Find(x, y);
  this->DotOffset = { 0.0, 0.0 };
  if (this->Done || lamp == LampMarkers::None)
  {
    return false;
  }
  this->Controls->ChooseLamp(lamp);
  this->DotOffset = this->Markers->GetOffset(lamp);
  return true;
}

//------------------------------------------------------------------------------
void Viewer::PointAt(int x, int y)
{
  if (!this->Done)
  {
    const bool takes = this->Markers->Find(x, y) != LampMarkers::None;
    this->Rendered.Window->SetCurrentCursor(takes ? VTK_CURSOR_HAND : VTK_CURSOR_DEFAULT);
  }
}

//------------------------------------------------------------------------------
void Viewer::DragLamp(int right, int up)
{
  if (!this->Done && (right != 0 || up != 0))
  {
    this->Controls->DragLamp(right + this->DotOffset[0], up + this->DotOffset[1]);
    this->DotOffset = { 0.0, 0.0 };
    this->Interactor->Render();
  }
}

//------------------------------------------------------------------------------
void Viewer::SaveScreenshot()
{
  const std::string file = FindFreeFile(this->Settings.Screenshots);
  WritePng(GrabWindow(this->Rendered.Window), file);
  std::string state = this->Shown;
  std::replace(state.begin(), state.end(), '\n', ';');
  std::cout << file << ": " << state << std::endl;
}

//------------------------------------------------------------------------------
void Viewer::DrawTwice()
{
  for (int i = 0; i < 2; ++i)
  {
    this->Rendered.Render();
  }
}

//------------------------------------------------------------------------------
void Viewer::DrawChange(const std::string& key)
{
  const bool oneOfMany = std::find(HeldKeys.begin(), HeldKeys.end(), key) != HeldKeys.end();
  if (oneOfMany && this->DeferRest())
  {
    this->Rendered.Render();
    return;
  }
  this->Rest->Stop();
  this->DrawTwice();
}

//------------------------------------------------------------------------------
bool Viewer::DeferRest()
{
  if (!this->Live || this->Done || !this->Quality->IsSlow())
  {
    return false;
  }
  this->Rest->Start();
  return true;
}

//------------------------------------------------------------------------------
void Viewer::DrawAtRest()
{
  try
  {
    this->Rendered.Render();
  }
  catch (const UserError& error) // not through VTK's event loop
  {
    this->Fail(error.what());
  }
}

//------------------------------------------------------------------------------
void Viewer::EndFrame()
{
  this->Rendered.Window->WaitForCompletion();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - this->FrameStart;
  if (this->Refinement->DrawsScene(this->Quality->IsMoving()))
  {
    this->Quality->EndFrame(time.count());
  }
  if (this->Quality->HasShadows())
  {
    this->Controls->NoteTechnique();
  }
}

//------------------------------------------------------------------------------
void Viewer::Quit()
{
  this->Done = true;
  this->Interactor->TerminateApp();
}

//------------------------------------------------------------------------------
void Viewer::Fail(const std::string& error)
{
  this->Error = error;
  this->Quit();
}

//------------------------------------------------------------------------------
void Viewer::StartFrame()
{
  this->FrameStart = std::chrono::steady_clock::now();
  this->Quality->BeginFrame();
  this->Refinement->BeginPicture();
  this->Shown = this->GetState();
  this->Text->SetText(this->Shown + this->Refinement->GetText());
  const bool visible = this->Text->GetVisible();
  this->Sliders->SetVisible(visible && this->ShowsSliders);
  this->Sliders->Update();
  this->Markers->SetVisible(visible);
  this->Markers->SetBottom(this->Sliders->GetHeight());
  this->Markers->Update(this->Controls->GetLampNumber());
  this->Text->SetHelpBottom(this->Sliders->GetHeight());
}

//------------------------------------------------------------------------------
// Annotations are drawn after it.
void Viewer::NoteFrame()
{
  this->Refinement->NoteFrame();
  this->Text->SetText(this->Shown + this->Refinement->GetText());
}

//------------------------------------------------------------------------------
std::string Viewer::GetState() const
{
  std::ostringstream text;
  text << this->Controls->GetState() << "\nframe " << std::fixed << std::setprecision(1)
       << 1000.0 * this->Quality->GetFrameTime() << " ms";
  const std::string reduced = this->Quality->GetText();
  if (!reduced.empty())
  {
    text << ", " << reduced;
  }
  return text.str();
}

}
