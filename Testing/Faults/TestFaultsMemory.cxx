// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass where OpenGL refuses memory for buffers and textures, and framebuffers: every
// single one that a frame of a new pass asks for.

#include "FaultTrial.h"

#include "AirlightTestBodies.h"

using namespace airlight_test;

namespace
{
// What a frame does that was refused something: it is lost, or does with less memory.
struct Outcomes
{
  int Lost = 0;
  int Good = 0;
};

// Twice, as the second frame must not repeat the error; then good again.
void TryOne(Trial& trial, Refusal what, int number, const std::string& name, Outcomes& outcomes)
{
  const std::string which = name + ", refused number " + std::to_string(number);
  trial.Forget();
  Refuse(what, number);
  const Picture picture = Capture(trial.Stage.Window);
  const int said = trial.Errors.Take();
  const bool lost = Compare(picture, trial.Plain) == 0;
  Check(lost || Compare(picture, trial.Good) == 0,
    which + ": one of the two pictures, off by " + std::to_string(Compare(picture, trial.Plain)) +
      " in " + std::to_string(CountDifferent(picture, trial.Plain, 0)) + " pixels");
  Check(said == (lost ? 1 : 0), which + ": " + std::to_string(said) + " errors");
  trial.CheckWords(which, said, "graphics card");
  Check(!lost || !trial.Stage.GetBuffer("Radiance"), which + ": no buffers of a lost frame");
  ++(lost ? outcomes.Lost : outcomes.Good);
  if (lost)
  {
    Refuse(what, number);
    trial.CheckPlain(which + " again", 0, "");
  }
  Refuse(Refusal::None, 0);
  trial.CheckGood(which + ", after it");
}

void TryAll(Trial& trial, Refusal what, const std::string& name, int least)
{
  trial.Forget();
  Refuse(what, 0);
  trial.Stage.Window->Render();
  const int count = CountCalls();
  Refuse(Refusal::None, 0);
  Outcomes outcomes;
  for (int number = 1; number <= count; ++number)
  {
    TryOne(trial, what, number, name, outcomes);
  }
  std::cout << name << ": " << count << " refused one by one, " << outcomes.Lost
            << " frames without the medium, " << outcomes.Good << " with it\n";
  Check(outcomes.Lost >= least, name + ": frames are lost");
}

void TryScene(Scene& scene, const std::string& name, int buffers)
{
  Trial trial(scene);
  TryAll(trial, Refusal::Buffers, name + ", buffers", buffers);
  TryAll(trial, Refusal::Textures, name + ", textures", 4);
  TryAll(trial, Refusal::Framebuffers, name + ", framebuffers", 3);
}

//------------------------------------------------------------------------------
// Lists of boundaries beyond what a pixel's slots hold: most fit into them.
void TestPlanes()
{
  WindowScene scene(48, 36, 1);
  scene.Pass->RecordBuffersOff();
  TryScene(scene, "planes", 5);
}

// With records of translucent fragments, dimmed light, a texture of the medium's surface.
void TestLayers()
{
  WindowScene scene(48, 36, 2);
  AddGlass(scene, MakeSheet({ 0, -1.5, 1 }, { 2, 0, 0 }, { 0, 2, 0 }), glm::dvec3(0.5));
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-7, 7, -3, 5, -7, 7);
  scene.Medium->SetRegionToSurface();
  scene.Medium->SetSurface(Make(box));
  TryScene(scene, "layers", 10);
}

void TestMaps()
{
  WindowScene scene(48, 36, 2);
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.Pass->SetShadowMapResolution(64);
  TryScene(scene, "maps", 2);
}
}

//------------------------------------------------------------------------------
int TestFaultsMemory(int, char*[])
{
  TestPlanes();
  TestLayers();
  TestMaps();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
