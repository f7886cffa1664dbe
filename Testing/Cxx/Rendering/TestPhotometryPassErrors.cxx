// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Photometric files and lamps that are no good, given to the pass: an error that names the culprit,
// what was said before stays, and the picture is as the header says and finite.

#include "AirlightTestErrors.h"
#include "AirlightTestPhotometry.h"
#include "AirlightTestScene.h"

#include "vtkPlaneSource.h"

#include <cstdlib>
#include <fstream>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Stage : Scene
{
  Stage()
    : Scene(64, 48)
  {
    vtkNew<vtkPlaneSource> wall;
    wall->SetOrigin(-6.0, -5.0, -2.0);
    wall->SetPoint1(6.0, -5.0, -2.0);
    wall->SetPoint2(-6.0, 5.0, -2.0);
    this->Add(wall);
    this->AddPointLight({ -1.5, 0.5, 1.0 })->SetFocalPoint(-1.0, -1.0, -2.0);
  }

  // One error with all the words.
  void ExpectError(const std::string& what, const std::vector<std::string>& words)
  {
    Check(this->Errors.Take() == 1, what + ": one error");
    for (const std::string& word : words)
    {
      Check(this->Errors.GetText().find(word) != std::string::npos,
        what + ": the error says \"" + word + "\": " + this->Errors.GetText());
    }
  }

  // Two frames: nothing is said twice.
  Buffers Draw(const std::string& what, int warnings)
  {
    this->Window->Render();
    Buffers buffers = this->Render();
    Check(this->Errors.Take() == 0, what + ": no error while drawing");
    Check(this->Warnings.Take() == warnings, what + ": " + std::to_string(warnings) + " warnings");
    CheckFinite(buffers, what);
    return buffers;
  }

  ErrorListener Errors{ this->Pass };
  ErrorListener Warnings{ this->Pass, vtkCommand::WarningEvent };
};

//------------------------------------------------------------------------------
void TestBadFiles(const std::string& good, const std::string& bad)
{
  Stage stage;
  vtkAirlightPass* pass = stage.Pass;
  vtkLight* light = stage.Lights[0];
  const Buffers plain = stage.Draw("plain", 0);
  std::ofstream(bad) << "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 40\n0 90\n0\n"
                        "100 -5\n";
  const std::string missing = bad + ".missing";

  for (const bool before : { false, true })
  {
    pass->SetLightPhotometry(light, before ? good.c_str() : nullptr);
    const Buffers expected = stage.Draw("before", 0);
    const vtkMTimeType time = pass->GetMTime();
    Check(!pass->SetLightPhotometry(light, missing.c_str()), "a missing file is refused");
    stage.ExpectError("a missing file", { missing, "cannot be read", "expected" });
    Check(!pass->SetLightPhotometry(light, bad.c_str()), "a negative value is refused");
    stage.ExpectError("a negative value", { bad + ":7", "-5", "expected" });
    Check(!pass->SetLightPhotometry(nullptr, good.c_str()), "null is refused");
    stage.ExpectError("null", { "SetLightPhotometry", "light", "null" });
    Check(!pass->SetLightPhotometry(nullptr, nullptr), "null without file is refused");
    stage.ExpectError("null without file", { "SetLightPhotometry", "light", "null" });
    Check(pass->GetMTime() == time, "nothing is modified");
    const char* name = pass->GetLightPhotometry(light);
    Check(before ? name && name == good : !name, "the file stays");
    Check(pass->GetLightPhotometryMaximum(light) == (before ? 2490.0 : 0.0), "its candela stay");
    CheckSame(stage.Draw("after", 0), expected, "what was there stays");
  }
  Check(!pass->GetLightPhotometry(nullptr), "null has no file");
  Check(pass->GetLightPhotometryMaximum(nullptr) == 0.0, "null has no candela");
  pass->SetLightPhotometry(light, nullptr);
  CheckSame(stage.Draw("removed", 0), plain, "without the file");
}

