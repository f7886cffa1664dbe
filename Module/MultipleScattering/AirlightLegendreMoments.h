// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The Legendre moments of a phase function. Not installed; exported for the module's own tests.
 */

#ifndef AirlightLegendreMoments_h
#define AirlightLegendreMoments_h

#include "vtkAirlightModule.h" // for export macro

#include <functional>
#include <vector>

namespace airlight
{
// As many moments as multiple scattering is computed with, at most.
constexpr int MaximumLegendreDegree = 260;

// g_l = 2 pi times the integral of p(mu) P_l(mu) over [-1, 1], for l from 0; p in 1/sr, normalised.
// Ends twenty degrees beyond the last moment above 1e-4. Empty where the moments are not that small
// by MaximumLegendreDegree: such a phase function has too narrow a peak.
VTKAIRLIGHT_EXPORT std::vector<double> GetLegendreMoments(
  const std::function<double(double)>& phaseFunction);

// Those from 0 to a degree, however large they are.
VTKAIRLIGHT_EXPORT std::vector<double> GetLegendreMomentsTo(
  int degree, const std::function<double(double)>& phaseFunction);
}

#endif
