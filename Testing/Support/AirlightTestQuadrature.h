// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The expected numbers of the tests: adaptive Gauss-Legendre quadrature of the integrand of single
 * scattering as physics states it, p/r^2 exp(-sigmaT (t + r)). Nothing here calls the library.
 */

#ifndef AirlightTestQuadrature_h
#define AirlightTestQuadrature_h

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace airlight_test
{
constexpr double Pi = 3.14159265358979323846;
constexpr int GaussCount = 20;

struct GaussRule
{
  std::array<double, GaussCount> X; // on [-1, 1]
  std::array<double, GaussCount> W;
};

// Roots of Legendre's polynomial by Newton's method on its recurrence.
inline GaussRule MakeGaussRule()
{
  GaussRule rule;
  for (int i = 0; i < GaussCount; ++i)
  {
    long double x = std::cos(static_cast<long double>(Pi) * (i + 0.75L) / (GaussCount + 0.5L));
    long double slope = 1.0L;
    for (int step = 0; step < 10; ++step)
    {
      long double before = 1.0L;
      long double p = x;
      for (int n = 2; n <= GaussCount; ++n)
      {
        const long double next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
        before = p;
        p = next;
      }
      slope = GaussCount * (x * p - before) / (x * x - 1.0L);
      x -= p / slope;
    }
    rule.X[i] = static_cast<double>(x);
    rule.W[i] = static_cast<double>(2.0L / ((1.0L - x * x) * slope * slope));
  }
  return rule;
}

template <typename F>
double GaussPanel(const F& f, long double a, long double b)
{
  static const GaussRule rule = MakeGaussRule();
  const long double middle = 0.5L * (a + b);
  const long double reach = 0.5L * (b - a);
  double sum = 0.0;
  for (int i = 0; i < GaussCount; ++i)
  {
    sum += rule.W[i] * f(static_cast<double>(middle + reach * rule.X[i]));
  }
  return static_cast<double>(reach) * sum;
}

// The integral of f >= 0 over the panels between the sorted `ends`. A panel is halved until its
// halves agree with it to `tolerance` of the whole integral, as far as it is known by then: the
// first estimate may miss a narrow peak altogether. The ends are long double so that a short panel
// far from 0 keeps the digits of its length.
template <typename F>
double Integrate(const F& f, const std::vector<long double>& ends, double tolerance)
{
  struct Panel
  {
    long double A;
    long double B;
    double Value;
    int Depth;
  };
  std::vector<Panel> open;
  double total = 0.0;
  for (size_t i = 1; i < ends.size(); ++i)
  {
    open.push_back({ ends[i - 1], ends[i], GaussPanel(f, ends[i - 1], ends[i]), 0 });
    total += open.back().Value;
  }
  double sum = 0.0;
  while (!open.empty())
  {
    const Panel panel = open.back();
    open.pop_back();
    const long double middle = 0.5L * (panel.A + panel.B);
    const double low = GaussPanel(f, panel.A, middle);
    const double high = GaussPanel(f, middle, panel.B);
    const double change = low + high - panel.Value;
    total += change;
    if (panel.Depth > 50 || std::abs(change) <= tolerance * total)
    {
      sum += low + high;
    }
    else
    {
      open.push_back({ panel.A, middle, low, panel.Depth + 1 });
      open.push_back({ middle, panel.B, high, panel.Depth + 1 });
    }
  }
  return sum;
}

// Henyey and Greenstein's phase function from 1 - cosTheta and 1 + cosTheta.
struct HenyeyGreensteinPhase
{
  double G;
  double operator()(double oneMinusCos, double) const
  {
    const double d = (1.0 - this->G) * (1.0 - this->G) + 2.0 * this->G * oneMinusCos;
    return (1.0 - this->G * this->G) / (4.0 * Pi * d * std::sqrt(d));
  }
};

// Panel ends for an integrand with a peak of width h at 0: geometric, so that no panel is longer
// than about its distance to the peak.
inline std::vector<long double> PeakPanels(long double x0, long double x1, long double h)
{
  std::vector<long double> ends = { x0, x1 };
  const long double reach = std::max(std::abs(x0), std::abs(x1));
  const auto add = [&](long double x) {
    if (x > x0 && x < x1)
    {
      ends.push_back(x);
    }
  };
  add(0.0L);
  for (long double x = h; x < reach; x *= 3.0L)
  {
    add(x);
    add(-x);
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

// The airlight of a point light per unit sigmaS I on [t0, t1]: tL is the distance along the ray to
// the light's foot, h > 0 the light's distance from the ray. Phase takes (1 - cosTheta,
// 1 + cosTheta). cosTheta = -x/r with x = t - tL; sums that cancel are replaced by h^2 over their
// conjugates. `kinks` are scattering angles at which the phase function is not smooth.
template <typename Phase>
double PointLightAirlight(const Phase& phase, double sigmaT, long double tL, long double h,
  long double t0, long double t1, const std::vector<long double>& kinks = {})
{
  const double depthOfFoot = static_cast<double>(sigmaT * tL);
  const double height = static_cast<double>(h);
  const auto integrand = [&](double x) {
    const double r = std::sqrt(height * height + x * x);
    const double rPlusX = x >= 0.0 ? r + x : height * height / (r - x);
    const double rMinusX = x <= 0.0 ? r - x : height * height / (r + x);
    // t + r = tL + (r + x)
    return phase(rPlusX / r, rMinusX / r) * std::exp(-depthOfFoot - sigmaT * rPlusX) / (r * r);
  };
  const long double x0 = t0 - tL;
  long double x1 = t1 - tL;
  // Beyond the foot every factor but p falls; once the exponential has fallen by e^-80 the rest is
  // below 1e-30 of what came before, for any p with a contrast below 1e4.
  if (sigmaT > 0.0)
  {
    const long double nearest = std::max(x0, 0.0L);
    const long double sum =
      nearest + std::sqrt(h * h + nearest * nearest) + 80.0L / static_cast<long double>(sigmaT);
    const long double end = 0.5L * (sum - h * h / sum);
    x1 = std::min(x1, std::max(end, x0));
  }
  if (!(x1 > x0))
  {
    return 0.0;
  }
  std::vector<long double> ends = PeakPanels(x0, x1, h);
  for (const long double angle : kinks)
  {
    ends.push_back(std::clamp(-h / std::tan(angle), x0, x1));
  }
  std::sort(ends.begin(), ends.end());
  return Integrate(integrand, ends, 1e-13);
}

// The same in an isotropic medium for a light that sends `fall`(r, x) instead of 1/r^2, with x
// counted from the foot.
template <typename Fall>
double IsotropicAirlight(const Fall& fall, double sigmaT, double tL, double h, double t0, double t1,
  double tolerance = 1e-12)
{
  const auto integrand = [&](double x) {
    const double r = std::hypot(h, x);
    return 0.25 / Pi * fall(r, x) * std::exp(-sigmaT * (tL + x + r));
  };
  return Integrate(integrand, PeakPanels(t0 - tL, t1 - tL, h), tolerance);
}
}

#endif
