// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What lights in a medium do at one point. Behind vtkAirlightProbeFilter.
 */

#ifndef AirlightProbe_h
#define AirlightProbe_h

#include "Occlusion/AirlightOccluders.h"

#include <glm/glm.hpp>

#include <vector>

class vtkLight;
class vtkParticipatingMedium;

namespace airlight
{
// Thread safe after CheckSceneLight() for each light.
struct Probe
{
  std::vector<vtkParticipatingMedium*> Media;
  std::vector<vtkLight*> Lights;
  const Occluders* Shades;

  // From the media between the two points to the first one.
  glm::dvec3 FindRadiance(const glm::dvec3& eye, const glm::dvec3& point) const;

  glm::dvec3 FindTransmittance(const glm::dvec3& eye, const glm::dvec3& point) const;

  // On a surface with this unit normal, without one (null) on one that faces each light.
  // Occluders do not count nearer than `margin` to the point and the lights.
  glm::dvec3 FindDirect(const glm::dvec3& point, const glm::dvec3* normal, double margin) const;

  // On a surface with this unit normal, of light scattered once.
  glm::dvec3 FindScattered(const glm::dvec3& point, const glm::dvec3& normal) const;
};
}

#endif
