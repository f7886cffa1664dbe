// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The phase functions of vtkParticipatingMedium: their values against the documented formulas
// (AirlightTestPhase.h), their integrals over the sphere, their mean cosines, and the fits against
// the bounds that they claim. Bad input: TestPhaseErrors.cxx.

#include "AirlightTestErrors.h"
#include "AirlightTestPhase.h"
#include "Integration/AirlightMath.h"

#include "vtkNew.h"

#include <cstdlib>

using namespace airlight_test;
using Medium = vtkParticipatingMedium;

namespace
{
const std::vector<double> Anisotropies = { -0.99, -0.95, -0.9, -0.76, -0.6, -0.3, -0.01, 0.0, 0.01,
  0.3, 0.6, 0.76, 0.9, 0.95, 0.99 };

// Cosines in [-1, 1]: evenly spaced, and ever closer to both ends, where the functions are steep.
std::vector<double> DenseCosines()
{
  std::vector<double> cosines;
  for (int i = 0; i <= 20000; ++i)
  {
    cosines.push_back(std::min(-1.0 + 1e-4 * i, 1.0));
  }
  for (int i = 0; i <= 4000; ++i)
  {
    const double distance = std::pow(10.0, -12.0 * i / 4000);
    cosines.push_back(1.0 - distance);
    cosines.push_back(distance - 1.0);
  }
  return cosines;
}

struct Comparisons
{
  Comparison Value{ "value, relative" };
  Comparison Integral{ "integral over the sphere" };
  Comparison MeanCosine{ "mean cosine" };
  Comparison Bound{ "distance of the fit, of its bound" };
  Comparison Tolerance{ "bound, of the tolerance" };
  Comparison Exact{ "bound of what needs no fit" };
  Comparison Table{ "tables, relative" };
};

// 2 pi times the integral of p(mu) mu^power over [-1, 1]. The panels are graded towards both ends
// and cut where a table has its rows.
double IntegrateOverSphere(Medium* medium, int power)
{
  std::vector<long double> ends = { -1.0L, 0.0L, 1.0L };
  for (long double distance = 0.3L; distance > 1e-9L; distance *= 0.3L)
  {
    ends.push_back(1.0L - distance);
    ends.push_back(distance - 1.0L);
  }
  const ReferencePhase reference(medium);
  for (const long double angle : reference.GetKinks())
  {
    ends.push_back(std::cos(angle));
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  // Backward and forward apart: the integrand of each half has one sign.
  for (const double sign : { -1.0, 1.0 })
  {
    std::vector<long double> half;
    std::copy_if(ends.begin(), ends.end(), std::back_inserter(half),
      [sign](long double end) { return end * sign >= 0.0L; });
    sum += (power == 0 ? 1.0 : sign) *
      Integrate(
        [&](double mu) {
          return medium->EvaluatePhaseFunction(mu) * (power == 0 ? 1.0 : std::abs(mu));
        },
        half, 1e-13);
  }
  return 2.0 * Pi * sum;
}

//------------------------------------------------------------------------------
// What every function is held to. The formula is evaluated in extended precision.
void CompareFunction(Medium* medium, const std::string& name, Comparisons& comparisons)
{
  const ReferencePhase reference(medium);
  for (double mu = -1.0; mu <= 1.0; mu += 1.0 / 64.0)
  {
    for (const double cosine : { mu, std::copysign(1.0 - std::abs(mu) * 1e-5, mu) })
    {
      const long double expected = reference.Evaluate(1.0L - cosine, 1.0L + cosine);
      const long double value = medium->EvaluatePhaseFunction(cosine);
      comparisons.Value.Add(static_cast<double>(std::abs(value / expected - 1.0L)), 1e-12,
        [&] { return Text(name, ", cosine ", cosine, ": ", value, ", expected ", expected); });
    }
  }
  const double integral = IntegrateOverSphere(medium, 0);
  comparisons.Integral.Add(
    std::abs(integral - 1.0), 1e-9, [&] { return Text(name, ": ", integral); });
}

void CompareMeanCosine(
  Medium* medium, double expected, const std::string& name, Comparisons& comparisons)
{
  const double mean = IntegrateOverSphere(medium, 1);
  comparisons.MeanCosine.Add(std::abs(mean - expected), 1e-9,
    [&] { return Text(name, ": ", mean, ", expected ", expected); });
}

// The bound is honest: nowhere is the fit further from the function. Rounding is what poles that
// cancel make of 1e-16; an exact function has a bound of 0.
void CompareFit(Medium* medium, const std::string& name, Comparison& comparison)
{
  static const std::vector<double> cosines = DenseCosines();
  const auto fit = GetPhase<airlight::f64::AirlightPhase>(medium);
  const double bound = medium->GetPhaseErrorBound();
  for (const double mu : cosines)
  {
    const double value = medium->EvaluatePhaseFunction(mu);
    const double error = std::abs(FittedPhase(fit, 1.0 - mu, 1.0 + mu) / value - 1.0);
    comparison.Add(error, bound + 1e-13,
      [&] { return Text(name, ", ", DescribePhase(medium), ", cosine ", mu); });
  }
}

// Functions that the poles give as they are.
void CompareExact(Medium* medium, double mean, Comparisons& comparisons)
{
  const std::string name = DescribePhase(medium);
  CompareFunction(medium, name, comparisons);
  CompareMeanCosine(medium, mean, name, comparisons);
  CompareFit(medium, name, comparisons.Bound);
  comparisons.Exact.Add(medium->GetPhaseErrorBound(), 1e-300, [&] { return name; });
}

// Functions that are fitted. The tolerance is out of reach at extreme anisotropy, but the bound
// stays honest there.
void CompareFitted(Medium* medium, double mean, Comparisons& comparisons)
{
  const std::string name = DescribePhase(medium);
  CompareFunction(medium, name, comparisons);
  CompareMeanCosine(medium, mean, name, comparisons);
  int poles = 0;
  for (const double tolerance : { 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    medium->SetPhaseTolerance(tolerance);
    if (tolerance > 5e-5 && std::abs(medium->GetAnisotropy()) <= 0.95)
    {
      comparisons.Tolerance.Add(
        medium->GetPhaseErrorBound(), tolerance, [&] { return DescribePhase(medium); });
    }
    // Smaller tolerances take more poles, if anything, as long as they are in reach.
    if (medium->GetPhaseErrorBound() <= tolerance)
    {
      comparisons.Tolerance.Add(medium->GetNumberOfPhasePoles() < poles ? 1.0 : 0.0, 0.5,
        [&] { return DescribePhase(medium); });
    }
    poles = medium->GetNumberOfPhasePoles();
    CompareFit(medium, name, comparisons.Bound);
  }
  medium->SetPhaseTolerance(1e-3);
}

//------------------------------------------------------------------------------
// Mean cosine of Schlick's function: with y = 1 - k mu the integral of mu (1 - k^2)/(2 y^2) is
// 1/k - (1 - k^2)/(2 k^2) ln((1 + k)/(1 - k)), in powers of k 2 k/3 + 2 k^3/15 + 2 k^5/35 + ...
double SchlickMean(double g)
{
  const long double k = g;
  return static_cast<double>(std::abs(g) < 0.02
      ? k * (2.0L / 3.0L + k * k * (2.0L / 15.0L + k * k * 2.0L / 35.0L))
      : 1.0L / k - (1.0L - k * k) / (2.0L * k * k) * std::log((1.0L + k) / (1.0L - k)));
}

// Mean cosine of Cornette and Shanks' function: Henyey and Greenstein's has the Legendre moments
// g^n, so that its mean of mu (1 + mu^2) = (8 P1 + 2 P3)/5 is (8 g + 2 g^3)/5; times 3/2/(2 + g^2).
double CornetteShanksMean(double g) { return 0.6 * g * (4.0 + g * g) / (2.0 + g * g); }

// Mean cosine of 1/2 + (n + 1)/2 m^n over m = (1 + mu)/2 in [0, 1], mu = 2 m - 1:
// (n + 1)/2 (2/(n + 2) - 1/(n + 1)) = n/(2 n + 4).
double MieMean(int n) { return n / (2.0 * n + 4.0); }

void TestFormulas(Comparisons& comparisons)
{
  vtkNew<Medium> medium;
  CompareExact(medium, 0.0, comparisons);
  medium->SetPhaseFunctionToRayleigh();
  CompareExact(medium, 0.0, comparisons);
  medium->SetPhaseFunctionToMieHazy();
  CompareExact(medium, MieMean(8), comparisons);
  medium->SetPhaseFunctionToMieMurky();
  CompareExact(medium, MieMean(32), comparisons);
  for (const double g : Anisotropies)
  {
    medium->SetPhaseFunctionToHenyeyGreenstein();
    medium->SetAnisotropy(g);
    CompareFitted(medium, g, comparisons);
    medium->SetPhaseFunctionToCornetteShanks();
    CompareFitted(medium, CornetteShanksMean(g), comparisons);
    medium->SetPhaseFunctionToSchlick();
    CompareExact(medium, SchlickMean(g), comparisons);
  }
}

//------------------------------------------------------------------------------
// A table that poles do not follow within the tolerance is used as it is, without poles and without
// an error (TestAirlightPassMatrix holds the airlight against it).
void CompareTableFit(Medium* medium, const std::string& name, Comparisons& comparisons)
{
  comparisons.Tolerance.Add(
    medium->GetPhaseErrorBound(), medium->GetPhaseTolerance(), [&] { return name; });
  if (medium->GetNumberOfPhasePoles() > 0)
  {
    CompareFit(medium, name, comparisons.Bound);
  }
  else
  {
    comparisons.Exact.Add(medium->GetPhaseErrorBound(), 1e-300, [&] { return name; });
  }
}

void TestTables(Comparisons& comparisons)
{
  for (int kind = 0; kind < TEST_TABLES; ++kind)
  {
    const std::string name = TestTableName(kind);
    vtkNew<Medium> medium;
    ErrorListener warnings(medium, vtkCommand::WarningEvent);
    medium->SetPhaseTable(MakeTable(kind));
    medium->SetPhaseFunctionToTabulated();
    CompareFunction(medium, name, comparisons);
    CompareTableFit(medium, name, comparisons);
    comparisons.Tolerance.Add(warnings.Take(), 0.5, [&] { return name + ": a warning"; });
    std::cout << name << ": bound " << medium->GetPhaseErrorBound() << " with "
              << medium->GetNumberOfPhasePoles() << " poles\n";

    // At its rows it is the table, times the same number everywhere; and so is any multiple of it.
    vtkNew<Medium> scaled;
    ErrorListener scaledWarnings(scaled, vtkCommand::WarningEvent);
    scaled->SetPhaseTable(MakeTable(kind, 1000.0));
    scaled->SetPhaseFunctionToTabulated();
    vtkTable* table = medium->GetPhaseTable();
    const double factor =
      medium->EvaluatePhaseFunction(std::cos(table->GetValue(0, 0).ToDouble() * Pi / 180.0)) /
      table->GetValue(0, 1).ToDouble();
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const double degrees = table->GetValue(row, 0).ToDouble();
      const double mu = std::cos(degrees * Pi / 180.0);
      const double value = medium->EvaluatePhaseFunction(mu);
      const double expected = factor * table->GetValue(row, 1).ToDouble();
      const auto describe = [&] { return Text(name, ", row ", row, " at ", degrees); };
      comparisons.Table.Add(std::abs(value / expected - 1.0), 1e-12, describe);
      const double same = scaled->EvaluatePhaseFunction(mu);
      comparisons.Table.Add(std::abs(same / value - 1.0), 1e-12, describe);
    }
    CompareTableFit(scaled, name + " times 1000", comparisons);
  }
}
}

//------------------------------------------------------------------------------
int TestPhaseFunctions(int, char*[])
{
  Comparisons comparisons;
  TestFormulas(comparisons);
  TestTables(comparisons);
  return AllOk({ &comparisons.Value, &comparisons.Integral, &comparisons.MeanCosine,
           &comparisons.Bound, &comparisons.Tolerance, &comparisons.Exact, &comparisons.Table })
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
