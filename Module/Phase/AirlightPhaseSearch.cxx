// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightPhaseSearch.h"

#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// A margin for what lies between the samples of the check: an extremum of the error rises above
// its nearest sample by far less than this.
constexpr double CheckMargin = 1.002;

double Bound(const PoleFitter& check, const Eigen::VectorXd& logB, const Eigen::VectorXd& c)
{
  return CheckMargin * check.Error(logB, c).cwiseAbs().maxCoeff();
}

}

//------------------------------------------------------------------------------
PhaseFit MakeFit(const PoleFitter& check, const Eigen::VectorXd& logB, const Eigen::VectorXd& c)
{
  PhaseFit fit;
  for (int k = 0; k < logB.size(); ++k)
  {
    fit.Poles.push_back({ std::exp(logB[k]), { c[k], 0.0, 0.0 } });
  }
  if (c.size() > logB.size())
  {
    PhasePole pole;
    for (int i = 0; i < c.size() - logB.size(); ++i)
    {
      pole.c[i] = c[logB.size() + i];
    }
    fit.Poles.push_back(pole);
  }
  const double bound = Bound(check, logB, c);
  fit.ErrorBound = std::isfinite(bound) ? bound : std::numeric_limits<double>::infinity();
  return fit;
}

//------------------------------------------------------------------------------
PhaseFit Measure(const PoleFitter& check, const PhaseFit& fit)
{
  const auto n = static_cast<Eigen::Index>(fit.Poles.size()) - 1;
  Eigen::VectorXd logB(n);
  Eigen::VectorXd c(n + 3);
  for (Eigen::Index k = 0; k < n; ++k)
  {
    logB[k] = std::log(fit.Poles[k].b);
    c[k] = fit.Poles[k].c[0];
  }
  c.tail(3) = Eigen::Map<const Eigen::Vector3d>(fit.Poles[n].c.data());
  return MakeFit(check, logB, c);
}

//------------------------------------------------------------------------------
PhaseSearch::PhaseSearch(const PoleFitter& fitter, const PoleFitter& check, double tolerance)
  : Fitter(fitter)
  , Check(check)
  , Tolerance(tolerance)
{
  for (PhaseFit& fit : this->Best)
  {
    fit.ErrorBound = std::numeric_limits<double>::infinity();
  }
}

//------------------------------------------------------------------------------
void PhaseSearch::Try(const Eigen::VectorXd& first)
{
  const Eigen::VectorXd even = Eigen::VectorXd::Ones(this->Fitter.GetSampleCount());
  double cancellation = std::numeric_limits<double>::infinity();
  for (double penalty = this->Tolerance / Cancellations.back();
       penalty < 0.1 && !(cancellation <= Cancellations[0]); penalty *= 10.0)
  {
    Eigen::VectorXd logB = first;
    Eigen::VectorXd c = SolveWeights(this->Fitter.Columns(logB), even, penalty);
    cancellation = this->Check.Cancellation(logB, c);
    // Poles that move come close to others and then cancel: they stay where they do well enough.
    if (logB.size() > 0 &&
      !(Bound(this->Check, logB, c) <= this->Tolerance && cancellation <= Cancellations[0]))
    {
      Refine(this->Fitter, even, penalty, 100, logB, c);
      Equalise(this->Fitter, penalty, logB, c);
      cancellation = this->Check.Cancellation(logB, c);
    }
    const PhaseFit fit = MakeFit(this->Check, logB, c);
    if (fit.ErrorBound > 4.0 * this->Best[0].ErrorBound)
    {
      return; // and a larger penalty will not make it better
    }
    for (size_t i = this->Best.size(); i-- > 0;)
    {
      // Of those within the tolerance the first one has the fewest poles.
      const bool enough = this->Best[i].ErrorBound <= this->Tolerance;
      // Something is better than nothing.
      const bool accepted = cancellation <= Cancellations[i] || this->Best.back().Poles.empty();
      if (accepted && !enough && fit.ErrorBound < this->Best[i].ErrorBound)
      {
        this->Best[i] = fit;
      }
    }
  }
}

//------------------------------------------------------------------------------
// Fits that cancel more have to be much better to be taken.
const PhaseFit& PhaseSearch::GetBest() const
{
  size_t best = 0;
  for (size_t i = 1; i < this->Best.size(); ++i)
  {
    const bool enough = this->Best[best].ErrorBound <= this->Tolerance;
    const bool within = this->Best[i].ErrorBound <= this->Tolerance;
    if (!enough && (within || this->Best[i].ErrorBound < 0.5 * this->Best[best].ErrorBound))
    {
      best = i;
    }
  }
  return this->Best[best];
}
}
