// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Bad values for where a medium is: one error that names the property and the value, the old value
// stays, and nothing is modified. Directions of every finite length are taken.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"

#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double most = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

using Vector = std::array<double, 3>;

std::string Describe(const Vector& v) { return Text("(", v[0], ", ", v[1], ", ", v[2], ")"); }

// `set` is refused with one error that has these parts.
void CheckRefused(vtkParticipatingMedium* medium, const std::string& what,
  const std::vector<std::string>& parts, const std::function<void()>& set)
{
  ErrorListener errors(medium);
  const vtkMTimeType time = medium->GetMTime();
  set();
  Check(errors.Take() == 1, what + " gives one error");
  for (const std::string& part : parts)
  {
    Check(errors.GetText().find(part) != std::string::npos,
      Text(what, " names \"", part, "\": ", errors.GetText()));
  }
  Check(medium->GetMTime() == time, what + " modifies nothing");
}

void CheckTaken(
  vtkParticipatingMedium* medium, const std::string& what, const std::function<void()>& set)
{
  ErrorListener errors(medium);
  const vtkMTimeType time = medium->GetMTime();
  set();
  const vtkMTimeType after = medium->GetMTime();
  Check(after > time, what + " modifies the medium");
  set();
  Check(medium->GetMTime() == after, what + " modifies it once");
  Check(errors.Take() == 0, what + " gives no error");
}

//------------------------------------------------------------------------------
void TestNumbers(vtkParticipatingMedium* medium)
{
  struct Property
  {
    const char* Name;
    std::vector<double> Bad;
    std::function<void(double)> Set;
    std::function<double()> Get;
  };
  const Property properties[] = { { "Radius", { -1.0, -1e-300, inf, nan },
                                    [&](double v) { medium->SetRadius(v); },
                                    [&] { return medium->GetRadius(); } },
    { "Height", { 0.0, -1.0, -1e-300, inf, -inf, nan }, [&](double v) { medium->SetHeight(v); },
      [&] { return medium->GetHeight(); } },
    { "ScaleHeight", { 0.0, -1.0, inf, -inf, nan }, [&](double v) { medium->SetScaleHeight(v); },
      [&] { return medium->GetScaleHeight(); } },
    { "ReferenceHeight", { inf, -inf, nan }, [&](double v) { medium->SetReferenceHeight(v); },
      [&] { return medium->GetReferenceHeight(); } } };
  for (const Property& property : properties)
  {
    const std::string name = property.Name;
    CheckTaken(medium, name + " 3.25", [&] { property.Set(3.25); });
    for (const double bad : property.Bad)
    {
      CheckRefused(medium, Text(name, " ", bad), { Text(name, " ", bad), "it stays 3.25" },
        [&] { property.Set(bad); });
      Check(property.Get() == 3.25, Text(name, " ", bad, " leaves the old value"));
    }
  }
}

//------------------------------------------------------------------------------
void TestCenter(vtkParticipatingMedium* medium)
{
  const Vector good = { 1.0, -2.0, most };
  CheckTaken(medium, "Center " + Describe(good), [&] { medium->SetCenter(good.data()); });
  for (int i = 0; i < 3; ++i)
  {
    for (const double bad : { inf, -inf, nan })
    {
      Vector center = good;
      center[i] = bad;
      CheckRefused(medium, "Center " + Describe(center), { "Center (", Text(bad) },
        [&] { medium->SetCenter(center.data()); });
      const double* stays = medium->GetCenter();
      Check(Vector{ stays[0], stays[1], stays[2] } == good, "Center stays");
    }
  }
}

//------------------------------------------------------------------------------
// A direction's length is taken out of it, however large or small, to within roundings.
template <typename Set, typename Get>
void TestDirection(
  vtkParticipatingMedium* medium, const std::string& name, const Set& set, const Get& get)
{
  const double third = 1.0 / std::sqrt(3.0);
  const std::pair<Vector, Vector> directions[] = { { { 0, 2, 0 }, { 0, 1, 0 } },
    { { most, most, most }, { third, third, third } },
    { { -most, most, -most }, { -third, third, -third } }, { { 0, 0, least }, { 0, 0, 1 } },
    { { least, least, least }, { third, third, third } }, { { most, least, 0 }, { 1, 0, 0 } },
    { { 3e-200, 0, 4e-200 }, { 0.6, 0, 0.8 } } };
  for (const auto& [given, expected] : directions)
  {
    set(given.data());
    const double* v = get();
    for (int i = 0; i < 3; ++i)
    {
      Check(std::abs(v[i] - expected[i]) <= 1e-15,
        Text(name, " ", Describe(given), " points to ", Describe({ v[0], v[1], v[2] })));
    }
  }
  const Vector good = { 0.0, 1.0, 0.0 };
  set(good.data());
  for (const Vector& bad : { Vector{ 0, 0, 0 }, Vector{ inf, 0, 0 }, Vector{ 0, -inf, 1 },
         Vector{ 1, 1, nan }, Vector{ nan, inf, 0 } })
  {
    CheckRefused(medium, name + " " + Describe(bad), { name + " " + Describe(bad), "direction" },
      [&] { set(bad.data()); });
    const double* stays = get();
    Check(Vector{ stays[0], stays[1], stays[2] } == good, name + " stays");
  }
}
}

//------------------------------------------------------------------------------
int TestMediumErrors(int, char*[])
{
  vtkNew<vtkParticipatingMedium> medium;
  TestNumbers(medium);
  TestCenter(medium);
  TestDirection(
    medium, "Up", [&](const double* v) { medium->SetUp(v); }, [&] { return medium->GetUp(); });
  TestDirection(
    medium, "Axis", [&](const double* v) { medium->SetAxis(v); },
    [&] { return medium->GetAxis(); });
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
