// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A segment of a path with the surface that ends it, and what it gathers from lights.
 */

#ifndef AirlightPathRay_h
#define AirlightPathRay_h

#include "Reference/AirlightPathLights.h"
#include "Reference/AirlightPathVertex.h"

#include <optional>

namespace airlight
{
class PathRay
{
public:
  // From a position in a medium, or on a surface.
  PathRay(const ReferenceTracer& tracer, const PathVertex& from, const glm::dvec3& direction);

  const PathSegment& GetSegment() const { return this->Segment; }

  // Draws where light is scattered next, if it is before the end, by the colours' shares.
  void SampleFlight(const glm::dvec3& shares, RandomNumbers& random);

  // Where the flight ends, null if it passes all of the segment; the density of flights that end at
  // a place.
  const PathPlace* GetFlight() const { return this->Flight ? &*this->Flight : nullptr; }
  double GetFlightDensity(const PathPlace& place) const
  {
    return PathSegment::GetFlightDensity(this->Shares, place);
  }

  // After SampleFlight(): what it gathers from a light that is scattered or reflected once on it.
  // In the media at a place drawn by angle and at the end of the flight, each weighted by both
  // densities.
  glm::dvec3 Gather(
    const PathLights& lights, const ReferenceLight& light, RandomNumbers& random) const;

  // What shines by itself along it: the ambient light of media and surfaces.
  glm::dvec3 GetEmission() const;

  // After SampleFlight(): moves a vertex on. False if no light comes from there.
  bool Move(PathVertex& vertex) const;

private:
  glm::dvec3 GatherAt(
    const PathLights& lights, const ReferenceLight& light, const PathPlace& place) const;
  glm::dvec3 GatherAtEnd(const PathLights& lights, const ReferenceLight& light) const;

  const ReferenceTracer& Tracer;
  const OccluderTriangle* Triangle = nullptr;
  PathSegment Segment;
  std::optional<ReferenceSurface> Surface;
  glm::dvec3 Shares{ 0.0 };
  std::optional<PathPlace> Flight;
};
}

#endif
