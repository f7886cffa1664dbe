// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass given bad input: one error or warning each, never the loss of the scene, and
// buffers that are finite all over.

#include "AirlightTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A sphere before a white background, and what the pass has to say of it.
struct Stage : Scene
{
  Stage()
    : Scene(80, 60)
  {
    vtkNew<vtkSphereSource> sphere;
    this->Body = this->Add(sphere, [](vtkActor* actor) { actor->SetScale(3.0); });
    this->Listen(vtkCommand::ErrorEvent, &this->Errors);
    this->Listen(vtkCommand::WarningEvent, &this->Warnings);
  }

  void Listen(unsigned long event, int* counter)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(counter);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
    this->Pass->AddObserver(event, command);
  }

  int Errors = 0;
  int Warnings = 0;
  vtkActor* Body;
};

// Two frames: nothing may be said twice.
void CheckStage(const std::string& name, int errors, int warnings,
  const std::function<void(Stage&)>& spoil, bool bodyIsDrawn = true)
{
  Stage stage;
  stage.AddPointLight({ 3, 4, 6 });
  spoil(stage);
  stage.Window->Render();
  stage.Window->Render();
  std::cout << name << ": " << stage.Errors << " errors, " << stage.Warnings << " warnings\n";
  Check(stage.Errors == errors, name + ": " + std::to_string(errors) + " errors expected");
  Check(stage.Warnings == warnings, name + ": " + std::to_string(warnings) + " warnings expected");
  if (stage.GetBuffer("Radiance"))
  {
    CheckFinite(stage.CopyBuffers(), name);
  }
  if (bodyIsDrawn)
  {
    Check(GetValue(stage.GetBuffer("Depth"), 40, 25) > 0.0, name + ": the body is drawn");
  }
}

//------------------------------------------------------------------------------
void TestScenes()
{
  CheckStage("good scene", 0, 0, [](Stage&) {});
  CheckStage(
    "empty scene", 0, 0, [](Stage& s) { s.Renderer->RemoveAllViewProps(); }, false);
  CheckStage("no light", 0, 0, [](Stage& s) { s.Renderer->RemoveAllLights(); });
  CheckStage("more media than are drawn", 1, 0, [](Stage& s) {
    for (int i = 0; i < 9; ++i)
    {
      vtkNew<vtkParticipatingMedium> medium;
      s.Pass->AddMedium(medium);
    }
  });
  CheckStage(
    "flat actor", 0, 0, [](Stage& s) { s.Body->SetScale(1, 0, 1); }, false);
  CheckStage("actor whose matrix is undefined", 0, 0, [](Stage& s) {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->SetElement(0, 0, nan);
    vtkNew<vtkSphereSource> sphere;
    s.Add(sphere)->SetUserMatrix(matrix);
  });
  const auto addStrips = [](Stage& s) {
    std::vector<Triangle> strips;
    for (int i = 0; i < 1500; ++i)
    {
      const double z = 5.0 - 0.03 * i;
      strips.push_back({ { 20, -60, z }, { 20, 60, z }, { 20, 0, z - 0.01 } });
    }
    s.Add(MakeSoup(strips));
    s.Pass->SetMemoryLimit(1);
    s.AddPointLight({ 40, 0, -10 });
  };
  CheckStage(
    "more boundaries in a row than the memory limit holds", 1, 0,
    [&](Stage& s) {
      addStrips(s);
      s.Pass->SetShadowTechniqueToShadowPlanes();
    },
    false);
  CheckStage("the same, automatic", 0, 1, addStrips);
}

//------------------------------------------------------------------------------
void TestLights()
{
  CheckStage("spot light without direction", 0, 1, [](Stage& s) {
    s.Lights[0]->SetConeAngle(30.0);
    s.Lights[0]->SetFocalPoint(s.Lights[0]->GetPosition());
  });
  CheckStage("light at an undefined place", 0, 1, [](Stage& s) { s.AddPointLight({ nan, 0, 0 }); });
  CheckStage("light of undefined intensity", 0, 1, [](Stage& s) {
    s.AddPointLight({ 0, 3, 0 })->SetIntensity(nan);
  });
  CheckStage(
    "attenuation (0, 0, 0)", 0, 1, [](Stage& s) { s.Lights[0]->SetAttenuationValues(0, 0, 0); });
  CheckStage("directional light without direction", 0, 1, [](Stage& s) {
    s.Lights[0]->PositionalOff();
    s.Lights[0]->SetFocalPoint(s.Lights[0]->GetPosition());
  });
  CheckStage("light in the middle of a surface", 0, 0,
    [](Stage& s) { s.Lights[0]->SetPosition(0, 1.5, 0); });
  CheckStage("light at the camera", 0, 0, [](Stage& s) { s.Lights[0]->SetPosition(0, 1, 10); });
}

//------------------------------------------------------------------------------
void TestCameras()
{
  Stage stage;
  stage.AddPointLight({ 3, 4, 6 });
  stage.Renderer->GetActiveCamera()->SetFocalPoint(0, 1, 10);
  stage.Window->Render();
  stage.Window->Render();
  std::cout << "camera without direction: " << stage.Errors << " errors\n";
  Check(stage.Errors <= 1, "camera without direction: at most one error");
  stage.Look({ 0, 1, 10 }, { 0, 0, 0 });
  CheckFinite(stage.Render(), "after the camera is set right");
  Check(GetValue(stage.GetBuffer("Depth"), 40, 25) > 0.0, "the body is drawn again");

  Stage empty;
  empty.AddPointLight({ 3, 4, 6 });
  empty.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
  empty.Window->Render();
  empty.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  empty.Window->Render();
  Check(empty.Errors == 0, "empty viewport: no error");
  CheckFinite(empty.CopyBuffers(), "after an empty viewport");
}

//------------------------------------------------------------------------------
void TestValues()
{
  Stage stage;
  vtkAirlightPass* pass = stage.Pass;
  const vtkMTimeType time = pass->GetMTime();
  pass->SetShadowTechnique(7);
  Check(stage.Errors == 1, "SetShadowTechnique(7) is an error");
  pass->SetShadowTechnique(-1);
  Check(stage.Errors == 2, "SetShadowTechnique(-1) is an error");
  Check(pass->GetShadowTechnique() == vtkAirlightPass::AUTOMATIC, "the technique stays");
  pass->SetDebugView(vtkAirlightPass::OUTLINES + 1);
  Check(stage.Errors == 3, "SetDebugView(4) is an error");
  for (const double radius : { -1.0, nan, Infinity })
  {
    pass->SetLightRadius(radius);
  }
  Check(stage.Errors == 6, "bad radii are errors");
  Check(pass->GetLightRadius() == 0.0, "the radius stays");
  Check(pass->GetMedium(3) == nullptr && stage.Errors == 7, "GetMedium(3) is an error");
  Check(pass->GetMTime() == time, "nothing is modified");
  pass->SetMemoryLimit(-5);
  Check(pass->GetMemoryLimit() == 1, "the memory limit is clamped");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassErrors(int, char*[])
{
  TestScenes();
  TestLights();
  TestCameras();
  TestValues();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
