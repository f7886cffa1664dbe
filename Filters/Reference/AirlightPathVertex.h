// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a path of light is scattered or reflected, and how.
 */

#ifndef AirlightPathVertex_h
#define AirlightPathVertex_h

#include "Reference/AirlightPathDirections.h"
#include "Reference/AirlightPathSegment.h"
#include "Reference/AirlightReferenceSurface.h"

#include <vector>

namespace airlight
{
// The media, and random directions by each one's phase function.
struct PathMedia
{
  explicit PathMedia(const f64::AirlightMedia& media);

  const f64::AirlightMedia& Media;
  std::vector<PhaseDirections> Phases;
};

class PathVertex
{
public:
  // To a place of a segment in the media; the weight grows by `factor`, the transmittance and the
  // scattering coefficient.
  void EnterMedium(const PathSegment& segment, double t, double factor);

  // To the surface that ends a segment; the weight grows by `factor`, the transmittance and the
  // albedo.
  void EnterSurface(const ReferenceSurface& surface, const OccluderTriangle& triangle,
    const PathSegment& segment, double factor);

  // Of the direction from which light comes, drawn by phase function or cosine.
  glm::dvec3 SampleDirection(const PathMedia& media, RandomNumbers& random) const;
  // Its density per solid angle.
  double GetDensity(const PathMedia& media, const glm::dvec3& direction) const;
  // The share, per solid angle, of the weight that comes from a direction.
  glm::dvec3 GetScattering(const PathMedia& media, const glm::dvec3& direction) const;

  double GetLargestWeight() const
  {
    return glm::max(this->Weight.x, glm::max(this->Weight.y, this->Weight.z));
  }
  // Shares of colours by the weight; their sum is 1.
  glm::dvec3 GetShares() const;

  glm::dvec3 Position{ 0.0 }; // from the eye
  glm::dvec3 Weight{ 1.0 };
  bool OnSurface = false;
  double T = 0.0; // along the segment that led to it

private:
  glm::dvec3 Direction{ 0.0 }; // in which the path came
  PathPlace Place;             // in a medium
  glm::dvec3 Normal{ 0.0 };    // of a surface, as it is shaded
  glm::dvec3 Flat{ 0.0 };      // and as it is, on the viewer's side
};
}

#endif
