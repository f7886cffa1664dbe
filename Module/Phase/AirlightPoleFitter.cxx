// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightPoleFitter.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
PoleFitter::PoleFitter(
  const PhaseFunction& function, const std::vector<double>& samples, int fixedTerms)
  : SquaredTangent(samples.size())
  , Phase(samples.size())
  , FixedTerms(fixedTerms)
{
  for (size_t i = 0; i < samples.size(); ++i)
  {
    this->SquaredTangent[i] = samples[i] * samples[i];
    this->Phase[i] = function(samples[i]);
  }
}

//------------------------------------------------------------------------------
Eigen::MatrixXd PoleFitter::Columns(const Eigen::VectorXd& logB) const
{
  Eigen::MatrixXd columns(this->Phase.size(), logB.size() + this->FixedTerms);
  const Eigen::ArrayXd v = this->SquaredTangent.array();
  for (int k = 0; k < logB.size(); ++k)
  {
    columns.col(k) = (1.0 + v) / (v + std::exp(2.0 * logB[k])) / this->Phase.array();
  }
  for (int m = 1; m <= this->FixedTerms; ++m)
  {
    columns.col(logB.size() + m - 1) = (1.0 + v).pow(1 - m) / this->Phase.array();
  }
  return columns;
}

//------------------------------------------------------------------------------
Eigen::VectorXd PoleFitter::Error(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const
{
  return this->Columns(logB) * c - Eigen::VectorXd::Ones(this->Phase.size());
}

//------------------------------------------------------------------------------
double PoleFitter::Cancellation(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const
{
  return (this->Columns(logB).cwiseAbs() * c.cwiseAbs()).maxCoeff();
}

//------------------------------------------------------------------------------
Eigen::MatrixXd PoleFitter::PoleDerivatives(
  const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const
{
  Eigen::MatrixXd columns = this->Columns(logB).leftCols(logB.size());
  for (int k = 0; k < logB.size(); ++k)
  {
    const double b2 = std::exp(2.0 * logB[k]);
    columns.col(k).array() *= -2.0 * b2 * c[k] / (this->SquaredTangent.array() + b2);
  }
  return columns;
}

//------------------------------------------------------------------------------
Eigen::VectorXd SolveWeights(
  const Eigen::MatrixXd& columns, const Eigen::VectorXd& sampleWeights, double penalty)
{
  const Eigen::Index rows = columns.rows();
  const Eigen::Index m = columns.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows + m, m);
  matrix.topRows(rows) = sampleWeights.asDiagonal() * columns;
  matrix.bottomRows(m).diagonal() = penalty * columns.colwise().norm();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(rows + m);
  right.head(rows) = sampleWeights;
  return matrix.colPivHouseholderQr().solve(right);
}

//------------------------------------------------------------------------------
void Refine(const PoleFitter& fitter, const Eigen::VectorXd& sampleWeights, double penalty,
  int iterations, Eigen::VectorXd& logB, Eigen::VectorXd& c)
{
  const int n = static_cast<int>(logB.size());
  const int m = static_cast<int>(c.size());
  const int samples = fitter.GetSampleCount();
  double damping = 1e-3;
  // The errors, then the penalties of the terms.
  const auto evaluate = [&](const Eigen::VectorXd& atLogB, const Eigen::VectorXd& atC) {
    const Eigen::MatrixXd columns = fitter.Columns(atLogB);
    Eigen::VectorXd values(samples + m);
    values.head(samples) =
      sampleWeights.cwiseProduct(columns * atC - Eigen::VectorXd::Ones(samples));
    values.tail(m) = penalty * columns.colwise().norm().transpose().cwiseProduct(atC);
    return values;
  };
  Eigen::VectorXd residual = evaluate(logB, c);
  for (int iteration = 0; iteration < iterations && damping < 1e10; ++iteration)
  {
    Eigen::MatrixXd jacobian(residual.size() + m + n, m + n);
    jacobian.setZero();
    const Eigen::MatrixXd columns = fitter.Columns(logB);
    jacobian.topLeftCorner(samples, m) = sampleWeights.asDiagonal() * columns;
    jacobian.topRightCorner(samples, n) =
      sampleWeights.asDiagonal() * fitter.PoleDerivatives(logB, c);
    jacobian.block(samples, 0, m, m).diagonal() = penalty * columns.colwise().norm();
    const Eigen::VectorXd scale = jacobian.colwise().norm();
    jacobian.bottomRows(m + n) = (std::sqrt(damping) * scale).asDiagonal();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(jacobian.rows());
    right.head(residual.size()) = -residual;
    const Eigen::VectorXd step = jacobian.colPivHouseholderQr().solve(right);

    const Eigen::VectorXd newLogB = logB + step.tail(n);
    const Eigen::VectorXd newC = c + step.head(m);
    const Eigen::VectorXd newResidual = evaluate(newLogB, newC);
    if (newResidual.allFinite() && newResidual.squaredNorm() < residual.squaredNorm())
    {
      logB = newLogB;
      c = newC;
      residual = newResidual;
      damping = std::max(damping * 0.2, 1e-12);
    }
    else
    {
      damping *= 8.0;
    }
  }
}

//------------------------------------------------------------------------------
void Equalise(const PoleFitter& fitter, double penalty, Eigen::VectorXd& logB, Eigen::VectorXd& c)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(fitter.GetSampleCount());
  Eigen::VectorXd bestLogB = logB;
  Eigen::VectorXd bestC = c;
  double best = fitter.Error(logB, c).cwiseAbs().maxCoeff();
  for (int round = 0; round < 24; ++round)
  {
    const Eigen::ArrayXd error = fitter.Error(logB, c).cwiseAbs().array();
    weights.array() *= (error / error.maxCoeff() + 0.02).sqrt();
    weights /= weights.maxCoeff();
    Refine(fitter, weights, penalty, 6, logB, c);
    const double largest = fitter.Error(logB, c).cwiseAbs().maxCoeff();
    if (largest < best)
    {
      best = largest;
      bestLogB = logB;
      bestC = c;
    }
  }
  logB = bestLogB;
  c = bestC;
}
}
