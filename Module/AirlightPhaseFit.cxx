// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightPhaseFit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// Angles are sampled evenly in log s. Beyond these ends every phase function is flat.
constexpr double FirstLogTangent = -14.0;
constexpr double LastLogTangent = 14.0;
constexpr int FitSamples = 281;
constexpr int CheckSamples = 8401;

// The fit in progress: samples of the function and the trial poles.
class Fitter
{
public:
  Fitter(double g, int samples)
    : SquaredTangent(samples)
    , Phase(samples)
  {
    for (int i = 0; i < samples; ++i)
    {
      const double u = static_cast<double>(i) / (samples - 1);
      const double s = std::exp(FirstLogTangent + u * (LastLogTangent - FirstLogTangent));
      this->SquaredTangent[i] = s * s;
      this->Phase[i] = HenyeyGreenstein(g, s);
    }
  }

  // (1 + s^2)/(s^2 + b^2)/p: the pole's share relative to the function.
  Eigen::VectorXd Column(double b) const
  {
    return ((1.0 + this->SquaredTangent.array()) / (this->SquaredTangent.array() + b * b) /
      this->Phase.array())
      .matrix();
  }

  Eigen::MatrixXd Columns(const Eigen::VectorXd& logB) const
  {
    Eigen::MatrixXd columns(this->Phase.size(), logB.size());
    for (int k = 0; k < logB.size(); ++k)
    {
      columns.col(k) = this->Column(std::exp(logB[k]));
    }
    return columns;
  }

