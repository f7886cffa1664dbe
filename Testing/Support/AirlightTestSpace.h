// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The expected airlight of a point light of any attenuation in a medium of any region: quadrature
 * along the ray, with the lengths inside the medium found by cutting at the region's planes. Of
 * the library it uses the medium's properties only.
 */

#ifndef AirlightTestSpace_h
#define AirlightTestSpace_h

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkParticipatingMedium.h"

#include <glm/glm.hpp>

namespace airlight_test
{
// Another density at each call, another anisotropy (whose fit takes time) at every twentieth.
void SetRandomMedium(vtkParticipatingMedium* medium, Random& random, int i);

// Length of the way from a to b inside the medium: the way is cut at all six planes, and the
// pieces whose middle lies in the box count.
double InsideLength(vtkParticipatingMedium* medium, const glm::dvec3& a, const glm::dvec3& b);

//------------------------------------------------------------------------------
// A point light of strength 1/(a + b r + c r^2) and a ray, in space.
struct PointCase
{
  glm::dvec3 Light;
  glm::dvec3 Attenuation;
  glm::dvec3 Origin;
  glm::dvec3 Direction; // unit
  double T0;
  double T1;

  std::string Describe() const
  {
    return Text("light ", Text3(&this->Light.x), ", attenuation ", Text3(&this->Attenuation.x),
      ", origin ", Text3(&this->Origin.x), ", direction ", Text3(&this->Direction.x), ", [",
      this->T0, ", ", this->T1, "]");
  }
};

// The range of [T0, T1] inside the medium: from the closest to the farthest cut that holds it.
glm::dvec2 InsideRange(vtkParticipatingMedium* medium, const PointCase& c);

void ComparePoint(vtkParticipatingMedium* medium, const PointCase& c, const double rgb[3],
  const double intensity[3], double limit, Comparison& comparison);
}

#endif
