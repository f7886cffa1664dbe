// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightHemisphereFit.h"

#include "Integration/AirlightMath.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight
{
namespace
{
constexpr double Pi = vtkMath::Pi();

// Of panels of scattering angles: the finest beside peaks and beside the angles at which rings
// begin to cross the horizon; the widest for bumps of tables.
constexpr double FinestPanel = 1e-4;
constexpr double WidestPanel = 0.2;

// The widths that are tried, each so many times the one before.
constexpr double LeastWidth = 0.015;
constexpr double WidthRatio = 2.0;
constexpr int Widths = 8;

std::vector<double> GetPanelEnds(double x)
{
  const double horizon = std::asin(std::min(x, 1.0));
  std::vector<double> ends = { 0.0, Pi };
  for (const double center : { 0.0, horizon, Pi - horizon, Pi })
  {
    ends.push_back(center);
    for (double distance = FinestPanel; distance < Pi; distance *= 5.0)
    {
      ends.push_back(std::max(center - distance, 0.0));
      ends.push_back(std::min(center + distance, Pi));
    }
  }
  for (double end = WidestPanel; end < Pi; end += WidestPanel)
  {
    ends.push_back(end);
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

// The light on the ring at the angle theta from the direction: 4 phi - 2 pi, where it is above the
// horizon from -phi to phi.
double GetRing(double x, double theta)
{
  const double horizontal = std::sqrt(std::max(1.0 - x * x, 0.0)) * std::sin(theta);
  const double vertical = x * std::cos(theta);
  const double cosine = horizontal > std::abs(vertical) ? -vertical / horizontal
    : vertical > 0.0                                    ? -1.0
                                                        : 1.0;
  return 4.0 * std::acos(cosine) - 2.0 * Pi;
}

HemisphereFit FitWithWidth(const std::function<double(double)>& phaseFunction, double width)
{
  HemisphereFit fit;
  fit.Width = width;
  constexpr int count = 12;
  for (int node = 0; node < count; ++node)
  {
    const double angle = Pi * (node + 0.5) / (2.0 * count);
    const double x = width * std::tan(std::cos(angle) * std::atan(1.0 / width));
    const double value = IntegrateHemisphere(phaseFunction, x);
    for (int k = 0; k < count; ++k)
    {
      fit.Odd[k] += 2.0 / count * value * std::cos((2 * k + 1) * angle);
    }
  }
  return fit;
}
}

//------------------------------------------------------------------------------
double IntegrateHemisphere(const std::function<double(double)>& phaseFunction, double x)
{
  const std::vector<double> ends = GetPanelEnds(x);
  double sum = 0.0;
  for (size_t i = 1; i < ends.size(); ++i)
  {
    const double half = 0.5 * (ends[i] - ends[i - 1]);
    for (int k = 0; k < 16 && half > 0.0; ++k)
    {
      const glm::dvec2 node = f64::airlightGaussNode(k / 2);
      const double theta = ends[i - 1] + half * (k % 2 == 0 ? 1.0 + node.x : 1.0 - node.x);
      sum += half * node.y * std::sin(theta) * phaseFunction(std::cos(theta)) * GetRing(x, theta);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
HemisphereFit FitHemisphere(const std::function<double(double)>& phaseFunction)
{
  HemisphereFit best;
  double least = HUGE_VAL;
  for (int i = 0; i < Widths; ++i)
  {
    const HemisphereFit fit = FitWithWidth(phaseFunction, LeastWidth * std::pow(WidthRatio, i));
    // The polynomials that are left out contribute about as much as the last ones.
    const double rest = std::abs(fit.Odd[10]) + std::abs(fit.Odd[11]);
    if (rest < least)
    {
      least = rest;
      best = fit;
    }
  }
  return best;
}
}
