// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightPhaseFit.h"

#include "Integration/AirlightMath.h"
#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseSearch.h"
#include "vtkMath.h"

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

std::vector<double> LogarithmicSamples(int count)
{
  std::vector<double> samples;
  for (int i = 0; i < count; ++i)
  {
    const double u = static_cast<double>(i) / (count - 1);
    samples.push_back(std::exp(FirstLogTangent + u * (LastLogTangent - FirstLogTangent)));
  }
  return samples;
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
  if (n > 0)
  {
    logB[0] = std::log(beta);
  }
  for (int k = 1; k < n; ++k)
  {
    const double u = period * (2 * k - 1) / (2 * n - 2);
    const double tangent = std::tan(JacobiAmplitude(u, modulus));
    const double c = tangent * tangent;
    logB[k] = 0.5 * std::log(beta * beta * (1.0 + c) / (1.0 + c * beta * beta));
  }
  return logB;
}

// A fit of simple poles alone, with given first ones.
PhaseFit FitPoles(const PoleFitter& fitter, const PoleFitter& check, Eigen::VectorXd logB)
{
  const Eigen::VectorXd even = Eigen::VectorXd::Ones(fitter.GetSampleCount());
  Eigen::VectorXd c = SolveWeights(fitter.Columns(logB), even, 0.0);
  Refine(fitter, even, 0.0, 100, logB, c);
  Equalise(fitter, 0.0, logB, c);
  return MakeFit(check, logB, c);
}
}

//------------------------------------------------------------------------------
// Backward scattering is the mirror image, s becomes 1/s: the simple pole b becomes 1/b and c
// becomes c/b^2; the polynomial c1 + c2 m + c3 m^2 in m = (1 + cos)/2 takes 1 - m.
PhaseFit Mirror(const PhaseFit& fit)
{
  PhaseFit result = fit;
  for (PhasePole& pole : result.Poles)
  {
    const std::array<double, 3> c = pole.c;
    if (pole.b == 1.0)
    {
      pole.c = { c[0] + c[1] + c[2], -c[1] - 2.0 * c[2], c[2] };
    }
    else
    {
      pole = { 1.0 / pole.b, { c[0] / (pole.b * pole.b), 0.0, 0.0 } };
    }
  }
  return result;
}

//------------------------------------------------------------------------------
f64::AirlightPhase Convert(const PhaseFit& fit)
{
  f64::AirlightPhase phase{};
  phase.poleCount = static_cast<int>(fit.Poles.size());
  phase.order = 1;
  for (int k = 0; k < phase.poleCount; ++k)
  {
    const PhasePole& pole = fit.Poles[k];
    phase.pole[k] = { pole.b, pole.c[0], pole.c[1], pole.c[2] };
    phase.order = std::max(phase.order, pole.c[2] != 0.0 ? 3 : pole.c[1] != 0.0 ? 2 : 1);
  }
  phase.power = { fit.Factor, fit.Exponent };
  return phase;
}

//------------------------------------------------------------------------------
bool HasClosedForm(const f64::AirlightPhase& phase)
{
  // Beyond this the differences of the poles' terms are too small for single precision, which gives
  // each of them to some 1e-6 near |z| = 1.
  constexpr double MostCancellation = 200.0;
  return phase.power.x == 0.0 && phase.rows == 0 &&
    f64::airlightPhaseCancellation(phase) < MostCancellation;
}

//------------------------------------------------------------------------------
PhaseFit ExactIsotropic() { return { { { 1.0, { 0.25 / vtkMath::Pi(), 0.0, 0.0 } } } }; }

//------------------------------------------------------------------------------
// With m = 1/(1 + s^2) = (1 + cos)/2: 1 + cos^2 = 2 - 4 m + 4 m^2.
PhaseFit ExactRayleigh()
{
  constexpr double f = 3.0 / (16.0 * vtkMath::Pi());
  return { { { 1.0, { 2.0 * f, -4.0 * f, 4.0 * f } } } };
}

//------------------------------------------------------------------------------
// 1 - k cos = (1 + k) (s^2 + b^2)/(1 + s^2) with b^2 = (1 - k)/(1 + k), so that
// p/(1 + s^2) = (1 - k^2)/(4 pi (1 + k)^2) (1 + s^2)/q^2, and 1 + s^2 = q + (1 - b^2).
PhaseFit ExactSchlick(double k)
{
  const double b2 = (1.0 - k) / (1.0 + k);
  const double f = b2 / (4.0 * vtkMath::Pi());
  return { { { std::sqrt(b2), { f, f * (1.0 - b2), 0.0 } } } };
}

//------------------------------------------------------------------------------
PhaseFit ExactMie(int n)
{
  PhaseFit fit{ { { 1.0, { 0.125 / vtkMath::Pi(), 0.0, 0.0 } } } };
  fit.Factor = 0.125 / vtkMath::Pi() * (n + 1);
  fit.Exponent = n;
  return fit;
}

