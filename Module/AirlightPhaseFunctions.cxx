// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightPhaseFunctions.h"

#include "AirlightMath.h"
#include "vtkMath.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
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
  return (1.0 - g * g) / (4.0 * M_PI * d * std::sqrt(d));
}

//------------------------------------------------------------------------------
double Rayleigh(double s) { return 3.0 / (16.0 * M_PI) * OnePlusSquaredCosine(s); }

//------------------------------------------------------------------------------
double Schlick(double k, double s)
{
  const double d = (1.0 - k) * ForwardHalf(s) + (1.0 + k) * BackwardHalf(s);
  return (1.0 - k * k) / (4.0 * M_PI * d * d);
}

//------------------------------------------------------------------------------
double CornetteShanks(double g, double s)
{
  return 1.5 / (2.0 + g * g) * OnePlusSquaredCosine(s) * HenyeyGreenstein(g, s);
}

//------------------------------------------------------------------------------
double Mie(int n, double s)
{
  return (0.5 + 0.5 * (n + 1) * std::pow(ForwardHalf(s), n)) / (4.0 * M_PI);
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
    result.Angles.push_back(vtkMath::RadiansFromDegrees(angle));
    result.Logarithms.push_back(std::log(value));
  }
  error = reason.str();
  if (!error.empty())
  {
    return {};
  }
  const double largest = *std::max_element(result.Logarithms.begin(), result.Logarithms.end());
  for (double& logarithm : result.Logarithms)
  {
    logarithm -= largest;
  }
  result.FindSlopes();
  const double integral = result.Integrate();
  for (double& logarithm : result.Logarithms)
  {
    logarithm -= std::log(integral);
  }
  return result;
}

//------------------------------------------------------------------------------
// At an extremum the slope is 0, elsewhere a harmonic mean of the slopes on both sides; 0 at the
// ends, beyond which the function is constant and where scattering is symmetric anyway.
void PhaseTable::FindSlopes()
{
  const std::vector<double>& a = this->Angles;
  const std::vector<double>& v = this->Logarithms;
  this->Slopes.assign(a.size(), 0.0);
  for (size_t i = 1; i + 1 < a.size(); ++i)
  {
    const double h0 = a[i] - a[i - 1];
    const double h1 = a[i + 1] - a[i];
    const double m0 = (v[i] - v[i - 1]) / h0;
    const double m1 = (v[i + 1] - v[i]) / h1;
    if (m0 * m1 > 0.0)
    {
      this->Slopes[i] = 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / m0 + (h1 + 2.0 * h0) / m1);
    }
  }
}

//------------------------------------------------------------------------------
double PhaseTable::EvaluateAt(double angle) const
{
  const std::vector<double>& a = this->Angles;
  const std::vector<double>& v = this->Logarithms;
  const auto next = std::upper_bound(a.begin(), a.end(), angle);
  if (next == a.begin() || next == a.end())
  {
    return std::exp(next == a.begin() ? v.front() : v.back());
  }
  const auto i = next - a.begin();
  const double h = a[i] - a[i - 1];
  const double x = (angle - a[i - 1]) / h;
  const double y = 1.0 - x;
  return std::exp(y * y * (1.0 + 2.0 * x) * v[i - 1] + x * x * (1.0 + 2.0 * y) * v[i] +
    h * x * y * (y * this->Slopes[i - 1] - x * this->Slopes[i]));
}

//------------------------------------------------------------------------------
// Over the sphere, by Gauss-Legendre quadrature between the rows.
double PhaseTable::Integrate() const
{
  const std::vector<double>& a = this->Angles;
  double sum = std::exp(this->Logarithms.front()) * (1.0 - std::cos(a.front())) +
    std::exp(this->Logarithms.back()) * (1.0 + std::cos(a.back()));
  for (size_t i = 1; i < a.size(); ++i)
  {
    const double reach = 0.5 * (a[i] - a[i - 1]);
    for (int k = 0; k < 16; ++k)
    {
      const glm::dvec2 node = f64::airlightGaussNode(k / 2);
      const double angle = a[i - 1] + reach * (1.0 + (k % 2 == 0 ? node.x : -node.x));
      sum += reach * node.y * this->EvaluateAt(angle) * std::sin(angle);
    }
  }
  return 2.0 * M_PI * sum;
}

//------------------------------------------------------------------------------
double PhaseTable::Evaluate(double s) const { return this->EvaluateAt(2.0 * std::atan(s)); }
}
