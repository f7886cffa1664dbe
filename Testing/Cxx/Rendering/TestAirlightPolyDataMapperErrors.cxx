// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPolyDataMapper given bad input: one error or warning each, never the loss of the
// surface, and pictures that are finite all over.

#include "AirlightTestErrors.h"
#include "AirlightTestMapper.h"

#include "vtkCommand.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool IsFinite(const FloatPicture& picture)
{
  return std::all_of(picture.begin(), picture.end(), [](float v) { return std::isfinite(v); });
}

// The largest difference of the surface, in the picture's middle, from its own colour.
double GetFog(const MapperScene& scene, const FloatPicture& picture)
{
  double largest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const int middle = (PixelScene::Height / 2) * PixelScene::Width + PixelScene::Width / 2;
    largest = std::max(largest, std::abs(picture[4 * middle + k] - scene.Colour[k]));
  }
  return largest;
}

// Two frames: nothing may be said twice.
void TestSpoilt(const std::string& what, int errors, int warnings, bool fogged,
  const std::function<void(MapperScene&, vtkLight*)>& spoil)
{
  MapperScene scene;
  vtkLight* light = scene.AddPointLight({ 1.0, 0.5, 1.0 }, { 40.0, 30.0, 20.0 });
  scene.Add(MakePlane(1));
  ErrorListener errorListener(scene.Mapper);
  ErrorListener warningListener(scene.Mapper, vtkCommand::WarningEvent);
  spoil(scene, light);
  const FloatPicture picture = scene.Render();
  scene.Render();
  const int gotErrors = errorListener.Take();
  const int gotWarnings = warningListener.Take();
  std::cout << what << ": " << gotErrors << " errors, " << gotWarnings << " warnings "
            << errorListener.GetText() << warningListener.GetText() << "\n";
  Check(gotErrors == errors, what + ": " + std::to_string(errors) + " errors expected");
  Check(gotWarnings == warnings, what + ": " + std::to_string(warnings) + " warnings expected");
  Check(IsFinite(picture), what + ": finite");
  const double fog = GetFog(scene, picture);
  Check(fogged ? fog > 0.01 : fog < 1e-6, what + (fogged ? ": is fogged" : ": is plain"));
}

//------------------------------------------------------------------------------
void TestScenes()
{
  TestSpoilt("good scene", 0, 0, true, [](MapperScene&, vtkLight*) {});
  TestSpoilt(
    "no light", 0, 0, true, [](MapperScene& s, vtkLight*) { s.Renderer->RemoveAllLights(); });
  TestSpoilt(
    "no medium", 0, 0, false, [](MapperScene& s, vtkLight*) { s.Mapper->RemoveAllMedia(); });
  TestSpoilt("nine media", 1, 0, true, [](MapperScene& s, vtkLight*) {
    for (int i = 0; i < 8; ++i)
    {
      vtkNew<vtkParticipatingMedium> medium;
      s.Mapper->AddMedium(medium);
    }
  });
  TestSpoilt("more lights than shaders have room for", 1, 0, false, [](MapperScene& s, vtkLight*) {
    for (int i = 0; i < 1000; ++i)
    {
      s.AddPointLight({ 0.01 * i, 1.0, 2.0 }, glm::dvec3(0.1));
    }
  });
  TestSpoilt("light at an undefined place", 0, 1, true, [](MapperScene& s, vtkLight*) {
    s.AddPointLight({ nan, 0.0, 0.0 }, glm::dvec3(1.0));
  });
  TestSpoilt("light of undefined intensity, lit", 0, 1, true, [](MapperScene& s, vtkLight* light) {
    light->SetIntensity(nan);
    s.Actor->GetProperty()->LightingOn();
  });
  TestSpoilt("attenuation (0, 0, 0)", 0, 1, true,
    [](MapperScene&, vtkLight* light) { light->SetAttenuationValues(0.0, 0.0, 0.0); });
  TestSpoilt("spot without direction", 0, 1, true, [](MapperScene&, vtkLight* light) {
    light->SetConeAngle(30.0);
    light->SetFocalPoint(light->GetPosition());
  });
  TestSpoilt("light at the camera", 0, 0, true,
    [](MapperScene&, vtkLight* light) { light->SetPosition(0.0, 1.0, 10.0); });
  for (const bool vertex : { false, true })
  {
    TestSpoilt("clear channels, dense channels", 0, 0, true, [&](MapperScene& s, vtkLight*) {
      s.Medium->SetScattering(0.0, 0.0, 1e4);
      s.Medium->SetAbsorption(0.0, 1e4, 1e4);
      s.Mapper->SetEvaluation(vertex);
    });
    // Vertices at the eye and behind it.
    TestSpoilt("camera in the surface", 0, 0, true, [&](MapperScene& s, vtkLight*) {
      s.Renderer->GetActiveCamera()->SetPosition(-4.0, -3.0, 0.0);
      s.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -1.3);
      s.Mapper->SetEvaluation(vertex);
    });
  }
}

//------------------------------------------------------------------------------
void TestCamera()
{
  MapperScene scene;
  scene.AddPointLight({ 1.0, 0.5, 1.0 }, { 40.0, 30.0, 20.0 });
  scene.Add(MakePlane(1));
  ErrorListener errors(scene.Mapper);
  const FloatPicture before = scene.Render();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(camera->GetPosition());
  scene.Render();
  scene.Render();
  Check(errors.Take() <= 1, "camera without direction: at most one error");
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  Check(scene.Render() == before && errors.Take() == 0, "the surface is fogged again");
}

//------------------------------------------------------------------------------
void TestValues()
{
  vtkNew<vtkAirlightPolyDataMapper> mapper;
  ErrorListener errors(mapper);
  const vtkMTimeType time = mapper->GetMTime();
  for (const int evaluation : { -1, 2 })
  {
    mapper->SetEvaluation(evaluation);
    Check(errors.Take() == 1, "SetEvaluation(" + std::to_string(evaluation) + ") is an error");
    Check(errors.GetText().find("Evaluation " + std::to_string(evaluation)) != std::string::npos,
      "the error names the value");
  }
  Check(mapper->GetEvaluation() == vtkAirlightPolyDataMapper::FRAGMENT, "the evaluation stays");
  for (const double radius : { -1.0, nan, Infinity })
  {
    mapper->SetLightRadius(radius);
    Check(errors.Take() == 1, "a bad radius is an error");
  }
  Check(mapper->GetLightRadius() == 0.0, "the radius stays");
  Check(mapper->GetMedium(0) == nullptr && errors.Take() == 1, "GetMedium(0) is an error");
  mapper->AddMedium(nullptr);
  mapper->RemoveMedium(nullptr);
  mapper->SetMedium(nullptr);
  mapper->RemoveAllMedia();
  Check(mapper->GetMTime() == time && errors.Take() == 0, "nothing is modified");
}
}

//------------------------------------------------------------------------------
int TestAirlightPolyDataMapperErrors(int, char*[])
{
  TestScenes();
  TestCamera();
  TestValues();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
