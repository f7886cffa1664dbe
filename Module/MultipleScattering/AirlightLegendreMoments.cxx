// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultipleScattering/AirlightLegendreMoments.h"

#include "Integration/AirlightMath.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// What moments are neglected, and how many more than those above it are kept.
constexpr double Negligible = 1e-4;
constexpr int Spare = 20;

// Adds a panel of scattering angles to the moments.
void AddPanel(const std::function<double(double)>& phaseFunction, double from, double to,
  std::vector<double>& moments)
{
  for (int k = 0; k < 16; ++k)
  {
    const glm::dvec2 node = f64::airlightGaussNode(k / 2);
    const double theta = 0.5 * (from + to) + 0.5 * (to - from) * (k % 2 == 0 ? node.x : -node.x);
    const double mu = std::cos(theta);
    const double weight =
      vtkMath::Pi() * (to - from) * node.y * std::sin(theta) * phaseFunction(mu);
    double previous = 0.0;
    double legendre = 1.0;
    for (size_t l = 0; l < moments.size(); ++l)
    {
      moments[l] += weight * legendre;
      const double next = ((2.0 * l + 1.0) * mu * legendre - l * previous) / (l + 1.0);
      previous = legendre;
      legendre = next;
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<double> GetLegendreMomentsTo(
  int degree, const std::function<double(double)>& phaseFunction)
{
  std::vector<double> moments(degree + 1, 0.0);
  // Panels that are fine beside the forward and the backward direction, and elsewhere as wide as
  // the highest polynomial allows.
  constexpr double finest = 1e-3;
  constexpr double widest = 0.05;
  double from = 0.0;
  for (double width = finest; from < vtkMath::Pi();)
  {
    const double rest = vtkMath::Pi() - from;
    const double to = from + (rest < 1.5 * width ? rest : width);
    AddPanel(phaseFunction, from, to, moments);
    from = to;
    width = std::min({ 2.0 * width, widest, std::max(0.5 * (vtkMath::Pi() - from), finest) });
  }
  const double norm = moments[0] > 0.0 ? moments[0] : 1.0;
  std::for_each(moments.begin(), moments.end(), [norm](double& moment) { moment /= norm; });
  moments[0] = 1.0;
  return moments;
}

//------------------------------------------------------------------------------
std::vector<double> GetLegendreMoments(const std::function<double(double)>& phaseFunction)
{
  std::vector<double> moments = GetLegendreMomentsTo(MaximumLegendreDegree, phaseFunction);
  int last = MaximumLegendreDegree;
  while (last > 0 && std::abs(moments[last]) < Negligible)
  {
    --last;
  }
  if (last == MaximumLegendreDegree)
  {
    return {};
  }
  moments.resize(std::min(last > 0 ? last + Spare : 4, MaximumLegendreDegree) + 1);
  return moments;
}
}
