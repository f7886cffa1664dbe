// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The source function of multiply scattered light, of UnboundedSolution, as the coefficients that
 * AirlightSourceFunction.glsl evaluates. Interpolated at Chebyshev nodes. Not installed; exported
 * for the module's own tests.
 */

#ifndef AirlightSourceFit_h
#define AirlightSourceFit_h

#include "Integration/AirlightMath.h"
#include "vtkAirlightModule.h" // for export macro

#include <vector>

namespace airlight
{
struct SourceFit
{
  f64::AirlightMultiple Coefficients{}; // without lamps
  // The largest error relative to J, between the nodes; where J is below a hundredth of what it is
  // in its brightest direction, relative to that hundredth.
  double ErrorBound = 0.0;
};

// Of an albedo for each channel, each in [0, 1], and the phase function's Legendre moments.
VTKAIRLIGHT_EXPORT SourceFit FitSource(
  const glm::dvec3& albedo, const std::vector<double>& legendre);
}

#endif
