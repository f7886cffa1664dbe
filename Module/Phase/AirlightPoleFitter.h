// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Fits sums of poles to positive functions in the sense of the least largest relative error.
 */

#ifndef AirlightPoleFitter_h
#define AirlightPoleFitter_h

#include "Phase/AirlightPhaseFunctions.h"

#include <Eigen/Dense>

#include <vector>

namespace airlight
{
// The samples of a function and the terms of a fit. Beside the simple poles, which move, there may
// be fixed terms: the powers 1 to `fixedTerms` of the pole b = 1, polynomials in the cosine. The
// vector c of weights has the simple poles' first.
class PoleFitter
{
public:
  PoleFitter(const PhaseFunction& function, const std::vector<double>& samples, int fixedTerms);

  int GetSampleCount() const { return static_cast<int>(this->Phase.size()); }

  // Each term relative to the function: (1 + s^2)/(s^2 + b^2)/p, and (1 + s^2)^(1 - m)/p.
  Eigen::MatrixXd Columns(const Eigen::VectorXd& logB) const;

  // Relative error at each sample.
  Eigen::VectorXd Error(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const;

  // How much larger the terms are than their sum, at the worst sample.
  double Cancellation(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const;

  // Derivative of the error by log b_k: -2 b^2 c/(s^2 + b^2) times the pole's share.
  Eigen::MatrixXd PoleDerivatives(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const;

private:
  Eigen::VectorXd SquaredTangent;
  Eigen::VectorXd Phase;
  int FixedTerms;
};

// The penalty, 0 or above, is what a term of the function's own size adds to the errors: it keeps
// terms from growing large and cancelling, which single precision cannot sum.

// Weighted least squares for the weights c at given poles.
Eigen::VectorXd SolveWeights(
  const Eigen::MatrixXd& columns, const Eigen::VectorXd& sampleWeights, double penalty);

// Levenberg-Marquardt over poles and weights together, in the weighted 2-norm.
void Refine(const PoleFitter& fitter, const Eigen::VectorXd& sampleWeights, double penalty,
  int iterations, Eigen::VectorXd& logB, Eigen::VectorXd& c);

// Lawson's algorithm: samples of large error gain weight until the largest errors are alike.
void Equalise(const PoleFitter& fitter, double penalty, Eigen::VectorXd& logB, Eigen::VectorXd& c);
}

#endif
