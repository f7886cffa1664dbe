// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass where one of its shaders does not compile: its own, and what it adds to those of VTK's
// mappers, which would not survive that.

#include "FaultTrial.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOutputWindow.h"

using namespace airlighttest;

namespace
{
// A context without shaders.
void Restart(Scene& scene)
{
  scene.Window->Finalize();
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->Initialize();
  InstallFaults();
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
  trial.CheckGood(what + ", mended");
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
  TryShader(trial, "the airlight shader", "airlightTurnPixel(p, airlightRayUnit(p), texelFetch");
  TryShader(trial, "the shader of distances", "uniform sampler2D drawn");
}

// VTK alone blends translucent surfaces otherwise in a window's second context than in its first, by
// 1/255. So the trial begins with a second one.
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
int TestFaultsShaders(int, char*[])
{
  vtkNew<SilentOutput> output;
  vtkOutputWindow::SetInstance(output);
  TestOnce();
  TestLists();
  TestLayers();
  TestMap();
  vtkOutputWindow::SetInstance(nullptr);
  std::cout << output->Count << " messages of VTK, " << output->Texts.size() << " characters\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
