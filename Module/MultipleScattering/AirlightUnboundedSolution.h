// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The exact solution of the transport equation round a point lamp of power 1 that shines evenly, in
 * an unbounded uniform medium. Lengths are optical: the extinction coefficient is 1.
 *
 * The moments of the radiance in k-space, (-i)^l chi_l(k), obey
 *
 *   h_l chi_l + k (l + 1) chi_{l+1} - k l chi_{l-1} = delta_{l0},   h_l = (2 l + 1) (1 - c g_l)
 *
 * (Case and Zweifel, Linear Transport Theory, 1967), solved by a continued fraction from above. See
 * Documentation/physics.md. Not installed; exported for the module's own tests.
 */

#ifndef AirlightUnboundedSolution_h
#define AirlightUnboundedSolution_h

#include "vtkAirlightModule.h" // for export macro

#include <complex>
#include <vector>

namespace airlight
{
class VTKAIRLIGHT_EXPORT UnboundedSolution
{
public:
  // The albedo c, in (0, 1], and the phase function's Legendre moments, from g_0 = 1.
  UnboundedSolution(double albedo, const std::vector<double>& legendre);

  // kappa_0: far away, light falls as exp(-kappa_0 r)/r. 0 for the albedo 1.
  double GetSlowestDecay() const;

  // L_l(r), l from 0: the Legendre moments of the radiance that was scattered at least once. L_0 is
  // the fluence, L_1 the flux away from the lamp. r > 0; exact to about 1e-4 from r = 0.05 on.
  std::vector<double> GetRadialMoments(double r) const;

  // J(r, mu), of the moments at r: what is scattered there for at least the second time, into the
  // direction that makes an angle of cosine mu with the one away from the lamp, per volume and
  // solid angle.
  double GetSource(const std::vector<double>& radialMoments, double mu) const;

private:
  // Places z = k r on the path of integration, and for each, from l = 0, weights times z^2 times
  // the Bessel or Hankel function there.
  template <typename Number>
  struct Nodes
  {
    std::vector<Number> Places;
    std::vector<Number> Weights;
  };
  template <typename Number>
  void AddNodes(const Nodes<Number>& nodes, double r, std::vector<double>& moments) const;

  double Albedo;
  std::vector<double> Legendre;
  Nodes<double> Real;
  Nodes<std::complex<double>> Turned;
};
}

#endif
