// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass for every kind of light in every kind of region, density and phase function, in
// perspective and parallel projection, with and without a plane that ends rays. Lights at a place
// are inside the region here.

#include "AirlightTestPassMatrix.h"

#include <cstdlib>

using namespace airlight_test;

int TestAirlightPassMatrix(int, char*[])
{
  PassMatrixComparisons comparisons;
  PassMatrix experiment;
  ForEachCell([&](const MatrixCell& cell) {
    for (int i = 0; i < 4; ++i)
    {
      experiment.Run(cell, i % 2 == 1, i / 2 == 1, true, comparisons);
    }
  });
  return comparisons.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