//------------------------------------------------------------------------------
void TestBadUps(const std::string& good)
{
  Stage stage;
  vtkAirlightPass* pass = stage.Pass;
  vtkLight* light = stage.Lights[0];
  glm::dvec3 up;
  pass->GetLightPhotometryUp(light, &up.x);
  Check(up == glm::dvec3(0.0, 1.0, 0.0), "the default up");
  pass->GetLightPhotometryUp(nullptr, &up.x);
  Check(up == glm::dvec3(0.0, 1.0, 0.0), "the default up of null");
  pass->SetLightPhotometry(light, good.c_str());
  pass->SetLightPhotometryUp(light, 1.0, 2.0, 0.5);
  const Buffers expected = stage.Draw("a good up", 0);
  const vtkMTimeType time = pass->GetMTime();
  const std::pair<glm::dvec3, const char*> ups[] = { { { nan, 1, 0 }, "(nan, 1, 0)" },
    { { 0, 1, Infinity }, "(0, 1, inf)" }, { { 0, 0, 0 }, "(0, 0, 0)" } };
  for (const auto& bad : ups)
  {
    pass->SetLightPhotometryUp(light, bad.first.x, bad.first.y, bad.first.z);
    stage.ExpectError("a bad up", { "SetLightPhotometryUp", bad.second, "finite", "not 0" });
  }
  pass->SetLightPhotometryUp(nullptr, 0.0, 1.0, 0.0);
  stage.ExpectError("the up of null", { "SetLightPhotometryUp", "null" });
  Check(pass->GetMTime() == time, "nothing is modified");
  pass->GetLightPhotometryUp(light, &up.x);
  Check(up == glm::dvec3(1.0, 2.0, 0.5), "the up stays");
  CheckSame(stage.Draw("bad ups", 0), expected, "the up stays");
  for (const double size : { 0x1p-600, 0x1p-100, 0x1p100 })
  {
    pass->SetLightPhotometryUp(light, size, 2.0 * size, 0.5 * size);
    Check(stage.Errors.Take() == 0, "any length is good");
    CheckSame(stage.Draw("lengths", 0), expected, "the length does not count");
  }
}

//------------------------------------------------------------------------------
// A lamp that has no directions is drawn as if there were no file, and one warning says so.
void TestLampsWithoutDirections(const std::string& good)
{
  for (const bool directional : { true, false })
  {
    const std::string what = directional ? "a directional light" : "a lamp that aims nowhere";
    Stage stage;
    vtkLight* light = stage.Lights[0];
    directional ? light->PositionalOff() : light->SetFocalPoint(light->GetPosition());
    const Buffers plain = stage.Draw(what, 0);
    Check(stage.Pass->SetLightPhotometry(light, good.c_str()), what + ": the file is read");
    stage.Window->Render();
    Check(stage.Warnings.Take() == 1, what + ": one warning");
    for (const char* word : { good.c_str(), "positional", "focal point" })
    {
      Check(stage.Warnings.GetText().find(word) != std::string::npos,
        what + ": the warning says \"" + word + "\": " + stage.Warnings.GetText());
    }
    CheckSame(stage.Draw(what, 0), plain, what + " is plain");
  }
}

