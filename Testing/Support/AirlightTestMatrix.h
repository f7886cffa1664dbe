// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The matrix of lights x regions x densities x phase functions.
 */

#ifndef AirlightTestMatrix_h
#define AirlightTestMatrix_h

#include "AirlightTestPhaseTable.h"
#include "AirlightTestSurfaces.h"
#include "AirlightTestTools.h"

#include "vtkDrainePhaseFunction.h"
#include "vtkLight.h"
#include "vtkParticipatingMedium.h"
#include "vtkSmartPointer.h"

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

// vtkParticipatingMedium's; a surface is a mesh of the box. Cylinders have tests of their own.
constexpr int MATRIX_REGIONS = 4;

enum MatrixPhase
{
  MATRIX_ISOTROPIC,
  MATRIX_FORWARD,  // Henyey and Greenstein's, g = 0.6
  MATRIX_BACKWARD, // the same, g = -0.4
  MATRIX_RAYLEIGH,
  MATRIX_SCHLICK,         // k = 0.5
  MATRIX_CORNETTE_SHANKS, // g = 0.5
  MATRIX_MIE_HAZY,
  MATRIX_MIE_MURKY,
  MATRIX_TABLE, // TABLE_SMOOTH of AirlightTestPhaseTable.h; MATRIX_TABLE + any other TestTable
  MATRIX_PHASES
};

// Draine's function has tests of its own, too.
constexpr int MATRIX_DRAINE = -2; // g = 0.6, alpha = 5
constexpr int MATRIX_FOG = -1;    // g = 0.95, alpha = 30, which no fit follows

struct MatrixCell
{
  int Light;
  int Region;
  int Density;
  int Phase;

  bool IsSpot() const { return this->Light == MATRIX_SPOT || this->Light == MATRIX_SPOT_EXPONENT; }

  std::string Describe() const
  {
    static const char* const lights[] = { "point", "spot", "spot^4", "sun", "falloff" };
    static const char* const regions[] = { "unbounded", "box", "sphere", "surface", "cylinder" };
    static const char* const phases[] = { "isotropic", "HG 0.6", "HG -0.4", "Rayleigh",
      "Schlick 0.5", "Cornette-Shanks 0.5", "Mie hazy", "Mie murky" };
    const std::string phase = this->Phase < 0 ? (this->Phase == MATRIX_FOG ? "fog" : "Draine")
      : this->Phase < MATRIX_TABLE            ? phases[this->Phase]
                                              : TestTableName(this->Phase - MATRIX_TABLE);
    return Text(lights[this->Light], ", ", regions[this->Region], ", ",
      this->Density == vtkParticipatingMedium::UNIFORM ? "uniform" : "height", ", ", phase);
  }

  // What the headers of vtkAirlight and vtkParticipatingMedium say of point lights, spots and
  // directional lights, and of phase functions that are poles or not; along a ray, a directional
  // light has one angle.
  // `mieToo`: or would have one but for Mie's function, which the pass integrates as exactly.
  bool HasClosedForm(bool lightInside, vtkParticipatingMedium* medium, bool mieToo = false) const
  {
    const bool uniform = this->Density == vtkParticipatingMedium::UNIFORM;
    const bool unbounded = this->Region == vtkParticipatingMedium::UNBOUNDED;
    if (this->Region == vtkParticipatingMedium::SURFACE)
    {
      return false;
    }
    if (this->Light == MATRIX_SUN)
    {
      return unbounded || (uniform && this->Region == vtkParticipatingMedium::BOX);
    }
    const bool mie = this->Phase == MATRIX_MIE_HAZY || this->Phase == MATRIX_MIE_MURKY;
    const bool smooth = mie ? mieToo : medium->GetNumberOfPhasePoles() > 0;
    return uniform && (unbounded || lightInside) && smooth &&
      (this->Light == MATRIX_POINT || this->Light == MATRIX_SPOT);
  }

  // The kinds of things; where they are and how dense is the caller's.
  void Apply(vtkParticipatingMedium* medium, vtkLight* light) const
  {
    medium->SetRegion(this->Region);
    medium->SetDensity(this->Density);
    this->ApplyPhase(medium);
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

  void ApplyPhase(vtkParticipatingMedium* medium) const
  {
    using Medium = vtkParticipatingMedium;
    if (this->Phase < 0)
    {
      const bool fog = this->Phase == MATRIX_FOG;
      static vtkSmartPointer<vtkDrainePhaseFunction> functions[2]; // each is fitted once
      vtkSmartPointer<vtkDrainePhaseFunction>& function = functions[fog ? 1 : 0];
      function = function ? function : vtkSmartPointer<vtkDrainePhaseFunction>::New();
      function->SetAnisotropy(fog ? 0.95 : 0.6);
      function->SetAlpha(fog ? 30.0 : 5.0);
      medium->SetPhaseFunction(function);
      return;
    }
    static const int types[] = { Medium::ISOTROPIC, Medium::HENYEY_GREENSTEIN,
      Medium::HENYEY_GREENSTEIN, Medium::RAYLEIGH, Medium::SCHLICK, Medium::CORNETTE_SHANKS,
      Medium::MIE_HAZY, Medium::MIE_MURKY, Medium::TABULATED };
    static const double anisotropies[] = { 0.0, 0.6, -0.4, 0.0, 0.5, 0.5, 0.0, 0.0, 0.0 };
    static vtkSmartPointer<vtkTable> tables[TEST_TABLES];
    const int index = std::min<int>(this->Phase, MATRIX_TABLE);
    medium->SetPhaseFunction(types[index]);
    medium->SetAnisotropy(anisotropies[index]);
    if (index == MATRIX_TABLE)
    {
      vtkSmartPointer<vtkTable>& table = tables[this->Phase - MATRIX_TABLE];
      table = table ? table : MakeTable(this->Phase - MATRIX_TABLE);
      medium->SetPhaseTable(table);
    }
  }
};

// Gives the medium these bounds as a box and as a mesh.
inline void SetBox(vtkParticipatingMedium* medium, const Box& box)
{
  medium->SetBounds(box.data());
  medium->SetSurface(MakeBoxMesh(box));
}

// Calls run(cell) for all 360 cells, phase by phase, because fits take their time.
template <typename Run>
void ForEachCell(const Run& run)
{
  for (int phase = 0; phase < MATRIX_PHASES; ++phase)
  {
    for (int light = 0; light < MATRIX_LIGHTS; ++light)
    {
      for (int region = 0; region < MATRIX_REGIONS; ++region)
      {
        for (int density = 0; density < 2; ++density)
        {
          run(MatrixCell{ light, region, density, phase });
        }
      }
    }
  }
}
}

#endif
