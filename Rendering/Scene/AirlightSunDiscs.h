// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Suns that are seen as bright discs in the sky: vtkAirlightLight::SetVisible() for directional
 * lights. They are behind everything, so that the composite adds them where a ray has no end.
 */

#ifndef AirlightSunDiscs_h
#define AirlightSunDiscs_h

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;
class vtkShaderProgram;

namespace airlight
{
struct SunDisc
{
  glm::dvec3 Towards{ 0.0 }; // its middle, of length 1
  double Chord = 0.0;        // from there to its border, on the unit sphere
  glm::dvec3 Radiance{ 0.0 };
};

// Those of a renderer's lights, the first MaximumSunDiscs; none in a parallel projection, whose
// rays all have one direction.
constexpr std::size_t MaximumSunDiscs = 16;
std::vector<SunDisc> CollectSunDiscs(vtkRenderer* renderer);

// Whether a directional light was set to be visible, though nothing is seen of it.
bool IsInvisibleSun(vtkLight* light);

// The shader's airlightSunDiscs(), empty without suns, and its uniforms.
std::string GetSunSource(const std::vector<SunDisc>& suns);
void SetSunUniforms(vtkShaderProgram* program, const std::vector<SunDisc>& suns);
}

#endif
