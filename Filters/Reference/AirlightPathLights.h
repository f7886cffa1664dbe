// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights that paths of light are joined to: which one, and what arrives from it at a place.
 */

#ifndef AirlightPathLights_h
#define AirlightPathLights_h

#include "Reference/AirlightPathDirections.h"
#include "Reference/AirlightReferenceTracer.h"

namespace airlight
{
class PathLights
{
public:
  // Those of the scene that scatter and shine.
  explicit PathLights(const ReferenceTracer& tracer);

  bool IsEmpty() const { return this->Lights.empty(); }

  struct Choice
  {
    const ReferenceLight* Light;
    double Probability;
    bool HasPlace() const { return !f64::airlightIsDirectional(this->Light->Values); }
  };

  // One of them, half at random and half by what it would send to the position without a medium;
  // positions are relative to the eye.
  Choice Choose(const glm::dvec3& position, RandomNumbers& random) const;

  // Unit.
  static glm::dvec3 GetDirection(const ReferenceLight& light, const glm::dvec3& position);

  // What arrives at a position across its direction: radiant intensity over squared distance, or
  // irradiance, less what the media take; 0 in shadow. `toLight`: unit. `margin` around the
  // position is free of shadows.
  glm::dvec3 GetArriving(const ReferenceLight& light, const glm::dvec3& position, double margin,
    bool shadows, glm::dvec3& toLight) const;

  // About how much lights do at a position, to weigh paths by: 1 near them, and from about twice
  // their distance from the eye on less than the inverse of the distance, as paths may come back.
  double GetImportance(const glm::dvec3& position) const;

private:
  const ReferenceTracer& Tracer;
  std::vector<const ReferenceLight*> Lights;
  double Reach = 0.0; // of the importance; 0: it is 1 everywhere
};
}

#endif
