// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random directions of paths and places on them, with their densities.
 */

#ifndef AirlightPathDirections_h
#define AirlightPathDirections_h

#include "Integration/AirlightMath.h"
#include "Reference/AirlightPathSegment.h"
#include "Reference/AirlightRandomNumbers.h"

#include <vector>

namespace airlight
{
// The unit vector at an angle to a unit axis, anywhere round it.
glm::dvec3 TurnFrom(const glm::dvec3& axis, double cosine, double sine, double turn);

// Directions by a phase function of any shape: constant in the cosine in each of many cells.
class PhaseDirections
{
public:
  explicit PhaseDirections(const f64::AirlightPhase& phase);

  // Of the cosine of the angle to the direction of travel.
  double SampleCosine(RandomNumbers& random) const;
  // Per solid angle.
  double GetDensity(double cosine) const;

private:
  std::vector<double> Cosines; // descending, from 1 to -1
  std::vector<double> Shares;  // ascending, from 0 to 1
};

// Directions round one axis with the density 1/(2 pi^2 sin(angle)): the light that a ray gathers
// from a lamp at a place grows as the inverse of its distance, and this density with it.
struct LampDirections
{
  static glm::dvec3 Sample(const glm::dvec3& toLamp, RandomNumbers& random);
  static double GetDensity(const glm::dvec3& toLamp, const glm::dvec3& direction);
};

// Directions above a surface with the density cosine/pi.
glm::dvec3 SampleCosineLobe(const glm::dvec3& normal, RandomNumbers& random);

// Places on the part of a segment with media, uniform in the angle seen from the lamp (Kulla and
// Fajardo, 2012).
class EquiangularPlaces
{
public:
  EquiangularPlaces(const glm::dvec3& lamp, double radius, const PathSegment& segment);

  bool IsEmpty() const { return !(this->First < this->Last); }
  double Sample(RandomNumbers& random) const;
  double GetDensity(double t) const;

private:
  double From;
  double To;
  double Foot;
  double H;
  double First; // angles
  double Last;
};
}

#endif
