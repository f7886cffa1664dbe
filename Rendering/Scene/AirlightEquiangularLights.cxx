// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightEquiangularLights.h"

#include "AirlightConstants.h"
#include "AirlightEquiangular.h"
#include "AirlightEquiangularPanel.h"
#include "AirlightGoniometricArc.h"
#include "AirlightHalfAngle.h"
#include "AirlightHeightFogLamp.h"
#include "Medium/AirlightConvert.h"
#include "Phase/AirlightPhaseFit.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Closer to a ray than its radius, a light has no angle that tells the direction of the ray's
// points, which a photometric table needs. True where that is less than a pixel; not of a
// headlight.
bool IsApartFromRays(const f64::AirlightLight& light)
{
  return light.radius <= 1e-4 * glm::length(light.position);
}
}

//------------------------------------------------------------------------------
bool IsEquiangular(const FrameScene& scene, int light)
{
  const f64::AirlightLight& values = scene.Lights[light].Values;
  f64::AirlightPhase phase = scene.Media.item[0].phase;
  if (values.kind == AIRLIGHT_POINT_CLOSED)
  {
    return phase.rows == 0;
  }
  // A power, a photometric table or fog, of which there is no closed form.
  const bool uniform = (phase.power.x > 0.0 || values.goniometric != 0) &&
    HasUniformPaths(scene.Media, values) && (values.goniometric == 0 || IsApartFromRays(values));
  const bool fog = values.goniometric == 0 && IsInHeightFog(scene.Media, values);
  phase.power.x = 0.0;
  return (uniform || fog) && scene.Media.volumes == 0 && HasClosedForm(phase) &&
    values.kind == AIRLIGHT_POINT_QUADRATURE;
}

//------------------------------------------------------------------------------
bool IsHeightFog(const FrameScene& scene)
{
  return scene.Media.item[0].density == AIRLIGHT_DENSITY_HEIGHT;
}

//------------------------------------------------------------------------------
bool AreEquiangular(const FrameScene& scene, const std::vector<int>& lights)
{
  return !lights.empty() &&
    std::all_of(lights.begin(), lights.end(), [&scene](int k) { return IsEquiangular(scene, k); });
}

//------------------------------------------------------------------------------
// AirlightConstants.glsl sets a part of the medium.
std::string GetEquiangularSource(const FrameScene& scene)
{
  return std::string(AirlightEquiangular) +
    (IsHeightFog(scene)
        ? std::string("#define AIRLIGHT_HEIGHT_FOG 1\n") + AirlightHeightFogLamp
        : std::string(AirlightEquiangularPanel) + AirlightGoniometricArc + AirlightHalfAngle) +
    AirlightConstants;
}

//------------------------------------------------------------------------------
void SetEquiangularConstants(
  vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights)
{
  const f64::AirlightMedium& medium = scene.Media.item[0];
  std::vector<glm::vec4> constants;
  for (int k : lights)
  {
    const f64::AirlightLight& light = scene.Lights[k].Values;
    const CameraUniforms::LightPixel pixel = scene.Rays.GetLightPixel(light.position);
    constants.insert(constants.end(),
      { glm::vec4(light.position, light.radius),
        glm::vec4(light.intensity * medium.sigmaS, medium.phase.pole[0].y),
        glm::vec4(medium.sigmaT, pixel.IsNear ? 1.0 : 0.0),
        glm::vec4(pixel.Integer, pixel.Fraction), glm::vec4(pixel.PerX, 0.0f),
        glm::vec4(pixel.PerY, 0.0f) });
  }
  program->SetUniform4fv("airlightConstants", static_cast<int>(constants.size()), &constants[0].x);
}
}
