// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightConvert.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkParticipatingMedium.h"

#include <cmath>

namespace airlight
{
namespace
{
// Squares of larger numbers overflow.
constexpr double Largest = 1e100;

// False for NaN, too.
bool IsModerate(const glm::dvec3& v)
{
  return glm::all(glm::lessThanEqual(glm::abs(v), glm::dvec3(Largest)));
}

// The closed form holds where the whole leg from light to sample is inside: inverse square, and
// the light inside the convex region.
int PointKind(const f64::AirlightMedium& medium, const f64::AirlightLight& light)
{
  const bool inside = medium.region.kind == AIRLIGHT_REGION_UNBOUNDED ||
    (glm::all(glm::greaterThanEqual(light.position, medium.region.boxMin)) &&
      glm::all(glm::lessThanEqual(light.position, medium.region.boxMax)));
  const bool inverseSquare = light.attenuation.x == 0.0 && light.attenuation.y == 0.0;
  return inside && inverseSquare ? AIRLIGHT_POINT_CLOSED : AIRLIGHT_POINT_QUADRATURE;
}
}

//------------------------------------------------------------------------------
f64::AirlightMedium ConvertMedium(vtkParticipatingMedium* medium, const glm::dvec3& origin)
{
  f64::AirlightMedium result{};
  medium->GetScattering(&result.sigmaS.x);
  medium->GetExtinction(&result.sigmaT.x);
  medium->GetAmbientRadiance(&result.ambient.x);
  result.phase.poleCount = medium->GetNumberOfPhasePoles();
  for (int k = 0; k < result.phase.poleCount; ++k)
  {
    medium->GetPhasePole(k, result.phase.pole[k].x, result.phase.pole[k].y);
  }
  result.region.kind = medium->GetRegion() == vtkParticipatingMedium::BOX
    ? AIRLIGHT_REGION_BOX
    : AIRLIGHT_REGION_UNBOUNDED;
  const double* bounds = medium->GetBounds();
  result.region.boxMin = glm::dvec3(bounds[0], bounds[2], bounds[4]) - origin;
  result.region.boxMax = glm::dvec3(bounds[1], bounds[3], bounds[5]) - origin;
  return result;
}

//------------------------------------------------------------------------------
f64::AirlightLight ConvertPointLight(const f64::AirlightMedium& medium, const glm::dvec3& position,
  const glm::dvec3& radiantIntensity, const glm::dvec3& origin)
{
  f64::AirlightLight result{};
  result.position = position - origin;
  result.intensity = radiantIntensity;
  result.attenuation = glm::dvec3(0.0, 0.0, 1.0);
  result.kind = PointKind(medium, result);
  return result;
}

//------------------------------------------------------------------------------
LightSupport ConvertLight(const f64::AirlightMedium& medium, vtkLight* light,
  const glm::dvec3& origin, f64::AirlightLight& result)
{
  glm::dvec3 intensity;
  vtkAirlight::GetRadiantIntensity(light, &intensity.x);
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  light->GetTransformedPosition(&position.x);
  light->GetTransformedFocalPoint(&focalPoint.x);
  glm::dvec3 attenuation;
  light->GetAttenuationValues(&attenuation.x);
  if (!light->GetSwitch() || intensity == glm::dvec3(0.0))
  {
    return LightSupport::Dark;
  }
  if (!IsModerate(intensity) || !IsModerate(position) || !IsModerate(focalPoint))
  {
    return LightSupport::Invalid;
  }
  if (!light->GetPositional())
  {
    const glm::dvec3 toLight = position - focalPoint;
    const double distance = glm::length(toLight);
    if (!(distance > 0.0))
    {
      return LightSupport::Invalid;
    }
    if (medium.region.kind != AIRLIGHT_REGION_UNBOUNDED)
    {
      return LightSupport::Unsupported;
    }
    result = f64::AirlightLight{};
    result.kind = AIRLIGHT_DIRECTIONAL;
    result.position = toLight / distance;
    result.intensity = intensity;
    result.attenuation = glm::dvec3(1.0, 0.0, 0.0);
    return LightSupport::Scatters;
  }
  if (light->GetConeAngle() < 90.0)
  {
    return LightSupport::Unsupported;
  }
  if (!IsModerate(attenuation) || glm::any(glm::lessThan(attenuation, glm::dvec3(0.0))) ||
    attenuation == glm::dvec3(0.0))
  {
    return LightSupport::Invalid;
  }
  result = f64::AirlightLight{};
  result.position = position - origin;
  result.intensity = intensity;
  result.attenuation = attenuation;
  result.kind = PointKind(medium, result);
  if (result.kind == AIRLIGHT_POINT_CLOSED)
  {
    result.intensity /= attenuation.z;
    result.attenuation.z = 1.0;
  }
  return LightSupport::Scatters;
}
}
