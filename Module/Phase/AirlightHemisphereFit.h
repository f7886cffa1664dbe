// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a phase function scatters into a ray of light from a sky that is 1 above the horizon and -1
 * below it, as a function of the height of the ray's direction. Not installed; exported for the
 * module's own tests.
 */

#ifndef AirlightHemisphereFit_h
#define AirlightHemisphereFit_h

#include "vtkAirlightModule.h" // for export macro

#include <array>
#include <functional>

namespace airlight
{
// The integral over [0, pi] of the phase function times sin(theta) times the light on the ring of
// directions at the scattering angle theta from the ray; x is the sine of the ray's elevation.
VTKAIRLIGHT_EXPORT double IntegrateHemisphere(
  const std::function<double(double)>& phaseFunction, double x);

// It as a sum of Chebyshev polynomials of odd degree, Odd[k] T_(2k+1)(y), of the angle
// y = atan(x/Width)/atan(1/Width): a peak of the phase function makes it steep at the horizon,
// where it is about an arcus tangent.
struct HemisphereFit
{
  double Width = 1.0;
  std::array<double, 12> Odd{};
};

VTKAIRLIGHT_EXPORT HemisphereFit FitHemisphere(const std::function<double(double)>& phaseFunction);
}

#endif
