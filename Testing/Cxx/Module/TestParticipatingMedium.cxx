// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkParticipatingMedium: defaults, coefficients and the quantities derived from them, and refusal
// of bad values. Its phase functions: TestPhaseFunctions.cxx and TestPhaseErrors.cxx.

#include "AirlightTestCheck.h"
#include "Integration/AirlightMembers.h"
#include "Medium/AirlightConvert.h"

#include "vtkCallbackCommand.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

using airlight_test::Check;
using airlight_test::Failures;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void CheckNear(double value, double expected, double relative, const std::string& what)
{
  if (!(std::abs(value - expected) <= relative * std::abs(expected)))
  {
    std::cerr.precision(17);
    std::cerr << "FAILED: " << what << " is " << value << ", expected " << expected << "\n";
    ++Failures;
  }
}

void CheckNear3(
  const double* value, double r, double g, double b, double relative, const std::string& what)
{
  CheckNear(value[0], r, relative, what + "[0]");
  CheckNear(value[1], g, relative, what + "[1]");
  CheckNear(value[2], b, relative, what + "[2]");
}

//------------------------------------------------------------------------------
void TestDefaults()
{
  vtkNew<vtkParticipatingMedium> medium;
  CheckNear3(medium->GetScattering(), 0, 0, 0, 0, "default scattering");
  CheckNear3(medium->GetAbsorption(), 0, 0, 0, 0, "default absorption");
  CheckNear3(medium->GetExtinction(), 0, 0, 0, 0, "default extinction");
  CheckNear3(medium->GetAlbedo(), 1, 1, 1, 0, "albedo of a clear medium");
  CheckNear3(medium->GetAmbientRadiance(), 0, 0, 0, 0, "default ambient radiance");
  Check(medium->GetVisibility() == inf, "a clear medium has infinite visibility");
  Check(medium->GetMeanFreePath() == inf, "a clear medium has an infinite mean free path");
  Check(medium->GetPhaseFunction() == vtkParticipatingMedium::ISOTROPIC, "default phase function");
  CheckNear(medium->GetAnisotropy(), 0.0, 0.0, "default anisotropy");
  CheckNear(medium->GetPhaseTolerance(), 1e-3, 0.0, "default phase tolerance");
  Check(medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED, "default region");
  const double* bounds = medium->GetBounds();
  for (int i = 0; i < 6; ++i)
  {
    CheckNear(bounds[i], i % 2 ? 1.0 : -1.0, 0.0, "default bounds");
  }
}

//------------------------------------------------------------------------------
void TestCoefficients()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.2, 0.0);
  medium->SetAbsorption(0.3, 0.0, 0.5);
  CheckNear3(medium->GetExtinction(), 0.4, 0.2, 0.5, 1e-15, "extinction");
  CheckNear3(medium->GetAlbedo(), 0.25, 1.0, 0.0, 1e-15, "albedo");
  double rgb[3];
  medium->GetExtinction(rgb);
  CheckNear3(rgb, 0.4, 0.2, 0.5, 1e-15, "extinction, by argument");
  medium->GetAlbedo(rgb);
  CheckNear3(rgb, 0.25, 1.0, 0.0, 1e-15, "albedo, by argument");

  // The derived values follow each change, and each change is a modification.
  const vtkMTimeType before = medium->GetMTime();
  const double scattering[3] = { 0.6, 0.8, 0.5 };
  medium->SetScattering(scattering);
  Check(medium->GetMTime() > before, "a new coefficient modifies the medium");
  CheckNear3(medium->GetExtinction(), 0.9, 0.8, 1.0, 1e-15, "extinction after a change");
  CheckNear3(medium->GetAlbedo(), 2.0 / 3.0, 1.0, 0.5, 1e-15, "albedo after a change");
}

