// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Photometry/AirlightBlackbody.h"

#include <cmath>

namespace airlight
{
namespace
{
// nm
constexpr int Shortest = 360;
constexpr int Longest = 830;
constexpr int Step = 2;

// Spectral radiance, W/(m^2 sr nm).
double GetPlanck(double wavelength, double temperature)
{
  constexpr double First = 1.191042972e-16; // 2 h c^2, W m^2
  constexpr double Second = 1.438776877e-2; // h c / k, m K
  const double metres = 1e-9 * wavelength;
  return 1e-9 * First / (std::pow(metres, 5) * std::expm1(Second / (metres * temperature)));
}

// A bell of another width on either side.
double GetLobe(double wavelength, double peak, double below, double above)
{
  const double x = (wavelength - peak) / (wavelength < peak ? below : above);
  return std::exp(-0.5 * x * x);
}

// The colour matching functions of the CIE 1931 observer as fitted by Wyman, Sloan and Shirley,
// "Simple Analytic Approximations to the CIE XYZ Color Matching Functions" (JCGT 2013).
glm::dvec3 GetObserver(double w)
{
  return { 1.056 * GetLobe(w, 599.8, 37.9, 31.0) + 0.362 * GetLobe(w, 442.0, 16.0, 26.7) -
      0.065 * GetLobe(w, 501.1, 20.4, 26.2),
    0.821 * GetLobe(w, 568.8, 46.9, 40.5) + 0.286 * GetLobe(w, 530.9, 16.3, 31.1),
    1.217 * GetLobe(w, 437.0, 11.8, 36.0) + 0.681 * GetLobe(w, 459.0, 26.0, 13.8) };
}
}

//------------------------------------------------------------------------------
glm::dvec3 GetBlackbodyRadiance(double temperature)
{
  glm::dvec3 xyz(0.0);
  for (int w = Shortest; w <= Longest; w += Step)
  {
    xyz += static_cast<double>(Step) * GetPlanck(w, temperature) * GetObserver(w);
  }
  // Columns; IEC 61966-2-1.
  const glm::dmat3 toRGB(glm::dvec3(3.2406255, -0.9689307, 0.0557101),
    glm::dvec3(-1.5372080, 1.8757561, -0.2040211), glm::dvec3(-0.4986286, 0.0415175, 1.0569959));
  return glm::max(toRGB * xyz, glm::dvec3(0.0));
}
}
