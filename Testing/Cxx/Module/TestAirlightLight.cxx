// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightLight: defaults, what is set stays with the light, and bad values are refused.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"

#include "vtkAirlight.h"
#include "vtkAirlightLight.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkNew.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

using namespace airlight_test;

namespace
{
// Lights fixed to the scene scatter, others not, until something else is said.
void TestScatters()
{
  vtkNew<vtkLight> light;
  Check(vtkAirlightLight::GetScatters(light), "a scene light scatters");
  light->SetLightTypeToHeadlight();
  Check(!vtkAirlightLight::GetScatters(light), "a headlight does not");
  vtkMTimeType time = light->GetMTime();
  vtkAirlightLight::SetScatters(light, false);
  Check(light->GetMTime() > time, "a first value modifies the light, also the default");
  time = light->GetMTime();
  vtkAirlightLight::SetScatters(light, false);
  Check(light->GetMTime() == time, "the same value does not");
  light->SetLightTypeToSceneLight();
  Check(!vtkAirlightLight::GetScatters(light), "a value stays when the type changes");
  vtkAirlightLight::SetScatters(light, true);
  Check(vtkAirlightLight::GetScatters(light), "on again");
  vtkNew<vtkLight> copy;
  copy->DeepCopy(light);
  copy->SetLightTypeToCameraLight();
  Check(vtkAirlightLight::GetScatters(copy), "a copy has the same");
  vtkAirlightLight::SetScatters(copy, false);
  Check(!vtkAirlightLight::GetScatters(copy) && vtkAirlightLight::GetScatters(light),
    "a copy is changed alone");
  light->SetInformation(nullptr);
  light->SetLightTypeToHeadlight();
  Check(!vtkAirlightLight::GetScatters(light), "without information: the default");
  vtkAirlightLight::SetScatters(light, true);
  Check(vtkAirlightLight::GetScatters(light), "without information: set");
}

//------------------------------------------------------------------------------
void TestUnits()
{
  vtkNew<vtkLight> light;
  const double sent[3] = { 1.0, 20.0, 300.0 };
  double received[3];
  vtkAirlightLight::SetRadiantIntensity(light, sent);
  Check(light->GetPositional() == 1, "a radiant intensity makes a point light");
  vtkAirlightLight::GetRadiantIntensity(light, received);
  for (int k = 0; k < 3; ++k)
  {
    Check(std::abs(received[k] - sent[k]) < 1e-12 * sent[k], "the intensity comes back");
  }
  vtkAirlightLight::SetIrradiance(light, sent);
  Check(light->GetPositional() == 0, "an irradiance makes a directional light");
}

//------------------------------------------------------------------------------
void TestPhotometry(const std::string& folder)
{
  vtkNew<vtkLight> light;
  ErrorListener errors(light);
  Check(vtkAirlightLight::GetPhotometry(light) == nullptr &&
      vtkAirlightLight::GetPhotometryMaximum(light) == 0.0,
    "no file by default");
  const std::string good = folder + "/Photometry/lowbeam.ies";
  vtkMTimeType time = light->GetMTime();
  Check(vtkAirlightLight::SetPhotometry(light, good.c_str()) && light->GetMTime() > time &&
      vtkAirlightLight::GetPhotometry(light) == good &&
      vtkAirlightLight::GetPhotometryMaximum(light) > 0.0,
    "a file");
  time = light->GetMTime();
  Check(!vtkAirlightLight::SetPhotometry(light, "/nowhere.ies") && errors.Take() == 1 &&
      errors.GetText().find("/nowhere.ies") != std::string::npos && light->GetMTime() == time &&
      vtkAirlightLight::GetPhotometry(light) == good,
    "a bad file is refused: " + errors.GetText());
  double up[3];
  vtkAirlightLight::GetPhotometryUp(light, up);
  Check(up[0] == 0.0 && up[1] == 1.0 && up[2] == 0.0, "up by default");
  vtkAirlightLight::SetPhotometryUp(light, 1.0, 2.0, -3.0);
  for (const double bad : { 0.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    vtkAirlightLight::SetPhotometryUp(light, bad, bad, bad);
    Check(errors.Take() == 1 && errors.GetText().find("finite") != std::string::npos,
      "a bad direction is refused: " + errors.GetText());
  }
  vtkAirlightLight::GetPhotometryUp(light, up);
  Check(up[0] == 1.0 && up[1] == 2.0 && up[2] == -3.0, "up");
  Check(vtkAirlightLight::SetPhotometry(light, "") &&
      vtkAirlightLight::GetPhotometry(light) == nullptr && errors.Take() == 0,
    "an empty name removes the file");
}

//------------------------------------------------------------------------------
void TestNull()
{
  const bool display = vtkObject::GetGlobalWarningDisplay() != 0;
  vtkObject::GlobalWarningDisplayOff();
  double rgb[3] = { 1.0, 2.0, 3.0 };
  vtkAirlightLight::SetScatters(nullptr, true);
  vtkAirlightLight::SetRadiantIntensity(nullptr, rgb);
  vtkAirlightLight::SetIrradiance(nullptr, rgb);
  vtkAirlight::SetRadiantIntensity(nullptr, rgb);
  vtkAirlight::SetIrradiance(nullptr, rgb);
  vtkAirlightLight::SetPhotometryUp(nullptr, 0.0, 0.0, 1.0);
  Check(!vtkAirlightLight::GetScatters(nullptr), "null does not scatter");
  Check(!vtkAirlightLight::SetPhotometry(nullptr, "a.ies") &&
      vtkAirlightLight::GetPhotometry(nullptr) == nullptr,
    "null has no file");
  vtkAirlightLight::GetRadiantIntensity(nullptr, rgb);
  Check(rgb[0] == 0.0 && rgb[1] == 0.0 && rgb[2] == 0.0, "null has no power");
  vtkAirlight::GetRadiantIntensity(nullptr, rgb);
  vtkObject::SetGlobalWarningDisplay(display);
}
}

//------------------------------------------------------------------------------
int TestAirlightLight(int argc, char* argv[])
{
  std::string folder;
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = std::string(argv[i]) == "-D" ? argv[i + 1] : folder;
  }
  TestScatters();
  TestUnits();
  TestPhotometry(folder);
  TestNull();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
