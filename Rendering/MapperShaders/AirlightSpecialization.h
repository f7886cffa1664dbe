// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Uniforms of VTK's surface shaders that become constants, since their values are known when a
 * shader is made: the types of lights, and coefficients of materials.
 *
 * Software renderers run the code of every type of light, and take as long for a reflection that is
 * multiplied by 0 as for any other (figures: Documentation/benchmarks.md).
 */

#ifndef AirlightSpecialization_h
#define AirlightSpecialization_h

#include "Scene/AirlightSceneLights.h"

#include "vtkAirlightModule.h" // for export macro

#include <cstddef>
#include <string>
#include <vector>

namespace airlight
{
// So many lights have lines of their own in the shaders; more share a loop: for them, compilers
// take longer than the shaders save.
constexpr size_t MaximumSpecializedLights = 8;

struct LightSpecialization
{
  bool Scatters = true;     // else as VTK shades it: without power, or refused
  bool Sun = false;         // at infinity, for the medium
  bool Goniometric = false; // shines by a photometric file
  // As VTK's shading has it.
  bool Positional = false;
  bool Spot = false;
  bool InverseSquare = false; // fades with the distance's square and nothing else
};
bool operator==(const LightSpecialization& a, const LightSpecialization& b);

// Of a vtkProperty.
struct MaterialSpecialization
{
  bool NoAmbient = false;   // GetAmbient() is 0
  bool FullDiffuse = false; // GetDiffuse() is 1
  bool NoSpecular = false;  // GetSpecular() is 0
  bool Opaque = false;      // GetOpacity() is 1
};

// What is known when a surface's shader is made.
struct SpecializationKey
{
  std::vector<LightSpecialization> Lights; // each light; empty if there are too many
  MaterialSpecialization Material;
};

// Each light; none if there are too many.
std::vector<LightSpecialization> SpecializeLights(const std::vector<SceneLight>& sceneLights);

// Makes constants of the uniforms whose values follow from the key.
VTKAIRLIGHT_EXPORT void SpecializeShader(std::string& fragmentShader, const SpecializationKey& key);
}

#endif
