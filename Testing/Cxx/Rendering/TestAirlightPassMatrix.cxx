// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass for every kind of light in every kind of region, density and phase function: its
// Airlight and Transmittance in all cells of AirlightTestMatrix.h, against vtkAirlight on the
// pixels' rays (which TestAirlightMatrix compares with quadrature). The first argument says which
// quarter of the phase functions; with "all" as the second no cell is left out, which takes twice
// the time.

#include "AirlightTestPassMatrix.h"

#include <cstdlib>
#include <cstring>

using namespace airlight_test;

namespace
{
// Every fourth phase function from the `part`-th on, from 0: shaders of all of them take compilers
// long. For every kind of light, with and without a plane that ends rays; in uniform media of
// boxes, spheres and everywhere both in perspective and in parallel projection, in others in one of
// them alternately. Of phase function, region and density each pair occurs, and every second
// triple, or all of them. Then lights outside of boxes, spheres and surfaces, with alternating
// phase functions and projections, and the other tables, whose fits have other poles.
int RunPart(int part, bool all)
{
  constexpr int parts = 4;
  PassMatrixComparisons comparisons;
  PassMatrix experiment;
  ForEachCell([&](const MatrixCell& cell) {
    if (!all && (cell.Phase + cell.Region + cell.Density) % 2 != 0)
    {
      return;
    }
    const bool both = cell.Density == vtkParticipatingMedium::UNIFORM &&
      cell.Region != vtkParticipatingMedium::SURFACE;
    const int order = cell.Phase + cell.Light + cell.Region;
    for (int parallel = 0; parallel < 2; ++parallel)
    {
      if (cell.Phase % parts == part && (both || parallel == order % 2))
      {
        experiment.Run(cell, parallel == 1, (order / 2 + parallel) % 2 == 1, true, comparisons);
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

//------------------------------------------------------------------------------
int TestAirlightPassMatrix(int argc, char* argv[])
{
  const bool all = argc > 2 && std::strcmp(argv[2], "all") == 0;
  return argc > 1 ? RunPart(std::atoi(argv[1]), all) : EXIT_FAILURE;
}
