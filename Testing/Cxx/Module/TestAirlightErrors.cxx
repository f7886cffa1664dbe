// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlight with bad input: the answer false, zeros, and an error that an observer sees. Finite
// input of any size is either refused that way or gives finite numbers.

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkCallbackCommand.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>

using airlight_test::Check;
using airlight_test::Failures;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Counts an object's error events while it lives.
class ErrorCounter
{
public:
  explicit ErrorCounter(vtkObject* object)
    : Object(object)
  {
    this->Command->SetClientData(&this->Count);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    this->Tag = object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~ErrorCounter() { this->Object->RemoveObserver(this->Tag); }
  ErrorCounter(const ErrorCounter&) = delete;
  void operator=(const ErrorCounter&) = delete;

  int Count = 0;

private:
  vtkObject* Object;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag;
};

// `call` gets an answer to overwrite and must refuse: one error event of `reporter`.
void CheckRefused(
  const std::string& what, vtkObject* reporter, const std::function<bool(double*)>& call)
{
  ErrorCounter errors(reporter);
  double rgb[3] = { 7.0, 7.0, 7.0 };
  Check(!call(rgb), what + " returns false");
  Check(rgb[0] == 0.0 && rgb[1] == 0.0 && rgb[2] == 0.0, what + " gives zeros");
  Check(errors.Count == 1, what + " emits one error, not " + std::to_string(errors.Count));
}

// Good arguments for the cases to spoil one by one.
struct Arguments
{
  double LightPosition[3] = { 1.0, 2.0, 0.0 };
  double Intensity[3] = { 1.0, 1.0, 1.0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 1.0, 0.0, 0.0 };
  double T0 = 0.0;
  double T1 = 5.0;

  bool Inscatter(vtkParticipatingMedium* medium, double* rgb) const
  {
    return vtkAirlight::Inscatter(medium, this->LightPosition, this->Intensity, this->Origin,
      this->Direction, this->T0, this->T1, rgb);
  }
  bool Inscatter(vtkParticipatingMedium* medium, vtkLight* light, double* rgb) const
  {
    return vtkAirlight::Inscatter(
      medium, light, this->Origin, this->Direction, this->T0, this->T1, rgb);
  }
};

//------------------------------------------------------------------------------
// There is no object to observe: the warning goes to VTK's output window.
void TestNullMedium()
{
  vtkNew<vtkStringOutputWindow> window;
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(window);
  const Arguments a;
  vtkNew<vtkLight> light;
  light->PositionalOn();
  light->SetConeAngle(90.0);
  const std::pair<const char*, std::function<bool(double*)>> calls[] = {
    { "Inscatter of a point light without a medium",
      [&](double* rgb) { return a.Inscatter(nullptr, rgb); } },
    { "Inscatter of a vtkLight without a medium",
      [&](double* rgb) { return a.Inscatter(nullptr, light, rgb); } },
    { "Transmittance without a medium",
      [&](double* rgb) {
        return vtkAirlight::Transmittance(nullptr, a.Origin, a.LightPosition, rgb);
      } },
    { "Ambient without a medium",
      [&](double* rgb) { return vtkAirlight::Ambient(nullptr, a.Origin, a.Direction, a.T1, rgb); } }
  };
  size_t length = 0;
  for (const auto& call : calls)
  {
    double rgb[3] = { 7.0, 7.0, 7.0 };
    Check(!call.second(rgb), std::string(call.first) + " returns false");
    Check(rgb[0] == 0.0 && rgb[1] == 0.0 && rgb[2] == 0.0, std::string(call.first) + " zeros");
    Check(window->GetOutput().size() > length, std::string(call.first) + " warns");
    length = window->GetOutput().size();
  }
  vtkOutputWindow::SetInstance(before);
}

//------------------------------------------------------------------------------
void TestBadRays(vtkParticipatingMedium* medium)
{
  vtkNew<vtkLight> light;
  light->PositionalOn();
  light->SetConeAngle(90.0);
  for (double bad : { nan, inf, -inf })
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::string where = "[" + std::to_string(i) + "] = " + std::to_string(bad);
      Arguments a;
      a.Origin[i] = bad;
      CheckRefused("origin" + where, medium, [&](double* rgb) { return a.Inscatter(medium, rgb); });
      CheckRefused("origin of a vtkLight's ray" + where, medium,
        [&](double* rgb) { return a.Inscatter(medium, light, rgb); });
      CheckRefused("Ambient's origin" + where, medium,
        [&](double* rgb) { return vtkAirlight::Ambient(medium, a.Origin, a.Direction, 1.0, rgb); });
      CheckRefused("Transmittance's a" + where, medium, [&](double* rgb) {
        return vtkAirlight::Transmittance(medium, a.Origin, a.Direction, rgb);
      });
      CheckRefused("Transmittance's b" + where, medium, [&](double* rgb) {
        return vtkAirlight::Transmittance(medium, a.Direction, a.Origin, rgb);
      });
      a = Arguments();
      a.Direction[i] = bad;
      CheckRefused(
        "direction" + where, medium, [&](double* rgb) { return a.Inscatter(medium, rgb); });
      CheckRefused("Ambient's direction" + where, medium,
        [&](double* rgb) { return vtkAirlight::Ambient(medium, a.Origin, a.Direction, 1.0, rgb); });
      a = Arguments();
      a.LightPosition[i] = bad;
      CheckRefused(
        "light position" + where, medium, [&](double* rgb) { return a.Inscatter(medium, rgb); });
      a = Arguments();
      a.Intensity[i] = bad;
      CheckRefused(
        "radiant intensity" + where, medium, [&](double* rgb) { return a.Inscatter(medium, rgb); });
    }
  }
  Arguments a;
  a.T0 = nan;
  CheckRefused("t0 = nan", medium, [&](double* rgb) { return a.Inscatter(medium, rgb); });
  a = Arguments();
  a.T1 = nan;
  CheckRefused("t1 = nan", medium, [&](double* rgb) { return a.Inscatter(medium, light, rgb); });
  CheckRefused("Ambient's t1 = nan", medium,
    [&](double* rgb) { return vtkAirlight::Ambient(medium, a.Origin, a.Direction, nan, rgb); });
  a = Arguments();
  a.Direction[0] = 0.0;
  CheckRefused("direction 0", medium, [&](double* rgb) { return a.Inscatter(medium, rgb); });
  CheckRefused("Ambient's direction 0", medium,
    [&](double* rgb) { return vtkAirlight::Ambient(medium, a.Origin, a.Direction, 1.0, rgb); });
}

