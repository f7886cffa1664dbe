// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultipleScattering/AirlightUnboundedSolution.h"

#include "Integration/AirlightMath.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// The spherical Bessel functions j_l(z), l from 0 to `degree`, downward (Miller), normalised by the
// sum of (2 l + 1) j_l^2, which is 1.
std::vector<double> GetBessel(double z, int degree)
{
  std::vector<double> values(degree + 1, 0.0);
  double above = 0.0;
  double value = 1e-150;
  double sum = 0.0;
  for (int l = degree + 40; l >= 0; --l)
  {
    if (l <= degree)
    {
      values[l] = value;
    }
    sum += (2.0 * l + 1.0) * value * value;
    const double below = (2.0 * l + 1.0) / z * value - above;
    above = value;
    value = below;
    if (l > 0 && std::abs(value) > 1e100)
    {
      const double small = 1e-200;
      value *= small;
      above *= small;
      sum = sum * small * small; // in this order: the square of small is no number
      std::for_each(values.begin(), values.end(), [small](double& v) { v *= small; });
    }
  }
  // Where j_0 vanishes, j_1 does not.
  const double first = std::sin(z) / z;
  const double second = degree > 0 ? (std::sin(z) / z - std::cos(z)) / z : 0.0;
  const bool bySecond = degree > 0 && std::abs(second) > std::abs(first);
  const bool turned = bySecond ? second * values[1] < 0.0 : first * values[0] < 0.0;
  const double scale = (turned ? -1.0 : 1.0) / std::sqrt(sum);
  std::for_each(values.begin(), values.end(), [scale](double& v) { v *= scale; });
  return values;
}

// The spherical Hankel functions h1_l(z), l from 0 to `degree`, upward.
std::vector<std::complex<double>> GetHankel(std::complex<double> z, int degree)
{
  const std::complex<double> i(0.0, 1.0);
  std::vector<std::complex<double>> values(degree + 1);
  const std::complex<double> e = std::exp(i * z);
  values[0] = -i * e / z;
  if (degree > 0)
  {
    values[1] = -e * (z + i) / (z * z);
  }
  for (int l = 1; l < degree; ++l)
  {
    values[l + 1] = (2.0 * l + 1.0) / z * values[l] - values[l - 1];
  }
  return values;
}

// Of the continued fraction, beyond the phase function's own.
constexpr double MostDegrees = 200.0;

double RealPart(double a) { return a; }
double RealPart(const std::complex<double>& a) { return a.real(); }
double Divide(double a, double b) { return a / b; }
// Without the care that std::complex takes of numbers that are not finite.
std::complex<double> Divide(const std::complex<double>& a, const std::complex<double>& b)
{
  const double scale = 1.0 / (b.real() * b.real() + b.imag() * b.imag());
  return { (a.real() * b.real() + a.imag() * b.imag()) * scale,
    (a.imag() * b.real() - a.real() * b.imag()) * scale };
}

// Calls visit(place, weight) for the nodes of each panel.
template <typename Visitor>
void VisitPanels(const std::vector<double>& ends, Visitor&& visit)
{
  for (size_t panel = 1; panel < ends.size(); ++panel)
  {
    const double middle = 0.5 * (ends[panel] + ends[panel - 1]);
    const double half = 0.5 * (ends[panel] - ends[panel - 1]);
    for (int k = 0; k < 16; ++k)
    {
      const glm::dvec2 node = f64::airlightGaussNode(k / 2);
      visit(middle + (k % 2 == 0 ? half : -half) * node.x, half * node.y);
    }
  }
}
}

//------------------------------------------------------------------------------
UnboundedSolution::UnboundedSolution(double albedo, const std::vector<double>& legendre)
  : Albedo(albedo)
  , Legendre(legendre)
{
  // The real axis keeps high degrees and short distances accurate; from `turn` on, where the
  // integrand would go on oscillating, a turned path lets it decay.
  const int degree = static_cast<int>(legendre.size()) - 1;
  const double turn = degree + 6.0;
  std::vector<double> ends = { 0.0, 1e-2, 1e-1, 1.0, 4.0 };
  const int panels = static_cast<int>(std::ceil((turn - 4.0) / 9.0));
  for (int panel = 1; panel <= panels; ++panel)
  {
    ends.push_back(4.0 + (turn - 4.0) * panel / panels);
  }
  VisitPanels(ends, [this, degree](double z, double weight) {
    this->Real.Places.push_back(z);
    for (const double value : GetBessel(z, degree))
    {
      this->Real.Weights.push_back(weight * z * z * value);
    }
  });
  const std::complex<double> direction = std::polar(1.0, 0.3 * vtkMath::Pi());
  VisitPanels({ 0.0, 2.0, 8.0, 26.0 }, [&](double q, double weight) {
    const std::complex<double> z = turn + q * direction;
    this->Turned.Places.push_back(z);
    for (const std::complex<double>& value : GetHankel(z, degree))
    {
      this->Turned.Weights.push_back(weight * direction * z * z * value);
    }
  });
}

