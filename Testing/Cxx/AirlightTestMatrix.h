// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The matrix of lights x regions x densities x phase functions.
 */

#ifndef AirlightTestMatrix_h
#define AirlightTestMatrix_h

#include "AirlightTestTools.h"

#include "vtkLight.h"
#include "vtkParticipatingMedium.h"

#include <glm/glm.hpp>

namespace airlight_test
{
enum MatrixLight
{
  MATRIX_POINT,
  MATRIX_SPOT,          // exponent 0
  MATRIX_SPOT_EXPONENT, // exponent 4
  MATRIX_SUN,
  MATRIX_FALLOFF, // attenuation (1, 0.1, 0.02)
  MATRIX_LIGHTS
};

inline glm::dvec3 RandomUnit(Random& random)
{
  glm::dvec3 v;
  do
  {
    v = { random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) };
  } while (glm::length(v) < 0.1 || glm::length(v) > 1.0);
  return glm::normalize(v);
}

struct MatrixCell
{
  int Light;
  int Region;
  int Density;
  double G; // 0: isotropic

  bool IsSpot() const { return this->Light == MATRIX_SPOT || this->Light == MATRIX_SPOT_EXPONENT; }

  std::string Describe() const
  {
    static const char* const lights[] = { "point", "spot", "spot^4", "sun", "falloff" };
    static const char* const regions[] = { "unbounded", "box", "sphere" };
    return Text(lights[this->Light], ", ", regions[this->Region], ", ",
      this->Density == vtkParticipatingMedium::UNIFORM ? "uniform" : "height", ", g ", this->G);
  }

  // What the header of vtkAirlight says of point lights, spots and directional lights.
  bool HasClosedForm(bool lightInside) const
  {
    const bool uniform = this->Density == vtkParticipatingMedium::UNIFORM;
    const bool unbounded = this->Region == vtkParticipatingMedium::UNBOUNDED;
    if (this->Light == MATRIX_SUN)
    {
      return unbounded || (uniform && this->Region == vtkParticipatingMedium::BOX);
    }
    return uniform && (unbounded || lightInside) &&
      (this->Light == MATRIX_POINT || this->Light == MATRIX_SPOT);
  }

  // The kinds of things; where they are and how dense is the caller's.
  void Apply(vtkParticipatingMedium* medium, vtkLight* light) const
  {
    medium->SetRegion(this->Region);
    medium->SetDensity(this->Density);
    medium->SetPhaseFunction(this->G == 0.0 ? vtkParticipatingMedium::ISOTROPIC
                                            : vtkParticipatingMedium::HENYEY_GREENSTEIN);
    medium->SetAnisotropy(this->G);
    light->SetLightTypeToSceneLight();
    light->SetPositional(this->Light != MATRIX_SUN);
    light->SetConeAngle(this->IsSpot() ? 35.0 : 90.0); // VTK's cone angle is the half angle
    light->SetExponent(this->Light == MATRIX_SPOT_EXPONENT ? 4.0 : 0.0);
    light->SetAttenuationValues(0.0, 0.0, 1.0);
    if (this->Light == MATRIX_FALLOFF)
    {
      light->SetAttenuationValues(1.0, 0.1, 0.02);
    }
  }
};

// Calls run(cell) for all 60 cells.
template <typename Run>
void ForEachCell(const Run& run)
{
  for (int light = 0; light < MATRIX_LIGHTS; ++light)
  {
    for (int region = 0; region < 3; ++region)
    {
      for (int density = 0; density < 2; ++density)
      {
        for (const double g : { 0.0, 0.6 })
        {
          run(MatrixCell{ light, region, density, g });
        }
      }
    }
  }
}
}

#endif