//------------------------------------------------------------------------------
PhaseFit FitHenyeyGreenstein(double g, double tolerance, int maximumPoles)
{
  if (g == 0.0)
  {
    return ExactIsotropic();
  }
  const double forward = std::abs(g);
  const PhaseFunction function = [&](double s) { return HenyeyGreenstein(forward, s); };
  const PoleFitter fitter(function, LogarithmicSamples(FitSamples), 0);
  const PoleFitter check(function, LogarithmicSamples(CheckSamples), 0);
  PhaseFit best;
  best.ErrorBound = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= maximumPoles && best.ErrorBound > tolerance; ++n)
  {
    const PhaseFit fit =
      FitPoles(fitter, check, ZolotarevPoles((1.0 - forward) / (1.0 + forward), n));
    if (fit.ErrorBound < best.ErrorBound)
    {
      best = fit;
    }
  }
  return g > 0.0 ? best : Mirror(best);
}

//------------------------------------------------------------------------------
PhaseFit FitPeaked(const PhaseFunction& function, double g, double tolerance, int maximumPoles)
{
  const PoleFitter fitter(function, LogarithmicSamples(FitSamples), 3);
  const PoleFitter check(function, LogarithmicSamples(CheckSamples), 3);
  PhaseSearch search(fitter, check, tolerance);
  // Poles near the fixed one would cancel with it.
  const double apart = std::max(g, 0.3);
  for (int n = 0; n < maximumPoles && !search.IsDone(); ++n)
  {
    search.Try(ZolotarevPoles((1.0 - apart) / (1.0 + apart), n));
  }
  return search.GetBest();
}

//------------------------------------------------------------------------------
PhaseFit FitCornetteShanks(double g, double tolerance, int maximumPoles)
{
  if (g == 0.0)
  {
    return ExactRayleigh();
  }
  const double forward = std::abs(g);
  const PhaseFit fit = FitPeaked(
    [=](double s) { return CornetteShanks(forward, s); }, forward, tolerance, maximumPoles);
  return g > 0.0 ? fit : Mirror(fit);
}

//------------------------------------------------------------------------------
namespace
{
// So many samples to each row, and as many to each of 45 even steps: a table is flat beyond its
// ends.
std::vector<double> TableSamples(const PhaseTable& table, int perRow)
{
  std::vector<double> samples = { 1e-6, 1e6 };
  const std::vector<glm::dvec4>& rows = table.GetRows();
  const int even = 45 * perRow;
  for (int i = 1; i < even; ++i)
  {
    samples.push_back(std::tan(0.5 * vtkMath::Pi() * i / even));
  }
  for (size_t i = 1; i < rows.size(); ++i)
  {
    for (int j = 0; j < perRow; ++j)
    {
      samples.push_back(std::tan(0.5 * (rows[i - 1].x + (rows[i].x - rows[i - 1].x) * j / perRow)));
    }
  }
  return samples;
}

// Whether more poles will not bring the error to the tolerance either: if each gains a little more
// than the last two did on the average.
bool IsHopeless(const std::vector<double>& errors, double tolerance, int maximumPoles)
{
  const size_t n = errors.size();
  if (n < 4)
  {
    return false;
  }
  const double gain = 1.5 * std::sqrt(errors[n - 3] / errors[n - 1]);
  return errors[n - 1] > tolerance * std::pow(gain, maximumPoles - static_cast<double>(n));
}

// With ever more poles, as long as it helps.
void SearchEverywhere(PhaseSearch& search, double tolerance, int maximumPoles)
{
  // From even ratios between a narrow peak and a wide one, forward alone or backward, too.
  constexpr double ranges[3][2] = { { 0.03, 0.8 }, { 0.2, 3.0 }, { 0.03, 30.0 } };
  std::vector<double> errors;
  while (static_cast<int>(errors.size()) < maximumPoles && !search.IsDone() &&
    !IsHopeless(errors, tolerance, maximumPoles))
  {
    const auto n = static_cast<Eigen::Index>(errors.size());
    for (const auto& range : ranges)
    {
      search.Try(Eigen::VectorXd::LinSpaced(n, std::log(range[0]), std::log(range[1])));
    }
    errors.push_back(search.GetBest().ErrorBound);
  }
}
}

//------------------------------------------------------------------------------
PhaseFit FitTable(const PhaseTable& table, double tolerance, int maximumPoles)
{
  const PhaseFunction function = [&](double s) { return table.Evaluate(s); };
  const int rows = static_cast<int>(table.GetRows().size());
  const int perRow = std::clamp(240 / rows, 1, 4);
  const PoleFitter fitter(function, TableSamples(table, perRow), 3);
  const PoleFitter check(function, TableSamples(table, 4 * perRow), 3);
  PhaseSearch search(fitter, check, tolerance);
  SearchEverywhere(search, tolerance, maximumPoles);
  return Measure(PoleFitter(function, TableSamples(table, 32), 3), search.GetBest());
}

//------------------------------------------------------------------------------
PhaseFit FitFunction(const PhaseFunction& function, double tolerance, int maximumPoles)
{
  const PoleFitter fitter(function, LogarithmicSamples(FitSamples), 3);
  const PoleFitter check(function, LogarithmicSamples(CheckSamples), 3);
  PhaseSearch search(fitter, check, tolerance);
  SearchEverywhere(search, tolerance, maximumPoles);
  return search.GetBest();
}
}
