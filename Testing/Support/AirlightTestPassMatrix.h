// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pass in all cells of AirlightTestMatrix.h (AirlightTestPassCells.h), a quarter of them at a time.
 */

#ifndef AirlightTestPassMatrix_h
#define AirlightTestPassMatrix_h

#include "AirlightTestPassCells.h"

#include <cstdlib>

namespace airlight_test
{
// Every fourth phase function from the `part`-th on, from 0: shaders of all of them take compilers long.
// For every kind of light in every kind of region and density, with and without a plane that ends
// rays; in uniform media of boxes, spheres and everywhere both in perspective and in parallel
// projection, in others in one of them by turns. Then lights outside of boxes, spheres and surfaces,
// with phase functions and projections by turns, and the other tables, whose fits have other poles.
inline int RunPassMatrix(int part)
{
  constexpr int parts = 4;
  PassMatrixComparisons comparisons;
  PassMatrix experiment;
  ForEachCell([&](const MatrixCell& cell) {
    const bool both = cell.Density == vtkParticipatingMedium::UNIFORM &&
      cell.Region != vtkParticipatingMedium::SURFACE;
    const int turn = cell.Phase + cell.Light + cell.Region;
    for (int parallel = 0; parallel < 2; ++parallel)
    {
      if (cell.Phase % parts == part && (both || parallel == turn % 2))
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
    if (cell.Phase % parts == part)
    {
      outside.Run(cell, i / 6 % 2 == 1, i / 2 % 2 == 1, false, comparisons);
    }
  }
  for (int table = TABLE_SMOOTH + 1; table < TEST_TABLES; ++table)
  {
    for (int light = 0; light < MATRIX_LIGHTS && table % parts == part; ++light)
    {
      const MatrixCell cell{ light, vtkParticipatingMedium::UNBOUNDED,
        vtkParticipatingMedium::UNIFORM, MATRIX_TABLE + table };
      experiment.Run(cell, light % 2 == 1, table % 2 == 1, true, comparisons);
    }
  }
  return comparisons.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

#endif
