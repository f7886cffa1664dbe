// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Edges of many triangles: a triangle that is there five times, and a single one beside it on a common
// edge. Rays that leave the fivefold shadow through the common edge are still in the single one. There
// shadow planes have to count as many shadows as they did where the rays entered.

#include "AirlightCompareScene.h"

#include <cstdlib>

using namespace airlighttest;

//------------------------------------------------------------------------------
int TestHeavyEdges(int, char*[])
{
  const glm::dvec3 a(-3.0, 1.0, 0.0);
  const glm::dvec3 b(3.0, 1.0, 0.0);
  Scene scene;
  std::vector<Triangle> triangles(5, { a, b, { 0.0, 1.0, 3.0 } });
  triangles.push_back({ b, a, { 0.0, 1.0, -3.0 } });
  scene.Add(MakeSoup(triangles));
  scene.AddPointLight({ 0.0, 4.0, 0.0 });
  CompareScene("five triangles in one beside a single one", scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
