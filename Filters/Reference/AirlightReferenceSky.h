// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The light of media's skies that reaches a ray, by quadrature over the directions it comes from,
 * without the moments and the fit that the formulas of vtkAirlight have.
 */

#ifndef AirlightReferenceSky_h
#define AirlightReferenceSky_h

#include "Integration/AirlightMath.h"

#include <array>
#include <vector>

class vtkParticipatingMedium;

namespace airlight
{
class ReferenceSky
{
public:
  explicit ReferenceSky(vtkParticipatingMedium* medium);

  // The ambient radiance that the medium scatters into a ray of unit direction.
  glm::dvec3 GetAmbient(const glm::dvec3& direction) const;

private:
  struct Ring // of directions at one scattering angle
  {
    double Cosine;
    double Sine;
    double Weight; // the phase function is included
  };

  double GetShareAbove(const Ring& ring, double rise) const;
  glm::dvec3 GetRadiance(const glm::dvec3& from) const; // by harmonics

  std::vector<Ring> Rings;
  glm::dvec3 Even{ 0.0 };
  glm::dvec3 Above{ 0.0 };
  glm::dvec3 Below{ 0.0 };
  glm::dvec3 Up{ 0.0 };
  std::array<glm::dvec3, 9> Harmonics{};
};

// The media with the ambient light of one direction, for those that have a sky.
f64::AirlightMedia WithSkies(const f64::AirlightMedia& media,
  const std::vector<ReferenceSky>& skies, const glm::dvec3& direction);
}

#endif
