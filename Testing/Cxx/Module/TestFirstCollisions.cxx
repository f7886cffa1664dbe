// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the light of beams and of lamps outside a medium first changes direction: against formulas
// and a simulation.

#include "AirlightTestExpect.h"
#include "Medium/AirlightConvert.h"
#include "MultipleScattering/AirlightFirstCollisions.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cmath>
#include <cstdlib>
#include <random>

using namespace airlight;
using namespace airlight_test;

namespace
{
f64::AirlightLight MakeLamp(const glm::dvec3& position)
{
  f64::AirlightLight light{};
  light.kind = AIRLIGHT_POINT_QUADRATURE;
  light.position = position;
  light.intensity = glm::dvec3(2.0, 1.0, 0.5);
  light.attenuation = glm::dvec3(0.0, 0.0, 1.0);
  light.axis = glm::dvec3(0.0, 0.0, 1.0);
  light.cosCone = -1.0;
  return light;
}

f64::AirlightMedium MakeMedium(int region)
{
  f64::AirlightMedium medium{};
  medium.sigmaS = glm::dvec3(0.45);
  medium.sigmaT = glm::dvec3(0.5);
  medium.region.kind = region;
  medium.region.boxMin = glm::dvec3(-2.0, -1.0, -3.0);
  medium.region.boxMax = glm::dvec3(1.0, 1.0, 2.0);
  medium.region.centre = glm::dvec3(1.0, 0.5, 0.0);
  medium.region.radius = 2.0;
  medium.region.axis = glm::dvec3(0.0, 1.0, 0.0);
  medium.region.halfHeight = 1.5;
  return medium;
}

// A beam's power, its mean place and where its halves stand.
void CheckBeam()
{
  f64::AirlightLight light = MakeLamp(glm::dvec3(1.0, 2.0, 3.0));
  const f64::AirlightMedium medium = MakeMedium(AIRLIGHT_REGION_UNBOUNDED);
  for (const double g : { 0.0, 0.5 })
  {
    for (const double exponent : { 0.0, 7.0 })
    {
      light.cosCone = std::cos(vtkMath::RadiansFromDegrees(25.0));
      light.exponent = exponent;
      const auto groups = FindFirstCollisions(medium, light, g);
      const double power = 2.0 * vtkMath::Pi() * 2.0 * 0.9 *
        (1.0 - std::pow(light.cosCone, exponent + 1.0)) / (exponent + 1.0);
      const double found = groups[0].Power.x + groups[1].Power.x;
      Expect(std::abs(found / power - 1.0) < 1e-4, "the beam's power", exponent, found, power);
      const double mean = (groups[0].Power.x * (groups[0].Position.z - 3.0) +
                            groups[1].Power.x * (groups[1].Position.z - 3.0)) /
        found;
      const double cosines = (1.0 - std::pow(light.cosCone, exponent + 2.0)) / (exponent + 2.0) /
        (1.0 - std::pow(light.cosCone, exponent + 1.0)) * (exponent + 1.0);
      const double expected = cosines / (0.5 - g * 0.45);
      Expect(std::abs(mean / expected - 1.0) < 1e-3, "the mean way", g, mean, expected);
      Expect(groups[0].Position.z < groups[1].Position.z &&
          std::abs(groups[0].Position.x - 1.0) < 0.02 * mean &&
          std::abs(groups[0].Power.x / found - 0.85355) < 1e-3,
        "one group near, one far", groups[0].Position.z, groups[1].Position.z);
      Expect(groups[0].Radius > 0.2 * mean && groups[0].Radius < mean, "the near group's radius",
        groups[0].Radius);
    }
  }
}

// By light that is followed at random: power and place of what a region catches.
void CheckRegions()
{
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const int region : { AIRLIGHT_REGION_BOX, AIRLIGHT_REGION_SPHERE, AIRLIGHT_REGION_CYLINDER })
  {
    const f64::AirlightMedium medium = MakeMedium(region);
    for (const glm::dvec3& position : { glm::dvec3(4.0, 1.0, 0.5), glm::dvec3(0.5, -5.0, 3.0) })
    {
      f64::AirlightLight light = MakeLamp(position);
      for (const bool spot : { false, true })
      {
        light.axis = glm::normalize(-position);
        light.cosCone = spot ? 0.97 : -1.0;
        double caught = 0.0;
        glm::dvec3 place(0.0);
        constexpr int count = 400000;
        for (int i = 0; i < count; ++i)
        {
          glm::dvec3 direction;
          do
          {
            direction = glm::dvec3(uniform(random), uniform(random), uniform(random));
          } while (glm::length(direction) > 1.0 || glm::length(direction) < 1e-3);
          direction = glm::normalize(direction);
          const glm::dvec2 range =
            f64::airlightRegionRange(medium.region, position, direction, AIRLIGHT_FAR);
          const double way = range.x - std::log(0.5 + 0.5 * uniform(random)) / 0.5;
          if (range.y > range.x && way < range.y &&
            (!spot || glm::dot(direction, light.axis) > light.cosCone))
          {
            caught += 1.0;
            place += position + way * direction;
          }
        }
        const auto groups = FindFirstCollisions(medium, light, 0.0);
        const double power = caught / count * 4.0 * vtkMath::Pi() * 2.0 * 0.9;
        const double found = groups[0].Power.x + groups[1].Power.x;
        Expect(std::abs(found / power - 1.0) < 0.03, "the power that a region catches", region,
          position.x, spot, found, power);
        const glm::dvec3 mean =
          (groups[0].Power.x * groups[0].Position + groups[1].Power.x * groups[1].Position) / found;
        Expect(glm::distance(mean, place / caught) < 0.05, "and its place", region, position.x,
          spot, glm::distance(mean, place / caught));
        Expect(std::abs(groups[0].Power.x / groups[0].Power.y - 2.0) < 1e-12, "its colour");
      }
    }
  }
}

void CheckLimits()
{
  f64::AirlightMedium medium = MakeMedium(AIRLIGHT_REGION_BOX);
  f64::AirlightLight light = MakeLamp(glm::dvec3(1e9, 0.0, 0.0));
  const auto far = FindFirstCollisions(medium, light, 0.0);
  Expect(far[0].Power.x > 0.0 && far[0].Power.x < 1e-15 && std::abs(far[0].Position.x) < 3.0,
    "a lamp far away", far[0].Power.x, far[0].Position.x);
  light.axis = glm::dvec3(1.0, 0.0, 0.0);
  light.cosCone = 0.9;
  Expect(FindFirstCollisions(medium, light, 0.0)[0].Power.x == 0.0, "a spot that looks away");
  medium.sigmaS = medium.sigmaT = glm::dvec3(0.0);
  Expect(FindFirstCollisions(medium, light, 0.0)[0].Power.x == 0.0, "a clear medium");
}
}

int TestFirstCollisions(int, char*[])
{
  CheckBeam();
  CheckRegions();
  CheckLimits();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
