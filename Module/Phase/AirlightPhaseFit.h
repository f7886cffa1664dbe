// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes phase functions as sums of poles, the form that the closed form of single scattering takes
 * (glsl/AirlightPhase.glsl). With s = tan(theta/2) and q_k = s^2 + b_k^2:
 *
 *   p(s)/(1 + s^2) = sum_k c1_k/q_k + c2_k/q_k^2 + c3_k/q_k^3
 */

#ifndef AirlightPhaseFit_h
#define AirlightPhaseFit_h

#include "Integration/AirlightMath.h"
#include "Phase/AirlightPhaseFunctions.h"

#include <array>
#include <vector>

namespace airlight
{
struct PhasePole
{
  double b = 1.0;
  std::array<double, 3> c = { 0.0, 0.0, 0.0 };
};

struct PhaseFit
{
  std::vector<PhasePole> Poles;
  // Beside the poles: Factor ((1 + cosTheta)/2)^Exponent.
  double Factor = 0.0;
  double Exponent = 0.0;
  // Largest relative error over all angles. Because phase functions are positive it also bounds
  // the relative error of any integral of airlight.
  double ErrorBound = 0.0;
};

// For the mathematics.
f64::AirlightPhase Convert(const PhaseFit& fit);

// Whether the function is nothing but poles, and single precision can sum them: fitted weights
// alternate in sign and cancel.
bool HasClosedForm(const f64::AirlightPhase& phase);

// Those that need no fit; see AirlightPhaseFunctions.h.
PhaseFit ExactIsotropic();
PhaseFit ExactRayleigh();
PhaseFit ExactSchlick(double k);
PhaseFit ExactMie(int n);

// Fits with the fewest poles (at most maximumPoles) whose error is at most the tolerance; the best
// one where none reaches it. -1 < g < 1.
PhaseFit FitHenyeyGreenstein(double g, double tolerance, int maximumPoles);
PhaseFit FitCornetteShanks(double g, double tolerance, int maximumPoles);
PhaseFit FitTable(const PhaseTable& table, double tolerance, int maximumPoles);

// The same of any function with a forward peak like Henyey and Greenstein's of this g, 0 < g < 1.
PhaseFit FitPeaked(const PhaseFunction& function, double g, double tolerance, int maximumPoles);

// The same of any function.
PhaseFit FitFunction(const PhaseFunction& function, double tolerance, int maximumPoles);

// The fit with forward and backward exchanged.
PhaseFit Mirror(const PhaseFit& fit);
}

#endif
