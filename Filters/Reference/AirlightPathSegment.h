// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A straight part of a path of light through the media. Its optical depth is exact everywhere, also
 * in images of density, so that free flights are drawn by inverting it: no majorant, no fictitious
 * collisions, and each place's density is known.
 */

#ifndef AirlightPathSegment_h
#define AirlightPathSegment_h

#include "Integration/AirlightMath.h"
#include "Reference/AirlightRandomNumbers.h"

#include <vector>

namespace airlight
{
// A place on a segment.
struct PathPlace
{
  double T = 0.0;
  glm::dvec3 Position{ 0.0 };
  double Density[AIRLIGHT_MAX_MEDIA] = {};        // of each medium; 0 outside it
  glm::dvec3 Scattering[AIRLIGHT_MAX_MEDIA] = {}; // likewise
  glm::dvec3 SigmaS{ 0.0 };                       // of all media together
  glm::dvec3 SigmaT{ 0.0 };
  glm::dvec3 Transmittance{ 1.0 }; // from the segment's origin
};

class PathSegment
{
public:
  // Up to `end`, AIRLIGHT_FAR at most.
  PathSegment(const f64::AirlightMedia& media, const glm::dvec3& origin,
    const glm::dvec3& direction, double end);

  const glm::dvec3& GetOrigin() const { return this->Origin; }
  const glm::dvec3& GetDirection() const { return this->Direction; }
  double GetEnd() const { return this->End; }
  const glm::dvec3& GetTransmittance() const { return this->Passed; } // of all of it

  // The part of it between the first and the last medium; from >= to: there is none.
  double GetFrom() const { return this->Pieces.empty() ? this->End : this->Pieces.front().from; }
  double GetTo() const { return this->Pieces.empty() ? 0.0 : this->Pieces.back().to; }

  PathPlace GetPlace(double t) const;

  // What is scattered at a place by an angle, without what fades.
  glm::dvec3 GetScattered(const PathPlace& place, double cosine) const;

  // A free flight of a colour that is drawn by these shares, whose sum is 1. False where it passes
  // all of the segment.
  bool SampleFlight(const glm::dvec3& shares, RandomNumbers& random, double& t) const;

  // The density of flights that end at a place, and the share of those that do not end.
  static double GetFlightDensity(const glm::dvec3& shares, const PathPlace& place)
  {
    return glm::dot(shares, place.SigmaT * place.Transmittance);
  }
  double GetPassing(const glm::dvec3& shares) const { return glm::dot(shares, this->Passed); }

private:
  double FindInPiece(const f64::AirlightPiece& piece, int channel, double depth) const;

  const f64::AirlightMedia& Media;
  glm::dvec3 Origin;
  glm::dvec3 Direction;
  double End;
  glm::dvec3 Passed{ 1.0 };
  std::vector<f64::AirlightPiece> Pieces; // those with a medium
  std::vector<glm::dvec3> Depths;         // at their ends
};
}

#endif
