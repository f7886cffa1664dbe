// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The pass' Airlight and Transmittance in one cell of AirlightTestMatrix.h, against vtkAirlight on
 * the pixels' rays (which TestAirlightMatrix compares with quadrature).
 */

#ifndef AirlightTestPassMatrix_h
#define AirlightTestPassMatrix_h

#include "AirlightTestErrors.h"
#include "AirlightTestMatrix.h"
#include "AirlightTestPixelScene.h"

#include <array>
#include <vector>

namespace airlight_test
{
struct PassMatrixComparisons
{
  Comparison Closed{ "Airlight in closed form" };
  Comparison Quadrature{ "Airlight by quadrature" };
  Comparison Transmittance{ "Transmittance, absolute" };
  Comparison Finite{ "values, finite (0) or not (1)" };
  long Combinations = 0;
  long Rays = 0;
  long Grazing = 0;

  bool Report() const
  {
    const bool few = this->Combinations > 0 && this->Grazing < 0.03 * this->Rays;
    std::cout << (few ? "ok      " : "FAILED  ") << this->Combinations << " combinations, "
              << this->Grazing << " of " << this->Rays << " rays graze and are left out\n";
    return AllOk({ &this->Closed, &this->Quadrature, &this->Transmittance, &this->Finite }) && few;
  }
};

class PassMatrix
{
public:
  PassMatrix()
  {
    this->Scene.AddTiltedPlane();
    this->Scene.Medium->SetPhaseTolerance(1e-3);
  }

  void Run(const MatrixCell& cell, bool parallel, bool plane, bool lightInside,
    PassMatrixComparisons& comparisons);

private:
  using Colour = std::array<double, 3>;

  struct Expected
  {
    Colour Airlight;
    Colour Transmittance;
  };

  struct Sample
  {
    int I;
    int J;
    PixelRay Ray;
    double End;
    Expected Values;
  };

  void Place(const MatrixCell& cell, bool parallel, bool plane, bool lightInside);
  Expected Compute(const Sample& sample);
  bool Grazes(const Sample& sample);
  std::vector<Sample> TakeSamples();
  void Compare(
    const MatrixCell& cell, const Sample& sample, double floor, PassMatrixComparisons& comparisons);

  Random Numbers{ 73 };
  int Index = 0;
  bool Closed = false;
  PixelScene Scene;
  // The table's fit misses the tolerance; the twin takes the same fit.
  ErrorListener Warnings{ this->Scene.Medium, vtkCommand::WarningEvent };
};
}

#endif