//------------------------------------------------------------------------------
void TestDistances()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.2, 0.3);
  medium->SetAbsorption(0.3, 0.1, 0.2);
  // Extinctions 0.4, 0.3, 0.5: their mean is 0.4.
  CheckNear(medium->GetMeanFreePath(), 2.5, 1e-14, "mean free path");
  CheckNear(medium->GetVisibility(), 3.912 / 0.4, 1e-14, "visibility");

  // Koschmieder: visibility 50 is a mean extinction of 3.912/50. All coefficients are scaled by
  // 3.912/50/0.4.
  medium->SetVisibility(50.0);
  const double scale = 3.912 / 50.0 / 0.4;
  CheckNear3(medium->GetScattering(), 0.1 * scale, 0.2 * scale, 0.3 * scale, 1e-14,
    "scattering after SetVisibility");
  CheckNear3(medium->GetAbsorption(), 0.3 * scale, 0.1 * scale, 0.2 * scale, 1e-14,
    "absorption after SetVisibility");
  CheckNear3(medium->GetAlbedo(), 0.25, 2.0 / 3.0, 0.6, 1e-14, "albedo after SetVisibility");
  CheckNear(medium->GetVisibility(), 50.0, 1e-14, "visibility after SetVisibility");

  medium->SetMeanFreePath(2.5); // back to where it was
  CheckNear3(medium->GetScattering(), 0.1, 0.2, 0.3, 1e-14, "scattering after SetMeanFreePath");
  CheckNear3(medium->GetAbsorption(), 0.3, 0.1, 0.2, 1e-14, "absorption after SetMeanFreePath");
  CheckNear(medium->GetMeanFreePath(), 2.5, 1e-14, "mean free path after SetMeanFreePath");

  // A clear medium has no colour to keep: it becomes grey and only scatters.
  vtkNew<vtkParticipatingMedium> clear;
  clear->SetMeanFreePath(4.0);
  CheckNear3(clear->GetScattering(), 0.25, 0.25, 0.25, 1e-15, "scattering of grey fog");
  CheckNear3(clear->GetAbsorption(), 0, 0, 0, 0, "absorption of grey fog");
  vtkNew<vtkParticipatingMedium> hazy;
  hazy->SetVisibility(1000.0);
  CheckNear3(hazy->GetScattering(), 0.003912, 0.003912, 0.003912, 1e-14, "scattering of haze");

  // The largest and the smallest coefficients, scaled to a mean of 0.5: their ratios are kept.
  for (double size : { 1e100, 1e-300 })
  {
    vtkNew<vtkParticipatingMedium> extreme;
    extreme->SetScattering(size, size / 2.0, 0.0);
    extreme->SetAbsorption(size, size / 2.0, 0.0);
    extreme->SetMeanFreePath(2.0);
    CheckNear3(extreme->GetScattering(), 0.5, 0.25, 0.0, 1e-14, "extreme scattering, scaled");
    CheckNear3(extreme->GetAbsorption(), 0.5, 0.25, 0.0, 1e-14, "extreme absorption, scaled");
  }
}

//------------------------------------------------------------------------------
// Calls `set` with each bad value: it must emit one error event, modify nothing and leave what
// `get` returns.
void CheckRefused(vtkParticipatingMedium* medium, const std::string& name,
  const std::vector<double>& badValues, const std::function<void(double)>& set,
  const std::function<std::vector<double>()>& get)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  const unsigned long tag = medium->AddObserver(vtkCommand::ErrorEvent, observer);
  for (double bad : badValues)
  {
    const std::string what = name + "(" + std::to_string(bad) + ") ";
    const std::vector<double> old = get();
    const vtkMTimeType time = medium->GetMTime();
    errors = 0;
    set(bad);
    Check(errors == 1, what + "emits one error, not " + std::to_string(errors));
    Check(get() == old, what + "leaves the old value");
    Check(medium->GetMTime() == time, what + "modifies nothing");
  }
  medium->RemoveObserver(tag);
}

