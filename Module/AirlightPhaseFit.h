// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes a phase function as a sum of poles, the form that the closed form of single scattering
 * takes (glsl/AirlightPhase.glsl):
 *
 *   p(cosTheta) = sum_k 2 c_k/((1 - cosTheta) + b_k^2 (1 + cosTheta))
 */

#ifndef AirlightPhaseFit_h
#define AirlightPhaseFit_h

#include <vector>

namespace airlight
{
struct PhasePole
{
  double b;
  double c;
};

struct PhaseFit
{
  std::vector<PhasePole> Poles;
  // Largest relative error over all angles. Because phase functions are positive it also bounds
  // the relative error of any integral of airlight.
  double ErrorBound = 0.0;
};

// Henyey and Greenstein's function (1941) of anisotropy g at s = tan(theta/2), in 1/sr. In s,
// narrow forward and backward peaks keep all their digits, which cosTheta near 1 or -1 does not.
double HenyeyGreenstein(double g, double s);

// Its fit with the fewest poles (at most maximumPoles) whose error is at most the tolerance; the
// best one where none reaches it. -1 < g < 1.
PhaseFit FitHenyeyGreenstein(double g, double tolerance, int maximumPoles);
}

#endif
