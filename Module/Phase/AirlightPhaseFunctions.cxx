// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightPhaseFunctions.h"

#include "Integration/AirlightMath.h"
#include "vtkMath.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace airlight
{
namespace
{
// (1 + cos)/2 and (1 - cos)/2.
double ForwardHalf(double s) { return 1.0 / (1.0 + s * s); }
double BackwardHalf(double s)
{
  return s > 1.0 ? 1.0 / (1.0 + 1.0 / (s * s)) : s * s / (1.0 + s * s);
}

// 1 + cos^2, cos = forward - backward.
double OnePlusSquaredCosine(double s)
{
  const double f = ForwardHalf(s);
  const double b = BackwardHalf(s);
  return 2.0 * (f * f + b * b);
}
}

//------------------------------------------------------------------------------
double HenyeyGreenstein(double g, double s)
{
  const double d = (1.0 - g) * (1.0 - g) * ForwardHalf(s) + (1.0 + g) * (1.0 + g) * BackwardHalf(s);
  return (1.0 - g * g) / (4.0 * vtkMath::Pi() * d * std::sqrt(d));
}

//------------------------------------------------------------------------------
double Rayleigh(double s) { return 3.0 / (16.0 * vtkMath::Pi()) * OnePlusSquaredCosine(s); }

//------------------------------------------------------------------------------
double Schlick(double k, double s)
{
  const double d = (1.0 - k) * ForwardHalf(s) + (1.0 + k) * BackwardHalf(s);
  return (1.0 - k * k) / (4.0 * vtkMath::Pi() * d * d);
}

//------------------------------------------------------------------------------
double CornetteShanks(double g, double s)
{
  return 1.5 / (2.0 + g * g) * OnePlusSquaredCosine(s) * HenyeyGreenstein(g, s);
}

//------------------------------------------------------------------------------
double Mie(int n, double s)
{
  return (0.5 + 0.5 * (n + 1) * std::pow(ForwardHalf(s), n)) / (4.0 * vtkMath::Pi());
}

//------------------------------------------------------------------------------
PhaseTable PhaseTable::Read(vtkTable* table, std::string& error)
{
  PhaseTable result;
  std::ostringstream reason;
  const vtkIdType rows = table ? table->GetNumberOfRows() : 0;
  if (rows < 2 || table->GetNumberOfColumns() < 2)
  {
    reason << "has " << rows << " rows and " << (table ? table->GetNumberOfColumns() : 0)
           << " columns; it needs at least 2 rows and 2 columns, scattering angle in degrees and "
              "value";
  }
  double last = -1.0; // in degrees as they are: rounding may hide that an angle is repeated
  double largest = std::numeric_limits<double>::min();
  for (vtkIdType row = 0; row < rows && reason.tellp() == 0; ++row)
  {
    bool isNumber[2] = { false, false };
    const double angle = table->GetValue(row, 0).ToDouble(&isNumber[0]);
    const double value = table->GetValue(row, 1).ToDouble(&isNumber[1]);
    if (!isNumber[0] || !(angle > last) || !(angle >= 0.0 && angle <= 180.0))
    {
      reason << "has the angle " << table->GetValue(row, 0).ToString() << " in row " << row
             << "; angles are degrees in [0, 180] and ascend";
    }
    else if (!isNumber[1] || !(value > 0.0) || !std::isfinite(value))
    {
      reason << "has the value " << table->GetValue(row, 1).ToString() << " in row " << row
             << "; values are finite and above 0";
    }
    last = angle;
    largest = std::max(largest, value);
    result.Rows.emplace_back(vtkMath::RadiansFromDegrees(angle), std::log(value), 0.0, 0.0);
  }
  for (glm::dvec4& row : result.Rows)
  {
    row.y -= std::log(largest);
    if (reason.tellp() == 0 && row.y < std::log(1e-12))
    {
      reason << "has values that differ by more than 1e12";
    }
  }
  error = reason.str();
  if (!error.empty())
  {
    return {};
  }
  result.FindSlopes();
  const double integral = result.Integrate();
  for (glm::dvec4& row : result.Rows)
  {
    row.y -= std::log(integral);
  }
  return result;
}

//------------------------------------------------------------------------------
// At an extremum the slope is 0, elsewhere a harmonic mean of the slopes on both sides; 0 at the
// ends, beyond which the function is constant and where scattering is symmetric anyway.
void PhaseTable::FindSlopes()
{
  for (size_t i = 1; i + 1 < this->Rows.size(); ++i)
  {
    const glm::dvec4 before = this->Rows[i] - this->Rows[i - 1];
    const glm::dvec4 after = this->Rows[i + 1] - this->Rows[i];
    const double m0 = before.y / before.x;
    const double m1 = after.y / after.x;
    if (m0 * m1 > 0.0)
    {
      this->Rows[i].z = 3.0 * (before.x + after.x) /
        ((2.0 * after.x + before.x) / m0 + (after.x + 2.0 * before.x) / m1);
    }
  }
}

//------------------------------------------------------------------------------
double PhaseTable::EvaluateAt(double cosTheta) const
{
  f64::AirlightPhase phase{};
  phase.data = this->Rows.data();
  phase.rows = static_cast<int>(this->Rows.size());
  return f64::airlightPhaseTable(phase, cosTheta);
}

//------------------------------------------------------------------------------
// Over the sphere, by Gauss-Legendre quadrature between the rows.
double PhaseTable::Integrate() const
{
  const glm::dvec4& first = this->Rows.front();
  const glm::dvec4& last = this->Rows.back();
  double sum =
    std::exp(first.y) * (1.0 - std::cos(first.x)) + std::exp(last.y) * (1.0 + std::cos(last.x));
  for (size_t i = 1; i < this->Rows.size(); ++i)
  {
    const double from = this->Rows[i - 1].x;
    const double reach = 0.5 * (this->Rows[i].x - from);
    for (int k = 0; k < 16; ++k)
    {
      const glm::dvec2 node = f64::airlightGaussNode(k / 2);
      const double angle = from + reach * (1.0 + (k % 2 == 0 ? node.x : -node.x));
      sum += reach * node.y * this->EvaluateAt(std::cos(angle)) * std::sin(angle);
    }
  }
  return 2.0 * vtkMath::Pi() * sum;
}

//------------------------------------------------------------------------------
double PhaseTable::Evaluate(double s) const
{
  return this->EvaluateAt(ForwardHalf(s) - BackwardHalf(s));
}
}
