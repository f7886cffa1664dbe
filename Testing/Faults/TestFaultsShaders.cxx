// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass where one of its shaders does not compile: its own, and what it adds to those of
// VTK's mappers, which would not survive that.

#include "FaultTrial.h"

#include "vtkAirlightPolyDataMapper.h"
#include "vtkLODProp3D.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOutputWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

using namespace airlight_test;

namespace
{
// A context without shaders.
void Restart(Scene& scene)
{
  scene.Window->Finalize();
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->Initialize();
}

// `word` is in one shader only.
void TryShader(Trial& trial, const std::string& what, const std::string& word)
{
  Restart(trial.Stage);
  RefuseShaders(word);
  trial.CheckPlain(what, 1, what);
  Check(RefuseShaders(word) > 0, what + ": a shader was refused");
  trial.CheckPlain(what + ", second frame", 0, "");
  // The third attempt is not made at once.
  trial.CheckPlain(what + ", third frame", 0, "");
  Check(RefuseShaders(word) == 1, what + ": tried again once in two frames");
  trial.CheckPlain(what + ", fourth frame", 0, "");
  trial.CheckPlain(what + ", fifth frame", 0, "");
  RefuseShaders("");
  trial.Stage.Window->Render();
  trial.Stage.Window->Render();
  trial.CheckGood(what + ", fixed");
}

//------------------------------------------------------------------------------
void TestOnce()
{
  WindowScene scene(48, 36, 1);
  scene.Pass->RecordBuffersOff();
  Trial trial(scene);
  TryShader(trial, "the shader of a vtkOpenGLPolyDataMapper", "airlightFragmentDistance()");
  TryShader(trial, "the shader of shadow planes", "addBoundary");
  TryShader(trial, "the composite shader", "uniform sampler2D sceneDepth");
}

// Sheets one behind the other: more boundaries than a pixel has slots.
void TestLists()
{
  WindowScene scene(48, 36, 2);
  vtkNew<vtkCubeSource> sheet;
  sheet->SetBounds(-0.5, 0.5, -0.5, 0.5, 0.0, 0.01);
  for (int i = 0; i < 30; ++i)
  {
    scene.Add(sheet, [i](vtkActor* actor) { actor->SetPosition(0.0, 1.8, 0.15 * i - 3.0); });
  }
  Trial trial(scene);
  TryShader(trial, "the shader of long lists", "uint sortRun(");
  TryShader(
    trial, "the airlight shader", "airlightEquiangularPixel(p, airlightRayUnit(p), texelFetch");
}

// What shaders that the pass does not add to have drawn has its distance from the depth buffer.
void TestOthers()
{
  WindowScene scene(48, 36, 2);
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkLODProp3D> levels;
  levels->AddLOD(mapper, 0.0);
  scene.Renderer->AddViewProp(levels);
  Trial trial(scene);
  TryShader(trial, "the shader of distances", "uniform sampler2D drawn");
}

// The mappers' own programs draw distances, too.
void TestDistances()
{
  WindowScene scene(48, 36, 2);
  Trial trial(scene);
  Restart(scene);
  const std::string word = "#define AIRLIGHT_DEPTH_PRE_PASS";
  RefuseShaders(word);
  scene.Window->Render();
  trial.CheckGood("no programs for distances alone");
  Check(RefuseShaders("") > 0, "programs for distances were refused");
  trial.CheckGood("no programs for distances alone, second frame");
  Restart(scene);
  scene.Window->Render();
  trial.CheckGood("programs for distances again");
}

// They make the records of translucent fragments, too.
void TestRecords()
{
  WindowScene scene(48, 36, 1);
  scene.Cube->GetProperty()->SetOpacity(0.5);
  scene.Window->Render();
  Restart(scene); // see TestLayers()
  Trial trial(scene);
  Restart(scene);
  RefuseShaders("#define AIRLIGHT_COLLECT_PASS");
  scene.Window->Render();
  trial.CheckGood("no programs for records alone");
  Check(RefuseShaders("") > 0, "programs for records were refused");
}

// VTK alone blends translucent surfaces otherwise in a window's second context than in its first,
// by 1/255. So the trial begins with a second one.
void TestLayers()
{
  WindowScene scene(48, 36, 1);
  scene.Cube->GetProperty()->SetOpacity(0.5);
  scene.Renderer->SetPass(nullptr);
  const Picture first = Capture(scene.Window);
  Restart(scene);
  std::cout << "VTK alone, second context: off by " << Compare(first, Capture(scene.Window))
            << "/255\n";
  scene.Renderer->SetPass(scene.Pass);
  Trial trial(scene);
  TryShader(trial, "the shader of the last step", "uniform sampler2D radiances");
}

void TestMap()
{
  WindowScene scene(48, 36, 1);
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.Pass->SetShadowMapResolution(64);
  Trial trial(scene);
  TryShader(trial, "the shadow map's shader", "flat in float triangleLimit");
}
}

//------------------------------------------------------------------------------
// The mapper with a medium of its own, without a pass.
namespace
{
void TestMapper()
{
  Scene scene(48, 36);
  scene.Renderer->SetPass(nullptr);
  scene.AddPointLight({ 3, 4, 2 });
  vtkNew<vtkAirlightPolyDataMapper> mapper;
  mapper->SetInputData(MakeSphere(2.0));
  scene.Renderer->AddActor(Scene::MakeActor(mapper));
  const Picture plain = Capture(scene.Window);
  mapper->SetMedium(scene.Medium);
  const Picture good = Capture(scene.Window);
  Check(ShowsScene(plain) && Compare(plain, good) > 10, "the medium is seen");
  airlight_test::ErrorListener errors(mapper);
  for (int evaluation : { vtkAirlightPolyDataMapper::FRAGMENT, vtkAirlightPolyDataMapper::VERTEX })
  {
    const std::string what = "mapper, evaluation " + std::to_string(evaluation);
    mapper->SetEvaluation(evaluation);
    Restart(scene);
    RefuseShaders("airlightTail");
    Check(Compare(plain, Capture(scene.Window)) == 0, what + ": without the medium");
    Check(errors.Take() == 1, what + ": one error");
    Check(errors.GetText().find("without the medium: its shader did not") != std::string::npos,
      what + ": names the cause, not: " + errors.GetText());
    Check(Compare(plain, Capture(scene.Window)) == 0, what + ": again without the medium");
    Check(errors.Take() == 0, what + ": no second error");
    Check(RefuseShaders("") > 0, what + ": shaders were refused");
    for (int frame = 0; frame < 4; ++frame)
    {
      scene.Window->Render();
    }
    const int steps = Compare(good, Capture(scene.Window));
    Check(evaluation == vtkAirlightPolyDataMapper::FRAGMENT
        ? steps == 0
        : Compare(plain, Capture(scene.Window)) > 10,
      what + ": the medium is there again");
    Check(errors.Take() == 0, what + ": no error then");
  }
}
}

//------------------------------------------------------------------------------
int TestFaultsShaders(int, char*[])
{
  vtkNew<SilentOutput> output;
  vtkOutputWindow::SetInstance(output);
  TestOnce();
  TestLists();
  TestOthers();
  TestDistances();
  TestRecords();
  TestLayers();
  TestMap();
  TestMapper();
  vtkOutputWindow::SetInstance(nullptr);
  std::cout << output->Count << " messages of VTK, " << output->Texts.size() << " characters\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
