// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Looks for fits whose fixed terms and poles do not cancel: single precision cannot sum terms that
 * are many times larger than their sum.
 */

#ifndef AirlightPhaseSearch_h
#define AirlightPhaseSearch_h

#include "Phase/AirlightPhaseFit.h"
#include "Phase/AirlightPoleFitter.h"

#include <array>

namespace airlight
{
// The fit of given poles and weights, with its bound from the samples of `check`.
PhaseFit MakeFit(const PoleFitter& check, const Eigen::VectorXd& logB, const Eigen::VectorXd& c);

// The same fit, whose last pole has the fixed terms, with its bound from the samples of `check`.
PhaseFit Measure(const PoleFitter& check, const PhaseFit& fit);

class PhaseSearch
{
public:
  PhaseSearch(const PoleFitter& fitter, const PoleFitter& check, double tolerance);

  // Fits from these first poles. The penalty on large terms rises until they cancel little.
  void Try(const Eigen::VectorXd& first);

  // Nothing better to be found: within the tolerance, and good for single precision.
  bool IsDone() const { return this->Best[0].ErrorBound <= this->Tolerance; }
  const PhaseFit& GetBest() const;

private:
  // How much larger the terms of the best fits may be than their sums: little; what the closed form
  // still takes in single precision; what quadrature takes (AirlightConvert.cxx).
  static constexpr std::array<double, 3> Cancellations = { 64.0, 180.0, 1800.0 };

  const PoleFitter& Fitter;
  const PoleFitter& Check;
  double Tolerance;
  std::array<PhaseFit, 3> Best;
};
}

#endif
