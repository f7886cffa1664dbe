// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Adaptive quadrature of airlight in double precision, for everything without a closed form. Not
 * installed.
 */

#ifndef AirlightAdaptiveQuadrature_h
#define AirlightAdaptiveQuadrature_h

#include "Integration/AirlightIntegrate.h"

#include <vector>

namespace airlight
{
// Integrates panels between the cuts of AirlightRayCuts.h by nested rules. The panel with the
// largest error comes first: it gets more nodes, or is halved if more nodes help little.
class AdaptiveQuadrature
{
public:
  // `share`: IntegrateDimmed(), or none for all of the light.
  AdaptiveQuadrature(const f64::AirlightMedia& media, const f64::AirlightLight& light,
    const f64::AirlightRay& ray, LightShare share = nullptr);

  // The integral over [t0, t1] that f64::airlightQuadrature() approximates. The error is 1e-12 of
  // it where the integrand is smooth between finitely many kinks, 1e-6 with images among the
  // densities, and 1e-5 with a share. Panels are halved at most 20 000 times.
  glm::dvec3 Integrate(double t0, double t1);

private:
  static constexpr int MostHalvings = 20000;
  static constexpr int MostPairs = 16;

  struct Panel
  {
    const f64::AirlightPiece* Piece;
    bool Straight; // integrated over t, else over v with t - tL = h sinh v
    double From;   // of that variable
    double To;
    int Rule = 0;
    bool Converges = true;       // the last rule was much better than the one before
    glm::dvec3 Pairs[MostPairs]; // the integrand's sums over the two nodes of each row of the rules
    glm::dvec3 Value{ 0.0 };
    glm::dvec3 Error{ 0.0 };
  };

  bool Scatters(const f64::AirlightPiece& piece) const;
  void AddPanels(const f64::AirlightPiece& piece);
  glm::dvec3 Evaluate(const Panel& panel, double v) const;
  Panel MakePanel(const f64::AirlightPiece& piece, bool straight, double from, double to);
  void UseNextRule(Panel& panel);
  void Halve(size_t index);
  void Refine();

  const f64::AirlightMedia& Media;
  const f64::AirlightLight& Light;
  const f64::AirlightRay& Ray;
  LightShare Share;
  double Tolerance;      // of the errors of all panels, relative to the integral
  double PanelTolerance; // smaller errors than this are left alone
  int FirstRule;
  int Fineness = 1; // times as many panels
  std::vector<Panel> Panels;
  // The best estimates so far: the first one may have missed a narrow peak by orders of magnitude,
  // and a tolerance taken from it would never be reached.
  glm::dvec3 Total{ 0.0 };
  glm::dvec3 Error{ 0.0 };
};
}

#endif
