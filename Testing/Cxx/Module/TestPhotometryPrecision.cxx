// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Intensities of photometric files in single precision, as shaders have it, against double.

#include "AirlightTestPhotometry.h"

#include <cstdlib>

using namespace airlight;
using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// The steepest slope of the packed table, 1/radian, along both angles.
glm::dvec2 SteepestSlopes(const std::vector<glm::dvec4>& texels)
{
  const int rows = static_cast<int>(texels[0].x);
  const int columns = static_cast<int>(texels[0].y);
  glm::dvec2 slopes(0.0);
  for (int j = 0; j < columns; ++j)
  {
    for (int i = 0; i < rows; ++i)
    {
      const glm::dvec4 cell = texels[1 + rows + columns + j * rows + i];
      const double v = std::max(std::abs(cell.y - cell.x), std::abs(cell.w - cell.z));
      const double h = std::max(std::abs(cell.z - cell.x), std::abs(cell.w - cell.y));
      slopes = glm::max(slopes, glm::dvec2(v * texels[1 + i].z, h * texels[1 + rows + j].z));
    }
  }
  return slopes;
}

bool TestSinglePrecision()
{
  Comparison comparison("single against double precision, absolute in relative intensities");
  Random random(5);
  for (int i = 0; i < 20 * TableKinds; ++i)
  {
    const LampTable table = RandomTable(random, i % TableKinds);
    const auto photometry = ParseOrTell(table);
    if (!photometry)
    {
      return false;
    }
    const glm::dvec2 slopes = SteepestSlopes(photometry->Pack());
    glm::dvec3 axis;
    glm::dvec3 up;
    RandomFrame(random, axis, up);
    TestLamp lamp(*photometry, axis, up);
    lamp.In64.axis = lamp.In32.axis; // the rounded frame for both
    lamp.In64.up = lamp.In32.up;
    for (int k = 0; k < 100; ++k)
    {
      glm::dvec3 other;
      glm::dvec3 direction;
      RandomFrame(random, direction, other);
      const glm::vec3 rounded(k % 2 == 0 ? direction : -direction);
      const glm::dvec3 exact(rounded);
      const glm::dvec2 angles =
        f64::airlightPhotometryAngles(lamp.In64, table.Type, exact) / Degree;
      // Angles are good to 1e-6, those about an axis to 1e-6 by the distance from it.
      const double pole = table.Type == 1
        ? std::sin(angles.x * Degree)
        : std::cos((table.Type == 2 ? angles.y : angles.x) * Degree);
      const glm::dvec2 about =
        table.Type == 2 ? glm::dvec2(1e-6 / pole, 1e-6) : glm::dvec2(1e-6, 1e-6 / pole);
      const double limit = glm::dot(slopes, about) + 1e-6;
      const double value = f32::airlightPhotometry(lamp.In32, rounded);
      comparison.Add(std::abs(value - lamp.Look(exact)), limit, [&] {
        return Text("table ", i, ", type ", table.Type, ", v ", angles.x, ", h ", angles.y, ": ",
          value, ", double ", lamp.Look(exact));
      });
    }
  }
  return comparison.Report();
}
}

//------------------------------------------------------------------------------
int TestPhotometryPrecision(int, char*[])
{
  return TestSinglePrecision() ? EXIT_SUCCESS : EXIT_FAILURE;
}
