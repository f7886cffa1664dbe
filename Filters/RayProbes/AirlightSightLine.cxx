// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RayProbes/AirlightSightLine.h"

#include "RayProbes/AirlightFilterInput.h"

#include "vtkMath.h"

#include <algorithm>

namespace airlight
{
namespace
{
double Mean(const glm::dvec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3.0; }

double Contrast(double letters, double ground, double veil)
{
  const double sum = letters + ground + 2.0 * veil;
  return sum > 0.0 ? (letters - ground) / sum : 0.0;
}
}

//------------------------------------------------------------------------------
double FindMeanExtinction(const Probe& probe, const glm::dvec3& eye, const glm::dvec3& point)
{
  const f64::AirlightMedia media = ConvertMedia(probe.Media, eye);
  const double length = glm::distance(eye, point);
  if (length > 0.0)
  {
    return Mean(f64::airlightDepthBetween(media, glm::dvec3(0.0), point - eye)) / length;
  }
  // The density at the eye itself, from a way so short that it is the same all along.
  const glm::dvec3 step(1e-6, 0.0, 0.0);
  return Mean(f64::airlightDepthBetween(media, -step, step)) / (2.0 * step.x);
}

//------------------------------------------------------------------------------
double GetVisibility(double factor, double extinction, double most)
{
  return extinction > 0.0 ? std::min(factor / extinction, most) : most;
}

//------------------------------------------------------------------------------
SignContrast FindContrast(const Sign& sign, const glm::dvec3& irradiance,
  const glm::dvec3& airlight, const glm::dvec3& transmittance)
{
  const glm::dvec3 reflected = irradiance / vtkMath::Pi();
  const glm::dvec3 letters = sign.Radiance + sign.Reflectance * reflected;
  const glm::dvec3 ground = sign.GroundReflectance * reflected;
  return { Contrast(Mean(letters * transmittance), Mean(ground * transmittance), Mean(airlight)),
    Contrast(Mean(letters), Mean(ground), 0.0) };
}
}
