// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Airlight of lamps with photometric tables from cell to cell of the table
// (AirlightGoniometricArc.glsl), as the shaders' text compiled in double and in single precision,
// against quadrature by hand on parts of rays everywhere around the lamp, and near a pole of the
// table. Errors are parts of what a lamp as bright in all directions would give, as in the error
// contract of the documentation.

#include "AirlightTestGoniometry.h"

#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cstdlib>

using namespace airlight;
using namespace airlight_test;

namespace
{
struct Setting
{
  TestFog Fog;
  glm::dvec3 Direction;
  glm::dvec2 Part; // of the ray from the origin
};

template <typename Vector, typename Phase, typename Media, typename Light>
void Fill(const Setting& setting, const glm::dvec3& place, Media& media, Light& light)
{
  media.count = 1;
  media.item[0].sigmaS = Vector(setting.Fog.SigmaS);
  media.item[0].sigmaT = Vector(setting.Fog.SigmaT);
  vtkNew<vtkParticipatingMedium> isotropic;
  media.item[0].phase = GetPhase<Phase>(isotropic);
  media.item[0].region.kind = AIRLIGHT_REGION_UNBOUNDED;
  light.cosCone = -1;
  light.position = Vector(place);
  light.radius = 1e-5;
}

double IntegrateDouble(const Setting& setting, const glm::dvec3& place, const TestLamp& lamp)
{
  f64::AirlightMedia media{};
  f64::AirlightLight light{};
  Fill<glm::dvec3, f64::AirlightPhase>(setting, place, media, light);
  const f64::AirlightRay ray =
    f64::airlightRay(media, light, glm::dvec3(0.0), setting.Direction, AIRLIGHT_FAR);
  return setting.Fog.SigmaS.x *
    f64::airlightGoniometricQuadrature(
      media.item[0], lamp.In64, ray, setting.Part.x, setting.Part.y)
      .x /
    ray.foot.h;
}

double IntegrateSingle(const Setting& setting, const glm::dvec3& place, const TestLamp& lamp)
{
  f32::AirlightMedia media{};
  f32::AirlightLight light{};
  Fill<glm::vec3, f32::AirlightPhase>(setting, place, media, light);
  const f32::AirlightRay ray =
    f32::airlightRay(media, light, glm::vec3(0.0f), glm::vec3(setting.Direction), 1e18f);
  const glm::vec2 part(setting.Part);
  return setting.Fog.SigmaS.x *
    f32::airlightGoniometricQuadrature(media.item[0], lamp.In32, ray, part.x, part.y).x /
    ray.foot.h;
}

glm::dvec3 GetPole(int type, const glm::dvec3& axis, const glm::dvec3& up)
{
  return type == 1 ? axis : (type == 2 ? glm::cross(axis, up) : up);
}

// How far a value is from all that it is between where the lamp is turned about its pole a little
// to either side, and tilted: along a table's edge, beyond which it is dark, rays may run a
// rounding error away.
double GetDistance(
  double value, double exact, const Setting& setting, const TestGoniometricLamp& lamp)
{
  constexpr double Rounding = 2e-6;
  double low = exact;
  double high = exact;
  for (const glm::dvec3& axis : { lamp.Axis, lamp.Up, lamp.Right })
  {
    for (const double arc : { -Rounding, Rounding })
    {
      const auto rotate = [&](const glm::dvec3& v) { return v + arc * glm::cross(axis, v); };
      TestGoniometricLamp turned = lamp;
      turned.Aim(rotate(lamp.Axis), rotate(lamp.Up));
      const double there = GoniometricAirlight(setting.Fog, turned, glm::dvec3(0.0),
        glm::normalize(setting.Direction), setting.Part.x, setting.Part.y, 0);
      low = std::min(low, there);
      high = std::max(high, there);
    }
  }
  return std::max({ low - value, value - high, 0.0 });
}

// The lamp's place: anywhere, or such that the ray passes its pole at a small angle.
glm::dvec3 PlaceLamp(
  const TestGoniometricLamp& lamp, const glm::dvec3& direction, bool nearPole, Random& random)
{
  const double passage = random.Uniform(-1.0, 3.0);
  const double distance = random.LogUniform(0.05, 5.0);
  glm::dvec3 towards;
  glm::dvec3 other;
  RandomFrame(random, towards, other);
  if (nearPole)
  {
    const glm::dvec3 pole = GetPole(lamp.Table.Type, lamp.Axis, lamp.Up);
    const glm::dvec3 beside = glm::normalize(glm::cross(direction, pole));
    const double angle = random.LogUniform(1e-3, 0.3);
    towards = (random.Index(2) ? 1.0 : -1.0) * glm::normalize(pole + std::tan(angle) * beside);
  }
  return passage * direction - distance * towards;
}

//------------------------------------------------------------------------------
bool TestTables(Random& random)
{
  Comparison inDouble("airlight, double precision, of an even lamp's");
  Comparison inSingle("airlight, single precision, of an even lamp's");
  Comparison dim("airlight, single precision, of the lamp's own or a hundredth of an even lamp's");
  int bright = 0;
  for (int i = 0; i < 10 * TableKinds; ++i)
  {
    const LampTable table = RandomTable(random, i % TableKinds);
    const auto photometry = ParseOrTell(table);
    if (!photometry)
    {
      return false;
    }
    TestGoniometricLamp expected;
    expected.Table = table;
    RandomFrame(random, expected.Axis, expected.Up);
    TestLamp lamp(*photometry, expected.Axis, expected.Up);
    expected.Axis = lamp.In64.axis = glm::dvec3(lamp.In32.axis); // the rounded frame for all
    expected.Up = lamp.In64.up = glm::dvec3(lamp.In32.up);
    expected.Right = glm::cross(expected.Axis, expected.Up);
    expected.Intensity = glm::dvec3(1.0);
    for (int k = 0; k < 25; ++k)
    {
      Setting setting;
      glm::dvec3 other;
      RandomFrame(random, setting.Direction, other);
      setting.Direction = glm::dvec3(glm::vec3(setting.Direction));
      const glm::dvec3 place(glm::vec3(PlaceLamp(expected, setting.Direction, k % 3 == 0, random)));
      expected.Position = place;
      setting.Fog.SigmaS = glm::dvec3(random.LogUniform(0.02, 1.0));
      setting.Fog.SigmaT = 1.2 * setting.Fog.SigmaS;
      const double begin = random.Index(2) ? 0.0 : random.Uniform(0.0, 2.0);
      setting.Part = { begin, random.Index(3) == 0 ? 1e9 : begin + random.LogUniform(0.01, 10.0) };
      setting.Part = glm::dvec2(glm::vec2(setting.Part));
      const glm::dvec3 d = glm::normalize(setting.Direction);
      const double exact = GoniometricAirlight(
        setting.Fog, expected, glm::dvec3(0.0), d, setting.Part.x, setting.Part.y, 0);
      const double tL = glm::dot(place, d);
      const double even = setting.Fog.SigmaS.x *
        PointLightAirlight(HenyeyGreensteinPhase{ 0.0 }, setting.Fog.SigmaT.x, tL,
          glm::length(place - tL * d), setting.Part.x, setting.Part.y);
      const auto add = [&](Comparison& comparison, double size, double value, double limit) {
        double error = std::abs(value - exact);
        if (error > limit * size)
        {
          error = GetDistance(value, exact, setting, expected);
        }
        comparison.Add(error / size, limit, [&] {
          return Text("table ", i, " of type ", table.Type, ", ray ", k, ": expected ", exact,
            ", got ", value, ", of an even lamp ", even);
        });
      };
      add(inDouble, even, IntegrateDouble(setting, place, lamp), 5e-5);
      add(inSingle, even, IntegrateSingle(setting, place, lamp), 1e-4);
      add(dim, std::max(exact, 0.01 * even), IntegrateSingle(setting, place, lamp), 1e-4);
      bright += exact > 0.01 * even;
    }
  }
  std::cout << bright << " bright rays\n";
  return AllOk({ &inDouble, &inSingle, &dim }) && bright > 1000;
}
}

//------------------------------------------------------------------------------
int TestGoniometricArc(int, char*[])
{
  Random random(2903);
  return TestTables(random) ? EXIT_SUCCESS : EXIT_FAILURE;
}
