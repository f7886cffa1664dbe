// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass on an OpenGL 3.2, which CMakeLists.txt asks Mesa for: it is the oldest that VTK
// draws with, and too old for the pass.

#include "FaultTrial.h"

#include "vtkOpenGLRenderWindow.h"

using namespace airlight_test;

//------------------------------------------------------------------------------
int TestFaultsOldOpenGL(int, char*[])
{
  vtkNew<SilentOutput> output;
  vtkOutputWindow::SetInstance(output);
  WindowScene scene(80, 60, 2);
  scene.Renderer->SetPass(nullptr);
  const Picture plain = Capture(scene.Window);
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetOpenGLVersion(major, minor);
  Check(major == 3 && minor == 2, "the test runs on OpenGL 3.2");
  Check(ShowsScene(plain), "something is seen");
  airlight_test::ErrorListener errors(scene.Pass);
  scene.Renderer->SetPass(scene.Pass);
  for (int technique = vtkAirlightPass::NONE; technique <= vtkAirlightPass::RAY_MARCH; ++technique)
  {
    scene.Pass->SetShadowTechnique(technique);
    Check(Compare(plain, Capture(scene.Window)) == 0,
      "technique " + std::to_string(technique) + ": the scene without the medium");
  }
  Check(errors.Take() == 1, "one error");
  Check(errors.GetText().find("drawn without the medium: the pass needs OpenGL 3.3 and this window "
                              "has 3.2: update") != std::string::npos,
    "it names cause and remedy, not: " + errors.GetText());
  vtkOutputWindow::SetInstance(nullptr);
  Check(output->Count == 0, "VTK says nothing:\n" + output->Texts.substr(0, 500));
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
