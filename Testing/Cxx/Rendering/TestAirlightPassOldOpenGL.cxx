// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass where OpenGL is older than 4.3 (CMakeLists.txt asks Mesa for 3.3): shadows from
// shadow maps, against brute force, and one message that says so.

#include "AirlightTestCompareScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
struct Messages
{
  int Errors = 0;
  int Warnings = 0;
};

// Draws two frames with a technique.
Buffers Draw(int technique, Messages& messages)
{
  Scene scene;
  vtkNew<vtkSphereSource> sphere;
  scene.Add(sphere, [](vtkActor* actor) { actor->SetScale(3.0); });
  scene.AddPointLight({ 3, 4, 1 });
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&messages);
  count->SetCallback([](vtkObject*, unsigned long event, void* data, void*) {
    auto* m = static_cast<Messages*>(data);
    ++(event == vtkCommand::ErrorEvent ? m->Errors : m->Warnings);
  });
  scene.Pass->AddObserver(vtkCommand::ErrorEvent, count);
  scene.Pass->AddObserver(vtkCommand::WarningEvent, count);
  scene.Pass->SetShadowTechnique(technique);
  scene.Window->Render();
  int major = 0;
  int minor = 0;
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetOpenGLVersion(major, minor);
  Check(10 * major + minor < 43, "the test runs on an old OpenGL");
  const Buffers buffers = scene.Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() ==
      (technique == vtkAirlightPass::RAY_MARCH ? technique : vtkAirlightPass::SHADOW_MAP),
    "a technique of old OpenGL is in effect");
  CheckFinite(buffers, "old OpenGL");
  Limits limits;
  limits.Technique = scene.Pass->GetEffectiveShadowTechnique();
  limits.Median = 5e-3;
  limits.P99 = 5e-2;
  limits.Wrong = 1.0; // the percentiles say it
  limits.EdgePixels = 0.7;
  CompareScene("old OpenGL, technique " + std::to_string(technique), scene, 1000, limits);
  Check(GetValue(scene.GetBuffer("Airlight"), 10, 10) > 0.0, "there is airlight");
  return buffers;
}
}

//------------------------------------------------------------------------------
int TestAirlightPassOldOpenGL(int, char*[])
{
  Messages map;
  Messages march;
  Messages automatic;
  Messages planes;
  const Buffers expected = Draw(vtkAirlightPass::SHADOW_MAP, map);
  Check(map.Errors == 0 && map.Warnings == 0, "SHADOW_MAP says nothing");
  Draw(vtkAirlightPass::RAY_MARCH, march);
  Check(march.Errors == 0 && march.Warnings == 0, "RAY_MARCH says nothing");
  CheckSame(expected, Draw(vtkAirlightPass::AUTOMATIC, automatic), "AUTOMATIC");
  Check(automatic.Errors == 0 && automatic.Warnings == 1, "AUTOMATIC gives one warning");
  CheckSame(expected, Draw(vtkAirlightPass::SHADOW_PLANES, planes), "SHADOW_PLANES");
  Check(planes.Errors == 1 && planes.Warnings == 0, "SHADOW_PLANES gives one error");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
