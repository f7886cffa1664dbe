// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light that reaches the eye after it was scattered or reflected at least twice, by random paths
 * from the eye. What was scattered or reflected once is ReferenceTracer's, without noise.
 *
 * At each vertex a path gathers what one light sends to the next segment: once in the direction in
 * which the path goes on and once in one drawn around the light, and on both segments at a place
 * drawn by angle and at one drawn by free flight. The vertex itself is one of two, likewise. Each
 * pair is weighted by the balance heuristic (Veach 1997), so that no lamp at a place, however near,
 * makes a path's radiance unbounded. Flights are drawn of one colour at random and weighted by the
 * density of all three.
 */

#ifndef AirlightPathTracer_h
#define AirlightPathTracer_h

#include "Reference/AirlightPathRay.h"
#include "vtkAirlightModule.h" // for export macro

namespace airlight
{
// What one path, or the mean of many, adds to a pixel.
struct PathRadiance
{
  glm::dvec3 Radiance{ 0.0 }; // behind translucent layers less than the other two
  glm::dvec3 Airlight{ 0.0 };
  glm::dvec3 Surface{ 0.0 };
};

class VTKAIRLIGHT_EXPORT PathTracer
{
public:
  // `orders`: the most times that light is scattered or reflected, from 2 on; 0: any number.
  PathTracer(const ReferenceTracer& tracer, int orders);

  // One path along an eye's ray.
  PathRadiance Trace(const ReferenceTracer::EyeRay& eye, RandomNumbers& random) const;

private:
  using Choice = std::optional<PathLights::Choice>; // none without lights

  // Where a path goes on, and by what its weight changes with the direction.
  struct Turn
  {
    PathRay Ray;
    glm::dvec3 Factor;
  };

  bool FindFirst(
    const ReferenceTracer::EyeRay& eye, RandomNumbers& random, PathVertex& vertex) const;
  bool Survives(PathVertex& vertex, int order, double first, RandomNumbers& random) const;
  glm::dvec3 Gather(PathVertex vertex, RandomNumbers& random) const;
  Choice Choose(const PathVertex& vertex, RandomNumbers& random) const;
  std::optional<Turn> GatherAround(const PathVertex& vertex, const Choice& choice, double share,
    double aim, glm::dvec3& sum, RandomNumbers& random) const;
  double GatherBeside(const PathVertex& vertex, const Turn& turn, const Choice& choice,
    glm::dvec3& sum, RandomNumbers& random) const;

  const ReferenceTracer& Tracer;
  PathMedia Media;
  PathLights Lights;
  int Orders;
};
}

#endif
