// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of translucent casters requested in vain: bad keys, and techniques that have none.

#include "AirlightTestBodies.h"
#include "AirlightTestErrors.h"

#include "vtkInformation.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
bool Names(const ErrorListener& listener, const std::string& part)
{
  return listener.GetText().find(part) != std::string::npos;
}

void SetKey(vtkProp* prop, const std::vector<double>& values)
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::SHADOW_OPACITY(), values.data(), static_cast<int>(values.size()));
  prop->SetPropertyKeys(keys);
}

void TestKeys(Scene& scene, vtkActor* pane)
{
  pane->SetPropertyKeys(nullptr);
  const Buffers plain = scene.Render();
  ErrorListener errors(scene.Pass);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<double>> bad = { { 0.5, 1.5, 0.2 }, { 0.5, 0.2, -0.25 },
    { 0.5, nan, 0.5 }, { 0.5, 0.5 }, { 0.5, 0.5, 0.5, 0.5 } };
  const char* named[] = { "(0.5, 1.5, 0.2)", "-0.25", "nan", "(0.5, 0.5)", "0.5, 0.5, 0.5, 0.5" };
  for (size_t i = 0; i < bad.size(); ++i)
  {
    SetKey(pane, bad[i]);
    const Buffers buffers = scene.Render();
    scene.Window->Render();
    Check(errors.Take() == 1, "one error for a bad key");
    Check(
      Names(errors, named[i]) && Names(errors, "vtkOpenGLActor") && Names(errors, "from 0 to 1"),
      "the error names value, prop and remedy: " + errors.GetText());
    CheckSame(plain, buffers, "a bad key is as none");
  }
  SetShadowOpacity(pane, glm::dvec3(0.3));
  scene.Render();
  Check(errors.Take() == 0, "no error for a good key");
  SetKey(pane, bad[0]);
  scene.Render();
  Check(errors.Take() == 1, "a bad key is reported again");
}

void TestMaps(Scene& scene, vtkActor* pane)
{
  SetShadowOpacity(pane, glm::dvec3(0.3, 0.4, 0.5));
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.Pass->TranslucentShadowsOff();
  scene.Pass->SetShadowTechniqueToShadowMap();
  const Buffers off = scene.Render();
  Check(warnings.Take() == 0, "no warning if none are requested");
  scene.Pass->TranslucentShadowsOn();
  CheckSame(off, scene.Render(), "shadow maps leave translucent casters out");
  Check(warnings.Take() == 1 && Names(warnings, "SetShadowTechniqueToShadowPlanes"),
    "one warning: " + warnings.GetText());
  scene.Pass->SetShadowTechniqueToRayMarch();
  scene.Render();
  Check(warnings.Take() == 0, "no second warning");
  // What blocks all light casts in maps, too.
  scene.Pass->SetShadowTechniqueToShadowMap();
  SetShadowOpacity(pane, glm::dvec3(1.0));
  Check(!AreSame(off.at("Airlight"), scene.Render().at("Airlight")), "opaque shadows in maps");
}
}

//------------------------------------------------------------------------------
int TestTranslucentShadowErrors(int, char*[])
{
  Scene scene(80, 60);
  AddFloorAndBall(scene);
  scene.AddPointLight({ 1, 4.5, 1 });
  vtkActor* pane =
    AddGlass(scene, MakeSheet({ -2.5, 1.5, -1 }, { 3, 0, 0 }, { 0, 0, 3 }), glm::dvec3(0.5));
  TestKeys(scene, pane);
  TestMaps(scene, pane);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