//------------------------------------------------------------------------------
void TestBadLights(vtkParticipatingMedium* medium)
{
  const Arguments a;
  CheckRefused(
    "null light", medium, [&](double* rgb) { return a.Inscatter(medium, nullptr, rgb); });
  const std::pair<const char*, std::function<void(vtkLight*)>> cases[] = {
    { "spot light that shines nowhere",
      [](vtkLight* light) {
        light->SetConeAngle(30.0);
        light->SetPosition(1.0, 2.0, 3.0);
        light->SetFocalPoint(1.0, 2.0, 3.0);
      } },
    { "attenuation (0, 0, 0)", [](vtkLight* l) { l->SetAttenuationValues(0.0, 0.0, 0.0); } },
    { "negative attenuation", [](vtkLight* l) { l->SetAttenuationValues(1.0, -1.0, 1.0); } },
    { "attenuation nan", [](vtkLight* l) { l->SetAttenuationValues(nan, 0.0, 1.0); } },
    { "attenuation inf", [](vtkLight* l) { l->SetAttenuationValues(0.0, inf, 1.0); } },
    { "position nan", [](vtkLight* l) { l->SetPosition(0.0, nan, 1.0); } },
    { "position inf", [](vtkLight* l) { l->SetPosition(0.0, 1.0, -inf); } },
    { "colour nan", [](vtkLight* l) { l->SetDiffuseColor(1.0, nan, 1.0); } },
    { "intensity inf", [](vtkLight* l) { l->SetIntensity(inf); } },
    { "directional light that shines nowhere",
      [](vtkLight* light) {
        light->PositionalOff();
        light->SetPosition(1.0, 2.0, 3.0);
        light->SetFocalPoint(1.0, 2.0, 3.0);
      } },
  };
  for (const auto& one : cases)
  {
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(90.0);
    one.second(light);
    CheckRefused(one.first, light, [&](double* rgb) { return a.Inscatter(medium, light, rgb); });
  }
}

//------------------------------------------------------------------------------
// A direction of any length above 0 is normalised.
void TestDirectionLength(vtkParticipatingMedium* medium)
{
  Arguments a;
  double expected[3];
  a.Inscatter(medium, expected);
  for (double length : { 1e-320, 1e-200, 1e-3, 1e200, 1e308 })
  {
    ErrorCounter errors(medium);
    a.Direction[0] = length;
    double rgb[3];
    const bool done = a.Inscatter(medium, rgb);
    Check(done && std::abs(rgb[0] - expected[0]) <= 1e-12 * expected[0],
      airlight_test::Text("direction of length ", length, " counts as a unit vector"));
  }
}

// Huge, but finite: finite numbers, or a refusal with zeros.
void TestHugeNumbers(vtkParticipatingMedium* medium)
{
  vtkNew<vtkLight> light; // without fall-off
  light->PositionalOn();
  light->SetConeAngle(90.0);
  medium->SetAmbientRadiance(1.0, 1.0, 1.0);
  ErrorCounter errors(medium);
  ErrorCounter lightErrors(light);
  const char* const names[] = { "light position", "origin", "direction", "t1" };
  const std::string functions[] = { "Inscatter of a point light", "Inscatter of a vtkLight",
    "Transmittance", "Ambient" };
  const double huge[] = { 1e100, 1e155, -1e200, 1.7e308 };
  for (double value : huge)
  {
    for (int i = 0; i < 12; ++i)
    {
      Arguments a;
      double* const targets[] = { a.LightPosition, a.Origin, a.Direction, &a.T1 };
      targets[i / 3][i / 3 == 3 ? 0 : i % 3] = value;
      for (int region = 0; region < 2; ++region)
      {
        medium->SetRegion(region);
        light->SetPosition(a.LightPosition);
        const std::string what = airlight_test::Text(
          ", region ", region, ": ", names[i / 3], " with ", value, " gives finite numbers");
        double rgb[4][3];
        std::fill_n(&rgb[0][0], 12, nan);
        a.Inscatter(medium, rgb[0]);
        a.Inscatter(medium, light, rgb[1]);
        vtkAirlight::Transmittance(medium, a.Origin, a.LightPosition, rgb[2]);
        vtkAirlight::Ambient(medium, a.Origin, a.Direction, a.T1, rgb[3]);
        for (int k = 0; k < 12; ++k)
        {
          Check(std::isfinite(rgb[k / 3][k % 3]), functions[k / 3] + what);
        }
      }
    }
  }
  medium->SetRegionToUnbounded();
}
}

//------------------------------------------------------------------------------
int TestAirlightErrors(int, char*[])
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.2, 0.3);
  TestNullMedium();
  TestBadRays(medium);
  TestBadLights(medium);
  TestDirectionLength(medium);
  TestHugeNumbers(medium);
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
