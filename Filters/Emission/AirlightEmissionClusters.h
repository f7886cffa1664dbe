// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A density in space as a few clusters, by weighted k-means.
 */

#ifndef AirlightEmissionClusters_h
#define AirlightEmissionClusters_h

#include "Integration/AirlightMath.h"

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
struct EmissionCluster
{
  glm::dvec3 Centre{ 0.0 };
  double Weight = 0.0;     // the integral of the density times the emission's mean factor
  double Radius = 0.0;     // of a ball of the same second moment
  glm::dvec3 Power{ 0.0 }; // the integral of the emission coefficient
};

// The density of a bounded medium as a sum of small parts.
std::vector<EmissionCluster> SampleEmission(const f64::AirlightMedium& medium);

// At most `count` clusters of the parts, from these centres on or, without any, from those parts
// that are heavy and far from each other. Clusters without weight are last.
std::vector<EmissionCluster> FindClusters(
  const std::vector<EmissionCluster>& parts, int count, const std::vector<glm::dvec3>& centres);
}

#endif
