// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultipleScattering/AirlightSourceFit.h"

#include "MultipleScattering/AirlightLayeredSolution.h"
#include "MultipleScattering/AirlightUnboundedSolution.h"
#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace airlight
{
namespace
{
constexpr int Rows = AIRLIGHT_SOURCE_ROWS;
constexpr int Columns = AIRLIGHT_SOURCE_COLUMNS;
static_assert(Rows == 8 && Columns == 6, "as airlightSourceLogarithm() writes them out");

// What is so much darker than the brightest direction is of no account.
constexpr double Dark = 1e-2;

// The distance and the cosine that stand at x and y in [-1, 1]: the inverses of airlightSourceX()
// and airlightSourceY().
double GetDistance(double x)
{
  const auto root = [](double r) { return std::sqrt(r / (r + 4.0)); };
  const double low = root(AIRLIGHT_SOURCE_LEAST);
  const double share = low + 0.5 * (x + 1.0) * (root(AIRLIGHT_SOURCE_MOST) - low);
  return 4.0 * share * share / (1.0 - share * share);
}

double GetCosine(double y, double lobe)
{
  if (lobe < AIRLIGHT_SOURCE_SMALL_LOBE)
  {
    return y;
  }
  const double least = std::sqrt((1.0 - lobe) / (1.0 + lobe));
  const double root = least + 0.5 * (y + 1.0) * (1.0 - least);
  const double q = (1.0 - lobe) / (root * root);
  return std::clamp((1.0 + lobe * lobe - q * q) / (2.0 * lobe), -1.0, 1.0);
}

double GetNode(int i, int count) { return std::cos(vtkMath::Pi() * (i + 0.5) / count); }

// The coefficients of the Chebyshev polynomials through values at the nodes.
template <size_t Count>
std::array<double, Count> Interpolate(const std::array<double, Count>& values)
{
  std::array<double, Count> coefficients{};
  for (size_t j = 0; j < Count; ++j)
  {
    for (size_t i = 0; i < Count; ++i)
    {
      coefficients[j] += values[i] * std::cos(vtkMath::Pi() * j * (i + 0.5) / Count);
    }
    coefficients[j] *= (j == 0 ? 1.0 : 2.0) / Count;
  }
  return coefficients;
}

// The same polynomial by powers. In [-1, 1] those of so low a degree cost no digits that count.
std::array<double, Rows> ToPowers(const std::array<double, Rows>& chebyshev)
{
  std::array<double, Rows> powers{};
  std::array<double, Rows> before{}; // T of the degree before, and of this one
  std::array<double, Rows> current{};
  before[1] = 1.0; // T_-1 = T_1
  current[0] = 1.0;
  for (int degree = 0; degree < Rows; ++degree)
  {
    std::array<double, Rows> next{};
    for (int i = 0; i < Rows; ++i)
    {
      powers[i] += chebyshev[degree] * current[i];
      next[i] = (i > 0 ? 2.0 * current[i - 1] : 0.0) - before[i];
    }
    before = current;
    current = next;
  }
  return powers;
}

// The logarithm of a number that rounding may have left at or below 0.
double GetLogarithm(double value, double brightest)
{
  return std::log(std::max(value, 1e-9 * brightest));
}

// One channel's coefficients.
class ChannelFit
{
public:
  ChannelFit(double albedo, const std::vector<double>& legendre, double lobe)
    : Solution(albedo, legendre)
    , Kappa(this->Solution.GetSlowestDecay())
    , Lobe(lobe)
  {
  }

  void Fit(f64::AirlightMultiple& result, int channel) const
  {
    std::array<std::array<double, Rows>, Columns> columns;
    std::array<double, Rows> fluence;
    std::array<double, Rows> flux;
    for (int i = 0; i < Rows; ++i)
    {
      const double r = GetDistance(GetNode(i, Rows));
      const std::vector<double> moments = this->Solution.GetRadialMoments(r);
      const double rise = std::log(r) + this->Kappa * r;
      fluence[i] = std::log(moments[0]) + rise;
      flux[i] = GetLogarithm(moments[1], moments[0]) + rise;
      std::array<double, Columns> row;
      const double brightest = this->Solution.GetSource(moments, 1.0);
      for (int j = 0; j < Columns; ++j)
      {
        const double mu = GetCosine(GetNode(j, Columns), this->Lobe);
        row[j] = GetLogarithm(this->Solution.GetSource(moments, mu), brightest) + rise;
      }
      row = Interpolate(row);
      for (int j = 0; j < Columns; ++j)
      {
        columns[j][i] = row[j];
      }
    }
    for (int j = 0; j < Columns; ++j)
    {
      const std::array<double, Rows> column = ToPowers(Interpolate(columns[j]));
      for (int i = 0; i < Rows; ++i)
      {
        result.source[i * Columns + j][channel] = column[i];
      }
    }
    fluence = ToPowers(Interpolate(fluence));
    flux = ToPowers(Interpolate(flux));
    for (int i = 0; i < Rows; ++i)
    {
      result.moment[i][channel] = fluence[i];
      result.moment[Rows + i][channel] = flux[i];
    }
    result.kappa[channel] = this->Kappa;
  }

  // The largest error half-way between the nodes.
  double GetError(const f64::AirlightMultiple& fit, int channel) const
  {
    double worst = 0.0;
    for (int i = 0; i <= Rows; ++i)
    {
      const double x = std::cos(vtkMath::Pi() * i / Rows);
      const double r = GetDistance(x);
      const std::vector<double> moments = this->Solution.GetRadialMoments(r);
      const double brightest = this->Solution.GetSource(moments, 1.0);
      for (int j = 0; j <= 2 * Columns; ++j)
      {
        const double mu = GetCosine(std::cos(0.5 * vtkMath::Pi() * j / Columns), this->Lobe);
        const double exact = this->Solution.GetSource(moments, mu);
        const glm::dvec3 found = f64::airlightSourceLogarithm(
          fit, f64::airlightSourceX(glm::dvec3(r)), f64::airlightSourceY(this->Lobe, mu));
        const double value = std::exp(found[channel] - this->Kappa * r) / r;
        worst =
          std::max(worst, std::abs(value - exact) / std::max(std::abs(exact), Dark * brightest));
      }
    }
    return worst;
  }

private:
  UnboundedSolution Solution;
  double Kappa;
  double Lobe;
};

void CopyChannel(f64::AirlightMultiple& result, int from, int to)
{
  result.kappa[to] = result.kappa[from];
  for (glm::dvec4& value : result.source)
  {
    value[to] = value[from];
  }
  for (glm::dvec4& value : result.moment)
  {
    value[to] = value[from];
  }
}

// Light that is absorbed where it is first met is never scattered again.
void MakeDark(f64::AirlightMultiple& result, int channel)
{
  constexpr double none = -1e4; // a logarithm
  result.kappa[channel] = 1.0;
  result.source[0][channel] = none;
  result.moment[0][channel] = none;
  result.moment[Rows][channel] = none;
}
}

//------------------------------------------------------------------------------
SourceFit FitSource(const glm::dvec3& albedo, const std::vector<double>& legendre)
{
  SourceFit result;
  result.Coefficients.on = 1;
  result.Coefficients.lobe = legendre[1] * legendre[1];
  MakeLayers(albedo, legendre[1], result.Coefficients);
  for (int channel = 0; channel < 3; ++channel)
  {
    result.Coefficients.loss[channel] = 1.5 * (1.0 - albedo[channel] * legendre[1]);
    int same = 0;
    while (albedo[same] != albedo[channel])
    {
      ++same;
    }
    if (same < channel)
    {
      CopyChannel(result.Coefficients, same, channel);
    }
    else if (albedo[channel] < 1e-6)
    {
      MakeDark(result.Coefficients, channel);
    }
    else
    {
      const ChannelFit fit(albedo[channel], legendre, result.Coefficients.lobe);
      fit.Fit(result.Coefficients, channel);
      result.ErrorBound = std::max(result.ErrorBound, fit.GetError(result.Coefficients, channel));
    }
  }
  return result;
}
}
