// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene whose pictures with and without the medium are known, and what has to become of it when
 * OpenGL refuses something: the scene without the medium and one error, and with the next good
 * frame the same picture as before, to the last bit.
 */

#ifndef FaultTrial_h
#define FaultTrial_h

#include "FaultyOpenGL.h"

#include "AirlightTestErrors.h"
#include "AirlightTestWindowScene.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

namespace airlight_test
{
// VTK's own messages about shaders are long, and they are expected.
class SilentOutput : public vtkOutputWindow
{
public:
  static SilentOutput* New() { VTK_STANDARD_NEW_BODY(SilentOutput); }
  vtkTypeMacro(SilentOutput, vtkOutputWindow);
  void DisplayText(const char* text) override
  {
    this->Texts += text ? text : "";
    ++this->Count;
  }

  std::string Texts;
  int Count = 0;
};

struct Trial
{
  explicit Trial(Scene& scene)
    : Stage(scene)
    , Errors(scene.Pass)
    , Warnings(scene.Pass, vtkCommand::WarningEvent)
  {
    scene.Renderer->SetPass(nullptr);
    this->Plain = Capture(scene.Window);
    scene.Renderer->SetPass(scene.Pass);
    this->Good = Capture(scene.Window);
    if (scene.Pass->GetRecordBuffers())
    {
      this->GoodBuffers = scene.CopyBuffers();
    }
    Check(ShowsScene(this->Plain), "something is seen");
    Check(Compare(this->Plain, this->Good) > 20, "the medium is seen");
    Check(this->Errors.Take() == 0 && this->Warnings.Take() == 0, "a good frame says nothing");
  }

  // The frame now: whether it is the scene without the medium, and said so once if it was to.
  void CheckPlain(const std::string& what, int errors, const std::string& words)
  {
    const int steps = Compare(this->Plain, Capture(this->Stage.Window));
    Check(steps == 0, what + ": the scene without the medium, not " + std::to_string(steps));
    const int said = this->Errors.Take();
    Check(said == errors,
      what + ": " + std::to_string(errors) + " errors, not " + std::to_string(said));
    this->CheckWords(what, said, words);
    Check(
      this->Stage.GetBuffer("Radiance") == nullptr, what + ": no buffers of a frame that is none");
  }

  void CheckGood(const std::string& what)
  {
    const int steps = Compare(this->Good, Capture(this->Stage.Window));
    Check(steps == 0, what + ": the picture as before, not off by " + std::to_string(steps));
    Check(this->Errors.Take() == 0 && this->Warnings.Take() == 0, what + ": says nothing");
    if (this->Stage.Pass->GetRecordBuffers())
    {
      CheckSame(this->GoodBuffers, this->Stage.CopyBuffers(), what);
    }
  }

  // The error has the consequence, the cause and, after a colon or semicolon, the remedy.
  void CheckWords(const std::string& what, int said, const std::string& words)
  {
    const std::string& text = this->Errors.GetText();
    Check(said == 0 ||
        (text.find("drawn without the medium: ") != std::string::npos &&
          text.find(words) != std::string::npos),
      what + ": the error names the cause, not: " + text);
  }

  // All objects of the pass are made again.
  void Forget() { this->Stage.Pass->ReleaseGraphicsResources(this->Stage.Window); }

  Scene& Stage;
  airlight_test::ErrorListener Errors;
  airlight_test::ErrorListener Warnings;
  Picture Plain;
  Picture Good;
  Buffers GoodBuffers;
};
}

#endif