// The file of a light that is not drawn is kept for when it is.
void TestAbsentLights(const std::string& good)
{
  Stage stage;
  const Buffers plain = stage.Draw("plain", 0);
  vtkNew<vtkLight> light;
  const double intensity[3] = { 10.0, 20.0, 30.0 };
  vtkAirlight::SetRadiantIntensity(light, intensity);
  light->SetLightTypeToSceneLight();
  light->SetPosition(1.0, 1.0, 1.0);
  light->SetFocalPoint(0.0, -1.0, 0.0);
  Check(stage.Pass->SetLightPhotometry(light, good.c_str()), "a light of no renderer");
  CheckSame(stage.Draw("a light of no renderer", 0), plain, "a light of no renderer");
  stage.AddLight(light);
  const Buffers added = stage.Draw("added", 0);
  light->SwitchOff();
  CheckSame(stage.Draw("switched off", 0), plain, "a light that is switched off");
  light->SwitchOn();
  CheckSame(stage.Draw("switched on", 0), added, "a light that is switched on");
  stage.Renderer->RemoveLight(light);
  CheckSame(stage.Draw("removed", 0), plain, "a light taken from the renderer");
  // A light that is deleted takes its file along.
  {
    vtkNew<vtkLight> other;
    stage.Pass->SetLightPhotometry(other, good.c_str());
  }
  CheckSame(stage.Draw("deleted", 0), plain, "a light that is gone");
  light->SetPosition(nan, 0.0, 0.0);
  stage.AddLight(light);
  CheckFinite(stage.Draw("at an undefined place", 1), "a lamp at an undefined place");
}

//------------------------------------------------------------------------------
// Places where directions are hard to tell: on the wall, at the eye, on a ray.
void TestPlaces(const std::string& data)
{
  for (const char* name : { "downlight.ies", "lowbeam.ies" })
  {
    Stage stage;
    stage.Pass->SetLightPhotometry(stage.Lights[0], (data + name).c_str());
    for (const glm::dvec3& place : { glm::dvec3(0.0, 0.0, -2.0), glm::dvec3(0.0, 1.0, 10.0),
           glm::dvec3(0.0, 0.5, 5.0), glm::dvec3(0.0, 3.0, 30.0) })
    {
      stage.Lights[0]->SetPosition(place.x, place.y, place.z);
      // Along the view: the ray of the picture's middle is the lamp's axis.
      stage.Lights[0]->SetFocalPoint(place.x, place.y - 0.1, place.z - 1.0);
      stage.Draw(name, 0);
    }
  }
}

// A spot's cone cuts the file's light.
void TestCone(const std::string& good)
{
  Stage stage;
  vtkLight* light = stage.Lights[0];
  stage.Pass->SetLightPhotometry(light, good.c_str());
  const Buffers wide = stage.Draw("wide", 0);
  light->SetConeAngle(15.0);
  light->SetExponent(0.0);
  const Buffers narrow = stage.Draw("narrow", 0);
  int dark = 0;
  int same = 0;
  for (int pixel = 0; pixel < 64 * 48; ++pixel)
  {
    const int x = pixel % 64;
    const int y = pixel / 64;
    const glm::dvec3 point = stage.GetRay(x + 0.5, y + 0.5).Origin +
      GetValue(wide.at("Depth"), x, y) * stage.GetRay(x + 0.5, y + 0.5).Direction;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.5, -1.5, -3.0));
    const glm::dvec3 d = glm::normalize(point - glm::dvec3(-1.5, 0.5, 1.0));
    const double degrees = glm::degrees(std::acos(glm::dot(d, axis)));
    const double a = GetValue(wide.at("Surface"), x, y);
    const double b = GetValue(narrow.at("Surface"), x, y);
    if (degrees > 15.1)
    {
      dark += Check(b == 0.0, "dark outside of the cone");
    }
    else if (degrees < 14.9)
    {
      same += Check(std::abs(b - a) <= 1e-5 * a, "as without the cone inside of it");
    }
    Check(
      GetValue(narrow.at("Airlight"), x, y) <= (1.0 + 1e-3) * GetValue(wide.at("Airlight"), x, y),
      "a cone takes light away");
  }
  Check(dark > 100 && same > 50, "the wall shows the cone");
}
}

//------------------------------------------------------------------------------
int TestPhotometryPassErrors(int argc, char* argv[])
{
  const std::string good = GetPhotometricFile(argc, argv, "downlight.ies");
  TestBadFiles(good, GetTemporaryFile(argc, argv, "TestPhotometryPassErrors.ies"));
  TestBadUps(good);
  TestLampsWithoutDirections(good);
  TestAbsentLights(good);
  TestPlaces(GetPhotometricFile(argc, argv));
  TestCone(good);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
