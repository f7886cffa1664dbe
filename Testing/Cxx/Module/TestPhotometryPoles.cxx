// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Airlight of lamps with photometric tables on rays that pass near a pole of the table, where the angle
// around it turns by half a circle on a short way: the shaders' functions in double and in single
// precision against quadrature.

#include "AirlightTestGoniometry.h"

#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"
#include "vtkNew.h"

#include <cstdlib>

using namespace airlight;
using namespace airlight_test;

namespace
{
constexpr double Intensity = 1000.0;

constexpr double Promised = 1e-3;   // of quadrature
constexpr double LastPlaces = 5e-6; // single precision's, of the angle around the pole far from it

template <typename Vector, typename Phase, typename Photometry, typename Media, typename Light>
void Fill(const TestFog& fog, const glm::dvec3& place, const Photometry& photometry, Media& media,
  Light& light)
{
  media.count = 1;
  media.item[0].sigmaS = Vector(fog.SigmaS);
  media.item[0].sigmaT = Vector(fog.SigmaT);
  vtkNew<vtkParticipatingMedium> isotropic;
  media.item[0].phase = GetPhase<Phase>(isotropic);
  media.item[0].region.kind = AIRLIGHT_REGION_UNBOUNDED;
  light.kind = AIRLIGHT_POINT_QUADRATURE;
  light.cosCone = -1;
  light.position = Vector(place);
  light.intensity = Vector(Intensity);
  light.attenuation = Vector(0, 0, 1);
  light.radius = 1e-5;
  light.goniometric = 1;
  light.photometry = photometry;
}

glm::dvec3 GetPole(int type, const glm::dvec3& axis, const glm::dvec3& up)
{
  return type == 1 ? axis : (type == 2 ? glm::cross(axis, up) : up);
}

// From the origin on.
double IntegrateDouble(
  const TestFog& fog, const glm::dvec3& place, const TestLamp& lamp, const glm::dvec3& direction)
{
  f64::AirlightMedia media{};
  f64::AirlightLight light{};
  Fill<glm::dvec3, f64::AirlightPhase>(fog, place, lamp.In64, media, light);
  const f64::AirlightRay ray =
    f64::airlightRay(media, light, glm::dvec3(0.0), direction, AIRLIGHT_FAR);
  return Intensity * f64::airlightQuadrature(media, light, ray, ray.lit.x, ray.lit.y).x;
}

double IntegrateSingle(
  const TestFog& fog, const glm::dvec3& place, const TestLamp& lamp, const glm::dvec3& direction)
{
  f32::AirlightMedia media{};
  f32::AirlightLight light{};
  Fill<glm::vec3, f32::AirlightPhase>(fog, place, lamp.In32, media, light);
  const f32::AirlightRay ray =
    f32::airlightRay(media, light, glm::vec3(0.0f), glm::vec3(direction), 1e18f);
  return Intensity * f32::airlightQuadrature(media, light, ray, ray.lit.x, ray.lit.y).x;
}

// How far a value is from all that it is between where the lamp is turned about its pole by an angle to
// either side: rays can run along the table's edge, beyond which it is dark.
double GetDistance(double value, double exact, const TestFog& fog, const TestGoniometricLamp& lamp,
  const glm::dvec3& direction, double angle)
{
  const glm::dvec3 pole = GetPole(lamp.Table.Type, lamp.Axis, lamp.Up);
  double low = exact;
  double high = exact;
  for (const double arc : { -angle, angle })
  {
    const auto rotate = [&](const glm::dvec3& v) { return v + arc * glm::cross(pole, v); };
    TestGoniometricLamp turned = lamp;
    turned.Aim(rotate(lamp.Axis), rotate(lamp.Up));
    const double there = GoniometricAirlight(fog, turned, glm::dvec3(0.0), direction, 0.0, 1e9, 0);
    low = std::min(low, there);
    high = std::max(high, there);
  }
  return std::max({ low - value, value - high, 0.0 });
}

// The place of a lamp whose pole the ray from the origin passes at a small angle.
glm::dvec3 PlaceLamp(
  const TestLamp& lamp, int type, const glm::dvec3& direction, double angle, Random& random)
{
  const glm::dvec3 pole = GetPole(type, lamp.In64.axis, lamp.In64.up);
  const double passage = random.Uniform(0.2, 3.0);
  const double distance = random.LogUniform(0.2, 5.0);
  const glm::dvec3 beside = glm::normalize(glm::cross(direction, pole));
  const glm::dvec3 towards = glm::normalize(pole + std::tan(angle) * beside);
  const double sign = random.Index(2) ? 1.0 : -1.0;
  return passage * direction - sign * distance * towards;
}

//------------------------------------------------------------------------------
bool TestTables(Random& random)
{
  Comparison inDouble("airlight, double precision, relative");
  Comparison inSingle("airlight, single precision, relative");
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
    expected.Intensity = glm::dvec3(Intensity);
    for (int k = 0; k < 25; ++k)
    {
      glm::dvec3 direction;
      glm::dvec3 other;
      RandomFrame(random, direction, other);
      direction = glm::dvec3(glm::vec3(direction));
      const double angle = random.LogUniform(1e-6, 0.3);
      const glm::dvec3 place(glm::vec3(PlaceLamp(lamp, table.Type, direction, angle, random)));
      expected.Position = place;
      TestFog fog;
      fog.SigmaS = glm::dvec3(random.LogUniform(0.02, 1.0));
      fog.SigmaT = 1.2 * fog.SigmaS;
      const glm::dvec3 d = glm::normalize(direction);
      const double exact = GoniometricAirlight(fog, expected, glm::dvec3(0.0), d, 0.0, 1e9, 0);
      // Where only the passage is lit, 1e-4 of what a lamp as bright in all directions would give:
      // panels end at 1e-4 of the widest.
      const double tL = glm::dot(place, d);
      const double whole = fog.SigmaS.x * Intensity *
        PointLightAirlight(
          HenyeyGreensteinPhase{ 0.0 }, fog.SigmaT.x, tL, glm::length(place - tL * d), 0.0, 1e9);
      const double size = std::max(exact, 0.1 * whole);
      const auto add = [&](Comparison& comparison, double value, double turned) {
        double error = std::abs(value - exact);
        if (error > Promised * size && turned > 0.0)
        {
          error = GetDistance(value, exact, fog, expected, d, turned);
        }
        comparison.Add(error / size, Promised, [&] {
          return Text("table ", i, " of type ", table.Type, ", ray ", k, ", ", angle,
            " from the pole: expected ", exact, ", got ", value);
        });
      };
      add(inDouble, IntegrateDouble(fog, place, lamp, d), 0.0);
      add(inSingle, IntegrateSingle(fog, place, lamp, direction), LastPlaces);
      bright += exact > 0.01 * whole;
    }
  }
  std::cout << bright << " bright rays\n";
  return AllOk({ &inDouble, &inSingle }) && bright > 1000;
}
}

//------------------------------------------------------------------------------
int TestPhotometryPoles(int, char*[])
{
  Random random(71);
  return TestTables(random) ? EXIT_SUCCESS : EXIT_FAILURE;
}