  // Relative error at each sample.
  Eigen::VectorXd Error(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const
  {
    return this->Columns(logB) * c - Eigen::VectorXd::Ones(this->Phase.size());
  }

  // Derivative of the error by log b_k: -2 b^2 c/(s^2 + b^2) times the pole's share.
  Eigen::MatrixXd PoleDerivatives(const Eigen::VectorXd& logB, const Eigen::VectorXd& c) const
  {
    Eigen::MatrixXd columns = this->Columns(logB);
    for (int k = 0; k < logB.size(); ++k)
    {
      const double b2 = std::exp(2.0 * logB[k]);
      columns.col(k).array() *= -2.0 * b2 * c[k] / (this->SquaredTangent.array() + b2);
    }
    return columns;
  }

private:
  Eigen::VectorXd SquaredTangent;
  Eigen::VectorXd Phase;
};

// Weighted least squares for the weights c at given poles.
Eigen::VectorXd SolveWeights(const Eigen::MatrixXd& columns, const Eigen::VectorXd& sampleWeights)
{
  return (sampleWeights.asDiagonal() * columns).colPivHouseholderQr().solve(sampleWeights);
}

// Levenberg-Marquardt over poles and weights together, in the weighted 2-norm.
void Refine(const Fitter& fitter, const Eigen::VectorXd& sampleWeights, int iterations,
  Eigen::VectorXd& logB, Eigen::VectorXd& c)
{
  const int n = static_cast<int>(logB.size());
  double damping = 1e-3;
  Eigen::VectorXd residual = sampleWeights.cwiseProduct(fitter.Error(logB, c));
  for (int iteration = 0; iteration < iterations && damping < 1e10; ++iteration)
  {
    Eigen::MatrixXd jacobian(residual.size() + 2 * n, 2 * n);
    jacobian.setZero();
    jacobian.topLeftCorner(residual.size(), n) = sampleWeights.asDiagonal() * fitter.Columns(logB);
    jacobian.topRightCorner(residual.size(), n) =
      sampleWeights.asDiagonal() * fitter.PoleDerivatives(logB, c);
    const Eigen::VectorXd scale = jacobian.colwise().norm();
    jacobian.bottomRows(2 * n) = (std::sqrt(damping) * scale).asDiagonal();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(jacobian.rows());
    right.head(residual.size()) = -residual;
    const Eigen::VectorXd step = jacobian.colPivHouseholderQr().solve(right);

    const Eigen::VectorXd newLogB = logB + step.tail(n);
    const Eigen::VectorXd newC = c + step.head(n);
    const Eigen::VectorXd newResidual = sampleWeights.cwiseProduct(fitter.Error(newLogB, newC));
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

// Lawson's algorithm: samples of large error gain weight until the largest errors are alike.
void Equalise(const Fitter& fitter, Eigen::VectorXd& logB, Eigen::VectorXd& c)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(FitSamples);
  Eigen::VectorXd bestLogB = logB;
  Eigen::VectorXd bestC = c;
  double best = fitter.Error(logB, c).cwiseAbs().maxCoeff();
  for (int round = 0; round < 24; ++round)
  {
    const Eigen::ArrayXd error = fitter.Error(logB, c).cwiseAbs().array();
    weights.array() *= (error / error.maxCoeff() + 0.02).sqrt();
    weights /= weights.maxCoeff();
    Refine(fitter, weights, 6, logB, c);
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

// Jacobi's amplitude am(u, k) by the arithmetic-geometric mean (Abramowitz and Stegun 16.4).
double JacobiAmplitude(double u, double k)
{
  constexpr int Most = 16;
  std::array<double, Most> a = { 1.0 };
  std::array<double, Most> c = { k };
  double b = std::sqrt(1.0 - k * k);
  int n = 0;
  for (; n < Most - 1 && std::abs(c[n]) > 1e-15; ++n)
  {
    a[n + 1] = 0.5 * (a[n] + b);
    c[n + 1] = 0.5 * (a[n] - b);
    b = std::sqrt(a[n] * b);
  }
  double phi = std::ldexp(a[n] * u, n);
  for (; n > 0; --n)
  {
    phi = 0.5 * (std::asin(c[n] * std::sin(phi) / a[n]) + phi);
  }
  return phi;
}

// Where to put the poles. In v = s^2 and with beta = (1 - g)/(1 + g), g >= 0, the function is
// proportional to sqrt((1 + v)/(v + beta^2))/(v + beta^2): one pole at beta, times a square root
// whose best rational approximations are Zolotarev's, with n - 1 more poles between beta and 1.
// They converge exponentially; the refinement starts from them.
Eigen::VectorXd ZolotarevPoles(double beta, int n)
{
  const double modulus = std::sqrt(1.0 - beta * beta);
  const double period = std::comp_ellint_1(modulus);
  Eigen::VectorXd logB(n);
  logB[0] = std::log(beta);
  for (int k = 1; k < n; ++k)
  {
    const double u = period * (2 * k - 1) / (2 * n - 2);
    const double tangent = std::tan(JacobiAmplitude(u, modulus));
    const double c = tangent * tangent;
    logB[k] = 0.5 * std::log(beta * beta * (1.0 + c) / (1.0 + c * beta * beta));
  }
  return logB;
}

// A margin for what lies between the samples of the check: an extremum of the error rises above
// its nearest sample by far less than this.
constexpr double CheckMargin = 1.002;

double Bound(const Fitter& check, const Eigen::VectorXd& logB, const Eigen::VectorXd& c)
{
  return CheckMargin * check.Error(logB, c).cwiseAbs().maxCoeff();
}
}

//------------------------------------------------------------------------------
double HenyeyGreenstein(double g, double s)
{
  // (1 - g^2)/(4 pi (1 + g^2 - 2 g cos)^(3/2)) with cos = (1 - s^2)/(1 + s^2).
  const double s2 = s * s;
  const double d = ((1.0 - g) * (1.0 - g) + (1.0 + g) * (1.0 + g) * s2) / (1.0 + s2);
  return (1.0 - g * g) / (4.0 * M_PI * d * std::sqrt(d));
}

//------------------------------------------------------------------------------
PhaseFit FitHenyeyGreenstein(double g, double tolerance, int maximumPoles)
{
  if (g == 0.0)
  {
    return { { { 1.0, 0.25 / M_PI } }, 0.0 };
  }
  const double forward = std::abs(g);
  const Fitter fitter(forward, FitSamples);
  const Fitter check(forward, CheckSamples);
  PhaseFit best;
  best.ErrorBound = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= maximumPoles && best.ErrorBound > tolerance; ++n)
  {
    const Eigen::VectorXd even = Eigen::VectorXd::Ones(FitSamples);
    Eigen::VectorXd logB = ZolotarevPoles((1.0 - forward) / (1.0 + forward), n);
    Eigen::VectorXd c = SolveWeights(fitter.Columns(logB), even);
    Refine(fitter, even, 100, logB, c);
    Equalise(fitter, logB, c);
    const double bound = Bound(check, logB, c);
    if (bound < best.ErrorBound)
    {
      best.ErrorBound = bound;
      best.Poles.resize(n);
      for (int k = 0; k < n; ++k)
      {
        const double b = std::exp(logB[k]);
        // Backward scattering is the mirror image: b becomes 1/b and c becomes c/b^2.
        best.Poles[k] = g > 0.0 ? PhasePole{ b, c[k] } : PhasePole{ 1.0 / b, c[k] / (b * b) };
      }
    }
  }
  return best;
}
}
