// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far an eye sees along a line through media, and how well a sign at its end. Behind
 * vtkAirlightProbeFilter::SetSightLines().
 */

#ifndef AirlightSightLine_h
#define AirlightSightLine_h

#include "RayProbes/AirlightProbe.h"

namespace airlight
{
// The letters and the ground that they stand on.
struct Sign
{
  double Radiance; // of letters that shine
  double Reflectance;
  double GroundReflectance;
};

// Michelson's contrast (letters - ground)/(letters + ground), 0 where both are dark.
struct SignContrast
{
  double Seen;            // through the media
  double WithoutAirlight; // through media that absorb only
};

// Mean of the three channels' extinctions, averaged along the way; at the eye, that there.
double FindMeanExtinction(const Probe& probe, const glm::dvec3& eye, const glm::dvec3& point);

// factor/extinction, at most `most`.
double GetVisibility(double factor, double extinction, double most);

// A sign that receives `irradiance`, behind `airlight` and seen with `transmittance`; of means over
// the three channels.
SignContrast FindContrast(const Sign& sign, const glm::dvec3& irradiance,
  const glm::dvec3& airlight, const glm::dvec3& transmittance);
}

#endif
