// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Properties of the public classes come back as they were set, and questions that have no answer
// are errors.

#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"

#include "vtkAirlightComparison.h"
#include "vtkAirlightProbeFilter.h"
#include "vtkAirlightReference.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowPlanesFilter.h"
#include "vtkSphereSource.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Both values, and the time that says so.
template <typename Object>
void CheckSwitch(Object* object, const char* name, void (Object::*set)(bool), bool (Object::*get)())
{
  for (const bool value : { true, false, true })
  {
    const vtkMTimeType before = object->GetMTime();
    const bool old = (object->*get)();
    (object->*set)(value);
    Check((object->*get)() == value, std::string(name) + " comes back");
    Check(old == value || object->GetMTime() > before, std::string(name) + " modifies");
  }
}

void CheckSwitches()
{
  vtkNew<vtkAirlightPass> pass;
  using Pass = vtkAirlightPass;
  CheckSwitch<Pass>(pass, "VolumeShadows", &Pass::SetVolumeShadows, &Pass::GetVolumeShadows);
  CheckSwitch<Pass>(pass, "SurfaceShadows", &Pass::SetSurfaceShadows, &Pass::GetSurfaceShadows);
  CheckSwitch<Pass>(
    pass, "TranslucentShadows", &Pass::SetTranslucentShadows, &Pass::GetTranslucentShadows);
  CheckSwitch<Pass>(pass, "ScatteredSurfaceLight", &Pass::SetScatteredSurfaceLight,
    &Pass::GetScatteredSurfaceLight);
  CheckSwitch<Pass>(pass, "LinearInput", &Pass::SetLinearInput, &Pass::GetLinearInput);
  CheckSwitch<Pass>(pass, "EncodedOutput", &Pass::SetEncodedOutput, &Pass::GetEncodedOutput);
  CheckSwitch<Pass>(
    pass, "AutomaticExposure", &Pass::SetAutomaticExposure, &Pass::GetAutomaticExposure);
  CheckSwitch<Pass>(pass, "Dithering", &Pass::SetDithering, &Pass::GetDithering);
  CheckSwitch<Pass>(pass, "Annotations", &Pass::SetAnnotations, &Pass::GetAnnotations);
  CheckSwitch<Pass>(pass, "RecordBuffers", &Pass::SetRecordBuffers, &Pass::GetRecordBuffers);
  vtkNew<vtkAirlightComparison> comparison;
  CheckSwitch<vtkAirlightComparison>(comparison, "SkipNonFinite",
    &vtkAirlightComparison::SetSkipNonFinite, &vtkAirlightComparison::GetSkipNonFinite);
  vtkNew<vtkAirlightReference> reference;
  CheckSwitch<vtkAirlightReference>(reference, "VolumeShadows",
    &vtkAirlightReference::SetVolumeShadows, &vtkAirlightReference::GetVolumeShadows);
  CheckSwitch<vtkAirlightReference>(reference, "SurfaceShadows",
    &vtkAirlightReference::SetSurfaceShadows, &vtkAirlightReference::GetSurfaceShadows);
  vtkNew<vtkShadowPlanesFilter> planes;
  using Planes = vtkShadowPlanesFilter;
  CheckSwitch<Planes>(planes, "LightCap", &Planes::SetLightCap, &Planes::GetLightCap);
  CheckSwitch<Planes>(planes, "FarCap", &Planes::SetFarCap, &Planes::GetFarCap);
}

void CheckNumbers()
{
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetShadowTolerance(0.25);
  Check(probe->GetShadowTolerance() == 0.25, "ShadowTolerance comes back");
  probe->SetShadowTolerance(7.0);
  Check(probe->GetShadowTolerance() == 1.0, "ShadowTolerance is at most 1");
  probe->SetViewpoint(1.0, 2.0, 3.0);
  Check(probe->GetViewpoint()[2] == 3.0, "Viewpoint comes back");
  probe->ScatteredIrradianceOn();
  Check(probe->GetScatteredIrradiance(), "ScatteredIrradiance comes back");
  vtkNew<vtkAirlightReference> reference;
  reference->SetLightRadius(0.5);
  Check(reference->GetLightRadius() == 0.5, "LightRadius comes back");
  vtkNew<vtkShadowPlanesFilter> planes;
  planes->SetExtent(vtkShadowPlanesFilter::BOUNDS + 5);
  Check(planes->GetExtent() == vtkShadowPlanesFilter::BOUNDS, "Extent is one that there is");
}

