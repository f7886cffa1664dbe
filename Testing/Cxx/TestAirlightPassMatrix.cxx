// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass for every kind of light in every kind of region, density and phase function, with and
// without a plane that ends rays; in uniform media of boxes, spheres and everywhere both in
// perspective and in parallel projection, in others in one of them by turns. Then lights outside of
// boxes, spheres and surfaces, with phase functions and projections by turns.

#include "AirlightTestPassMatrix.h"

#include <cstdlib>

using namespace airlight_test;

int TestAirlightPassMatrix(int, char*[])
{
  PassMatrixComparisons comparisons;
  PassMatrix experiment;
  ForEachCell([&](const MatrixCell& cell) {
    const bool both = cell.Density == vtkParticipatingMedium::UNIFORM &&
      cell.Region != vtkParticipatingMedium::SURFACE;
    const int turn = cell.Phase + cell.Light + cell.Region;
    for (int parallel = 0; parallel < 2; ++parallel)
    {
      if (both || parallel == turn % 2)
      {
        experiment.Run(cell, parallel == 1, (turn / 2 + parallel) % 2 == 1, true, comparisons);
      }
    }
  });
  PassMatrix outside;
  for (int i = 0; i < 60; ++i)
  {
    const MatrixCell cell{ i / 3 % MATRIX_LIGHTS, vtkParticipatingMedium::BOX + i % 3, i / 15 % 2,
      i * MATRIX_PHASES / 60 };
    outside.Run(cell, i / 6 % 2 == 1, i / 2 % 2 == 1, false, comparisons);
  }
  // The other tables, whose fits have other poles.
  for (int table = TABLE_SMOOTH + 1; table < TEST_TABLES; ++table)
  {
    for (int light = 0; light < MATRIX_LIGHTS; ++light)
    {
      const MatrixCell cell{ light, vtkParticipatingMedium::UNBOUNDED,
        vtkParticipatingMedium::UNIFORM, MATRIX_TABLE + table };
      experiment.Run(cell, light % 2 == 1, table % 2 == 1, true, comparisons);
    }
  }
  return comparisons.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
