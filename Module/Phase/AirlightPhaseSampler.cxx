// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightPhaseSampler.h"

#include "Integration/AirlightMath.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr double RelativeError = 1e-6;
constexpr int FirstIntervals = 16;
constexpr int MaximumDepth = 12; // of halving them
constexpr int Probes = 8;        // in each interval

class Sampler
{
public:
  explicit Sampler(const PhaseFunction& function)
    : Function(function)
  {
  }

  std::vector<glm::dvec4> Sample()
  {
    std::vector<glm::dvec4> rows = { this->MakeRow(0.0) };
    for (int i = 1; i <= FirstIntervals; ++i)
    {
      const glm::dvec4 first = rows.back(); // a copy: the vector grows
      this->AddRows(first, this->MakeRow(vtkMath::Pi() * i / FirstIntervals), MaximumDepth, rows);
    }
    return rows;
  }

  double GetError() const { return this->Error; }

private:
  // Scattering is symmetric about 0 and 180 degrees.
  double Logarithm(double angle) const
  {
    const double folded =
      std::abs(angle) > vtkMath::Pi() ? 2.0 * vtkMath::Pi() - angle : std::abs(angle);
    return std::log(std::max(1e-300, this->Function(std::tan(0.5 * folded))));
  }

  glm::dvec4 MakeRow(double angle) const
  {
    // Five points: exact for polynomials of degree four.
    constexpr double step = 1e-4;
    const double near = this->Logarithm(angle + step) - this->Logarithm(angle - step);
    const double far = this->Logarithm(angle + 2.0 * step) - this->Logarithm(angle - 2.0 * step);
    return { angle, this->Logarithm(angle), (8.0 * near - far) / (12.0 * step), 0.0 };
  }

  double FindError(const glm::dvec4& first, const glm::dvec4& last) const
  {
    const glm::dvec4 rows[] = { first, last };
    f64::AirlightPhase phase{};
    phase.data = rows;
    phase.rows = 2;
    double error = 0.0;
    for (int i = 1; i <= Probes; ++i)
    {
      const double angle = first.x + (last.x - first.x) * (i - 0.5) / Probes;
      const double value = f64::airlightPhaseTable(phase, std::cos(angle));
      error = std::max(error, std::abs(value / std::exp(this->Logarithm(angle)) - 1.0));
    }
    return error;
  }

  // The rows after the first one, up to the last one.
  void AddRows(
    const glm::dvec4& first, const glm::dvec4& last, int depth, std::vector<glm::dvec4>& rows)
  {
    const double error = this->FindError(first, last);
    if (depth > 0 && error > RelativeError)
    {
      const glm::dvec4 middle = this->MakeRow(0.5 * (first.x + last.x));
      this->AddRows(first, middle, depth - 1, rows);
      this->AddRows(middle, last, depth - 1, rows);
      return;
    }
    this->Error = std::max(this->Error, error);
    rows.push_back(last);
  }

  const PhaseFunction& Function;
  double Error = 0.0;
};
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> SamplePhase(const PhaseFunction& function, double& error)
{
  constexpr double margin = 1.1; // for what lies between the probes
  Sampler sampler(function);
  std::vector<glm::dvec4> rows = sampler.Sample();
  error = margin * sampler.GetError();
  return rows;
}
}