//------------------------------------------------------------------------------
// What is out of range becomes the next number that is in it.
void CheckFrames()
{
  vtkNew<vtkAirlightPass> pass;
  for (const int frames : { 0, -3, std::numeric_limits<int>::min() })
  {
    pass->SetSubpixelFrames(frames);
    Check(pass->GetSubpixelFrames() == 1, "SubpixelFrames is at least 1");
  }
  for (const int frames : { 1025, std::numeric_limits<int>::max() })
  {
    pass->SetSubpixelFrames(frames);
    Check(pass->GetSubpixelFrames() == 1024, "SubpixelFrames is at most 1024");
  }
}

//------------------------------------------------------------------------------
void CheckPhase()
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  double pole[4] = { 1.0, 1.0, 1.0, 1.0 };
  medium->GetPhasePole(99, pole);
  Check(errors.Take() == 1 && errors.GetText().find("99") != std::string::npos, "a pole too many");
  Check(medium->EvaluatePhaseFunction(nan) == 0.0 && errors.Take() == 1, "no angle");
}

void CheckSilhouettes(Scene& scene)
{
  ErrorListener errors(scene.Pass);
  vtkNew<vtkUnsignedCharArray> bytes;
  Check(scene.Pass->GetSilhouettes(scene.Renderer, bytes) && bytes->GetNumberOfValues() > 0,
    "silhouettes");
  double place[3];
  scene.Renderer->GetActiveCamera()->GetPosition(place);
  scene.Renderer->GetActiveCamera()->SetPosition(nan, 0.0, 0.0);
  Check(!scene.Pass->GetSilhouettes(scene.Renderer, bytes), "no silhouettes from nowhere");
  Check(errors.Take() == 1 && errors.GetText().find("camera") != std::string::npos,
    "and an error that names the camera");
  scene.Renderer->GetActiveCamera()->SetPosition(place);
}

// Six maps of 8192 texels a side lie in one texture of 24576 by 16384, which software renderers do
// not take and graphics cards may.
void CheckMaps(Scene& scene)
{
  ErrorListener errors(scene.Pass);
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.Pass->SetShadowMapResolution(8192);
  scene.Window->Render();
  if (vtkTextureObject::GetMaximumTextureSize(vtkOpenGLRenderWindow::SafeDownCast(scene.Window)) >=
    24576)
  {
    Check(errors.Take() == 0 && scene.Pass->GetBuffer("Airlight"), "a map of this card's size");
    return;
  }
  Check(
    errors.Take() == 1 && errors.GetText().find("SetShadowMapResolution()") != std::string::npos,
    "a map that is too large: " + errors.GetText());
  Check(!scene.Pass->GetBuffer("Airlight"), "and no buffers");
  scene.Pass->SetShadowMapResolution(256);
  scene.Window->Render();
  Check(errors.Take() == 0 && scene.Pass->GetBuffer("Airlight"), "a smaller one is drawn");
}
}

//------------------------------------------------------------------------------
int TestPassProperties(int, char*[])
{
  CheckSwitches();
  CheckNumbers();
  CheckFrames();
  CheckPhase();
  Scene scene(32, 24);
  scene.AddPointLight({ 1.0, 3.0, 2.0 });
  vtkNew<vtkSphereSource> sphere;
  scene.Add(sphere);
  scene.Pass->RecordBuffersOn();
  scene.Window->Render();
  CheckSilhouettes(scene);
  CheckMaps(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