void TestBadInput()
{
  vtkNew<vtkParticipatingMedium> m;
  m->SetScattering(0.1, 0.2, 0.3);
  m->SetAbsorption(0.4, 0.5, 0.6);
  m->SetAmbientRadiance(0.7, 0.8, 0.9);
  m->SetPhaseFunctionToHenyeyGreenstein();
  m->SetAnisotropy(0.5);
  m->SetBounds(1, 2, 3, 4, 5, 6);
  m->SetRegionToBox();

  auto coefficients = [&m] {
    std::vector<double> values(m->GetScattering(), m->GetScattering() + 3);
    values.insert(values.end(), m->GetAbsorption(), m->GetAbsorption() + 3);
    values.insert(values.end(), m->GetAmbientRadiance(), m->GetAmbientRadiance() + 3);
    return values;
  };
  const std::vector<double> notCoefficients = { -1.0, -1e-300, 1.01e100, inf, -inf, nan };
  // A bad value in any channel spoils all three.
  CheckRefused(
    m, "SetScattering red", notCoefficients, [&m](double v) { m->SetScattering(v, 7, 7); },
    coefficients);
  CheckRefused(
    m, "SetScattering blue", notCoefficients, [&m](double v) { m->SetScattering(7, 7, v); },
    coefficients);
  CheckRefused(
    m, "SetAbsorption green", notCoefficients, [&m](double v) { m->SetAbsorption(7, v, 7); },
    coefficients);
  CheckRefused(
    m, "SetAmbientRadiance green", notCoefficients,
    [&m](double v) { m->SetAmbientRadiance(7, v, 7); }, coefficients);

  const std::vector<double> notDistances = { 0.0, -1.0, 1e-100, inf, -inf, nan };
  CheckRefused(
    m, "SetVisibility", notDistances, [&m](double v) { m->SetVisibility(v); }, coefficients);
  CheckRefused(
    m, "SetMeanFreePath", notDistances, [&m](double v) { m->SetMeanFreePath(v); }, coefficients);

  CheckRefused(
    m, "SetAnisotropy", { 1.5, -1.5, 1.0, -1.0, 0.991, inf, nan },
    [&m](double v) { m->SetAnisotropy(v); },
    [&m] { return std::vector<double>{ m->GetAnisotropy() }; });
  CheckRefused(
    m, "SetPhaseTolerance", { 0.0, -1e-3, 0.2, 1e-7, inf, nan },
    [&m](double v) { m->SetPhaseTolerance(v); },
    [&m] { return std::vector<double>{ m->GetPhaseTolerance() }; });
  CheckRefused(
    m, "SetPhaseFunction", { -1, 99 }, [&m](double v) { m->SetPhaseFunction(static_cast<int>(v)); },
    [&m] { return std::vector<double>{ double(m->GetPhaseFunction()) }; });
  CheckRefused(
    m, "SetRegion", { -1, 99 }, [&m](double v) { m->SetRegion(static_cast<int>(v)); },
    [&m] { return std::vector<double>{ double(m->GetRegion()) }; });

  auto bounds = [&m] { return std::vector<double>(m->GetBounds(), m->GetBounds() + 6); };
  CheckRefused(
    m, "SetBounds xmin", { 9.0, inf, -inf, nan },
    [&m](double v) { m->SetBounds(v, 8, 7, 8, 7, 8); }, bounds);
  CheckRefused(
    m, "SetBounds zmax", { 6.0, inf, -inf, nan },
    [&m](double v) { m->SetBounds(7, 8, 7, 8, 7, v); }, bounds);

  // A box without thickness is a box.
  m->SetBounds(1, 1, 2, 2, 3, 3);
  Check(bounds() == std::vector<double>({ 1, 1, 2, 2, 3, 3 }), "a flat box is accepted");
}

//------------------------------------------------------------------------------
// A region is in the same place of the world wherever it is seen from, with all of its positions.
void TestOrigins()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetBounds(1, 2, 3, 5, 7, 11);
  medium->SetCenter(13, 17, 19);
  const glm::dvec3 near(0.0);
  const glm::dvec3 far(64.0, -32.0, 16.0); // sums with it are exact
  for (const int region : { vtkParticipatingMedium::UNBOUNDED, vtkParticipatingMedium::BOX,
         vtkParticipatingMedium::SPHERE, vtkParticipatingMedium::CYLINDER })
  {
    medium->SetRegion(region);
    const auto a = airlight::ConvertMedia({ medium }, near).item[0].region;
    const auto b = airlight::ConvertMedia({ medium }, far).item[0].region;
    airlight::VisitRegion(
      [&](const airlight::Member& member, const auto& first, const auto& second) {
        if constexpr (std::is_same_v<decltype(first), const glm::dvec3&>)
        {
          Check(!member.IsPosition || first + near == second + far,
            "region " + std::to_string(region) + ": " + member.Name +
              " does not move with the eye");
        }
      },
      a, b);
  }
}

//------------------------------------------------------------------------------
// A surface makes the region, unless one has been chosen.
void TestSurfaceAsRegion()
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetSurface(cube->GetOutput());
  Check(medium->GetRegion() == vtkParticipatingMedium::SURFACE, "a surface is the region");
  medium->SetSurface(nullptr);
  Check(medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED, "no surface, no region");
  medium->SetRegionToBox();
  medium->SetSurface(cube->GetOutput());
  Check(medium->GetRegion() == vtkParticipatingMedium::BOX, "a region that was chosen stays");
}
}

int TestParticipatingMedium(int, char*[])
{
  TestDefaults();
  TestCoefficients();
  TestDistances();
  TestBadInput();
  TestOrigins();
  TestSurfaceAsRegion();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