//------------------------------------------------------------------------------
double UnboundedSolution::GetSlowestDecay() const
{
  if (this->Albedo >= 1.0)
  {
    return 0.0;
  }
  // 1/chi_0 at k = i kappa is above 0 below the root; beyond it a partial denominator is not.
  const auto isBelow = [this](double kappa) {
    constexpr int most = 400;
    const auto moment = [this](int l) {
      return l < static_cast<int>(this->Legendre.size()) ? this->Legendre[l] : 0.0;
    };
    const double ratio = kappa / (1.0 + std::sqrt(1.0 - kappa * kappa));
    double denominator =
      (2.0 * most + 1.0) * (1.0 - this->Albedo * moment(most)) - kappa * (most + 1.0) * ratio;
    for (int l = most - 1; l >= 0; --l)
    {
      const double step = kappa * (l + 1.0);
      denominator = (2.0 * l + 1.0) * (1.0 - this->Albedo * moment(l)) - step * step / denominator;
      if (denominator < 0.0 && l > 0)
      {
        return false;
      }
    }
    return denominator > 0.0;
  };
  double low = 0.0;
  double high = 1.0;
  for (int step = 0; step < 50; ++step)
  {
    const double middle = 0.5 * (low + high);
    (isBelow(middle) ? low : high) = middle;
  }
  return low;
}

//------------------------------------------------------------------------------
// Adds the real parts of what the nodes of one part of the path give. With the ratios
//
//   rho_{l-1} = k l/(h_l + k (l + 1) rho_l),   chi_l = rho_{l-1} chi_{l-1}
//
// from where rho_l is nearly what it is at infinity; the same without scattering is taken away. All
// nodes go together, as each waits for its own divisions.
template <typename Number>
void UnboundedSolution::AddNodes(
  const Nodes<Number>& nodes, double r, std::vector<double>& moments) const
{
  const size_t count = nodes.Places.size();
  const int degree = static_cast<int>(this->Legendre.size()) - 1;
  const double largest = std::abs(nodes.Places.back()) / r;
  const int start = degree + 12 + static_cast<int>(std::min(MostDegrees, 6.0 * largest));
  std::vector<Number> k(count);
  std::vector<Number> rho(count);
  std::vector<Number> denominators(count);
  std::vector<Number> ratios(count * (degree + 1));
  for (const double albedo : { this->Albedo, 0.0 })
  {
    for (size_t i = 0; i < count; ++i)
    {
      k[i] = nodes.Places[i] / r;
      rho[i] = (std::sqrt(1.0 + k[i] * k[i]) - 1.0) / k[i];
    }
    for (int l = start; l >= 0; --l)
    {
      const double h = (2.0 * l + 1.0) * (l <= degree ? 1.0 - albedo * this->Legendre[l] : 1.0);
      for (size_t i = 0; i < count; ++i)
      {
        denominators[i] = h + (l + 1.0) * k[i] * rho[i];
        rho[i] = static_cast<double>(l) * Divide(k[i], denominators[i]);
      }
      if (l >= 1 && l <= degree)
      {
        std::copy(rho.begin(), rho.end(), ratios.begin() + (l - 1) * count);
      }
    }
    for (size_t i = 0; i < count; ++i)
    {
      Number chi = Divide(Number(albedo > 0.0 ? 1.0 : -1.0), denominators[i]);
      for (int l = 0; l <= degree; ++l)
      {
        moments[l] += RealPart(nodes.Weights[i * (degree + 1) + l] * chi);
        chi *= l < degree ? ratios[l * count + i] : Number(0.0);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<double> UnboundedSolution::GetRadialMoments(double r) const
{
  std::vector<double> moments(this->Legendre.size(), 0.0);
  this->AddNodes(this->Real, r, moments);
  this->AddNodes(this->Turned, r, moments);
  const double scale = 1.0 / (2.0 * vtkMath::Pi() * vtkMath::Pi() * r * r * r);
  std::for_each(moments.begin(), moments.end(), [scale](double& moment) { moment *= scale; });
  return moments;
}

//------------------------------------------------------------------------------
double UnboundedSolution::GetSource(const std::vector<double>& radialMoments, double mu) const
{
  double sum = 0.0;
  double previous = 0.0;
  double legendre = 1.0;
  for (size_t l = 0; l < radialMoments.size(); ++l)
  {
    sum += (2.0 * l + 1.0) * this->Legendre[l] * radialMoments[l] * legendre;
    const double next = ((2.0 * l + 1.0) * mu * legendre - l * previous) / (l + 1.0);
    previous = legendre;
    legendre = next;
  }
  return this->Albedo * sum / (4.0 * vtkMath::Pi());
}
}
