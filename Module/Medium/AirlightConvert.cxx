// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Medium/AirlightConvert.h"

#include "Medium/AirlightConvertSky.h"
#include "MultipleScattering/AirlightFirstCollisions.h"
#include "MultipleScattering/AirlightLayeredSolution.h"
#include "MultipleScattering/AirlightSourceFit.h"
#include "Phase/AirlightPhaseShape.h"
#include "Region/AirlightRegionKinds.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
void MakeEmpty(f64::AirlightMedium& medium)
{
  medium.region.kind = AIRLIGHT_REGION_BOX;
  medium.region.boxMin = glm::dvec3(0.0);
  medium.region.boxMax = glm::dvec3(0.0);
  medium.sigmaS = glm::dvec3(0.0);
  medium.sigmaT = glm::dvec3(0.0);
  medium.emission = glm::dvec3(0.0);
}

// A medium whose image is missing or no good is ignored. Boxes shrink to where the image is.
void ConvertGrid(
  vtkParticipatingMedium* medium, const glm::dvec3& origin, f64::AirlightMedium& result)
{
  const std::shared_ptr<const DensityGrid> grid = medium->GetDensityGrid();
  if (!grid)
  {
    MakeEmpty(result);
    return;
  }
  result.density = AIRLIGHT_DENSITY_GRID;
  result.grid = grid.get();
  result.gridOrigin = origin;
  result.albedo = medium->GetAlbedoColours().get();
  result.sigmaS = result.albedo ? result.sigmaT : result.sigmaS;
  result.glow = medium->GetEmissionColours().get();
  f64::AirlightRegion& region = result.region;
  if (region.kind == AIRLIGHT_REGION_UNBOUNDED)
  {
    region.kind = AIRLIGHT_REGION_BOX;
    region.boxMin = grid->GetLeast() - origin;
    region.boxMax = grid->GetGreatest() - origin;
  }
  else if (region.kind == AIRLIGHT_REGION_BOX)
  {
    region.boxMin = glm::max(region.boxMin, grid->GetLeast() - origin);
    region.boxMax = glm::min(region.boxMax, grid->GetGreatest() - origin);
    if (glm::any(glm::greaterThan(region.boxMin, region.boxMax)))
    {
      MakeEmpty(result);
    }
  }
}

f64::AirlightMedium ConvertMedium(
  vtkParticipatingMedium* medium, const glm::dvec3& origin, const SkyHarmonics* environment)
{
  f64::AirlightMedium result{};
  medium->GetScattering(&result.sigmaS.x);
  medium->GetExtinction(&result.sigmaT.x);
  ConvertAmbient(medium, environment, result);
  medium->GetFiniteEmission(&result.emission.x);
  const std::shared_ptr<const PhaseShape> phase = medium->GetPhaseShape();
  result.phase = Convert(phase->Fit);
  result.phase.data = phase->Rows.data();
  result.phase.rows = static_cast<int>(phase->Rows.size());
  if (!ConvertRegion(medium, origin, result.region))
  {
    MakeEmpty(result);
  }
  if (medium->GetDensity() == vtkParticipatingMedium::EXPONENTIAL_HEIGHT)
  {
    result.density = AIRLIGHT_DENSITY_HEIGHT;
    medium->GetUp(&result.up.x);
    result.inverseScaleHeight = 1.0 / medium->GetScaleHeight();
    result.originHeight = glm::dot(result.up, origin) - medium->GetReferenceHeight();
  }
  else if (medium->GetDensity() == vtkParticipatingMedium::IMAGE)
  {
    ConvertGrid(medium, origin, result);
  }
  return result;
}

// A light that falls off by the inverse square, the same all over its cone.
bool IsInverseSquare(const f64::AirlightLight& light)
{
  return light.attenuation.x == 0.0 && light.attenuation.y == 0.0 &&
    (light.cosCone < 0.0 || light.exponent == 0.0);
}

int PointKind(const f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  return media.volumes == 0 && HasUniformPaths(media, light) && HasClosedForm(media.item[0].phase)
    ? AIRLIGHT_POINT_CLOSED
    : AIRLIGHT_POINT_QUADRATURE;
}

int DirectionalKind(const f64::AirlightMedia& media)
{
  const f64::AirlightMedium& first = media.item[0];
  const bool unbounded = first.region.kind == AIRLIGHT_REGION_UNBOUNDED;
  if (media.volumes > 0)
  {
    return AIRLIGHT_DIRECTIONAL_QUADRATURE;
  }
  if (media.count == 1 && first.density == AIRLIGHT_DENSITY_HEIGHT && unbounded)
  {
    return AIRLIGHT_DIRECTIONAL_HEIGHT;
  }
  return media.count == 1 && first.density == AIRLIGHT_DENSITY_UNIFORM &&
      (unbounded || first.region.kind == AIRLIGHT_REGION_BOX)
    ? AIRLIGHT_DIRECTIONAL_CLOSED
    : AIRLIGHT_DIRECTIONAL_QUADRATURE;
}

// power: see AirlightMultiple.
bool AddEvenLamp(
  f64::AirlightMedia& media, const glm::dvec3& position, double radius, const glm::dvec4& power)
{
  f64::AirlightMultiple& multiple = media.multiple;
  const int lamp = multiple.count - multiple.suns;
  if (lamp == AIRLIGHT_MAX_MULTIPLE_LAMPS)
  {
    return false;
  }
  multiple.lamp[lamp] = glm::dvec4(position, radius);
  multiple.power[lamp] = power;
  ++multiple.count;
  RemoveAmbient(media.item[0]); // which stands for the same light
  return true;
}

glm::dvec4 GetLampPower(const f64::AirlightLight& light)
{
  return { 4.0 * vtkMath::Pi() * light.intensity / light.attenuation.z, 0.0 };
}
}

//------------------------------------------------------------------------------
f64::AirlightMedia ConvertMedia(const std::vector<vtkParticipatingMedium*>& media,
  const glm::dvec3& origin, const SkyHarmonics* environment)
{
  f64::AirlightMedia result{};
  result.count = static_cast<int>(std::min<size_t>(media.size(), AIRLIGHT_MAX_MEDIA));
  for (int i = 0; i < result.count; ++i)
  {
    result.item[i] = ConvertMedium(media[i], origin, environment);
  }
  std::shared_ptr<const SourceFit> fit;
  for (int i = 0; i < result.count; ++i)
  {
    fit = media[i]->GetSourceFit(result.count == 1);
  }
  if (fit && result.item[0].sigmaT != glm::dvec3(0.0))
  {
    result.multiple = fit->Coefficients;
    vtkParticipatingMedium* medium = media[0];
    if (medium->GetGround() && medium->GetDensity() == vtkParticipatingMedium::EXPONENTIAL_HEIGHT)
    {
      const double height =
        (medium->GetGroundHeight() - medium->GetReferenceHeight()) / medium->GetScaleHeight();
      result.multiple.groundDepth = medium->GetScaleHeight() * std::exp(-std::max(height, -60.0));
      medium->GetGroundAlbedo(&result.multiple.groundAlbedo.x);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
bool AddVolume(
  f64::AirlightMedia& media, const DensityGrid& grid, double sigmaT, const glm::dvec3& origin)
{
  if (media.count + media.volumes == AIRLIGHT_MAX_MEDIA)
  {
    return false;
  }
  f64::AirlightMedium& volume = media.item[media.count + media.volumes];
  volume = f64::AirlightMedium{};
  volume.sigmaT = glm::dvec3(sigmaT);
  volume.density = AIRLIGHT_DENSITY_GRID;
  volume.grid = &grid;
  volume.gridOrigin = origin;
  volume.region.kind = AIRLIGHT_REGION_BOX;
  volume.region.boxMin = grid.GetLeast() - origin;
  volume.region.boxMax = grid.GetGreatest() - origin;
  ++media.volumes;
  return true;
}

//------------------------------------------------------------------------------
bool AddMultipleLamp(f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  const f64::AirlightMultiple& multiple = media.multiple;
  if (multiple.on == 0 || light.intensity == glm::dvec3(0.0))
  {
    return true;
  }
  if (f64::airlightIsDirectional(light))
  {
    return AddMultipleSun(media, light);
  }
  if (light.cosCone < 0.0 && light.goniometric == 0 &&
    (HasUniformPaths(media, light) || IsInHeightFog(media, light)))
  {
    return AddEvenLamp(media, light.position, light.radius, GetLampPower(light));
  }
  const f64::AirlightMedium& medium = media.item[0];
  if (medium.density != AIRLIGHT_DENSITY_UNIFORM || multiple.meanCosine > MaximumBeamCosine ||
    light.attenuation.x != 0.0 || light.attenuation.y != 0.0 ||
    multiple.count - multiple.suns + 2 > AIRLIGHT_MAX_MULTIPLE_LAMPS)
  {
    return false;
  }
  for (const CollisionGroup& group : FindFirstCollisions(medium, light, multiple.meanCosine))
  {
    if (group.Power != glm::dvec3(0.0))
    {
      AddEvenLamp(media, group.Position, std::max(group.Radius, light.radius),
        glm::dvec4(group.Power / light.attenuation.z, 1.0));
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool HasCollisions(const f64::AirlightMedia& media)
{
  const f64::AirlightMultiple& multiple = media.multiple;
  return std::any_of(multiple.power, multiple.power + multiple.count - multiple.suns,
    [](const glm::dvec4& power) { return power.w > 0.0; });
}

//------------------------------------------------------------------------------
int FindMultipleLamp(const f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  const f64::AirlightMultiple& multiple = media.multiple;
  const int lamps = multiple.count - multiple.suns;
  if (light.intensity == glm::dvec3(0.0))
  {
    return -1;
  }
  if (f64::airlightIsDirectional(light))
  {
    for (int sun = 0; sun < multiple.suns; ++sun)
    {
      const glm::dvec4* rows = multiple.sun + sun * AIRLIGHT_SUN_ROWS;
      if (glm::dvec3(rows[AIRLIGHT_SUN_DIRECTION]) == light.position &&
        glm::dvec3(rows[AIRLIGHT_SUN_IRRADIANCE]) == light.intensity)
      {
        return lamps + sun;
      }
    }
    return -1;
  }
  for (int lamp = 0; lamp < lamps; ++lamp)
  {
    if (multiple.lamp[lamp] == glm::dvec4(light.position, light.radius) &&
      multiple.power[lamp] == GetLampPower(light))
    {
      return lamp;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
bool IsMultiple(const f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  return FindMultipleLamp(media, light) >= 0 ||
    (HasCollisions(media) && !f64::airlightIsDirectional(light));
}

//------------------------------------------------------------------------------
f64::AirlightLight ConvertPointLight(const f64::AirlightMedia& media, const glm::dvec3& position,
  const glm::dvec3& radiantIntensity, const glm::dvec3& origin)
{
  f64::AirlightLight result{};
  result.position = position - origin;
  result.intensity = radiantIntensity;
  result.attenuation = glm::dvec3(0.0, 0.0, 1.0);
  result.cosCone = -1.0;
  result.kind = PointKind(media, result);
  return result;
}

//------------------------------------------------------------------------------
std::string GetScatteredOnceText(int lights)
{
  return "Multiple scattering leaves out " + std::to_string(lights) +
    " of the lights, which are scattered once: it is computed for at most " +
    std::to_string(AIRLIGHT_MAX_MULTIPLE_LAMPS) +
    " lamps that fall off by the inverse square, in uniform media or fog that falls with height; a "
    "spotlight, a photometric file or a lamp outside counts twice, and needs a uniform medium with "
    "a mean cosine of at most 0.65; and for " +
    std::to_string(AIRLIGHT_MAX_MULTIPLE_SUNS) +
    " directional lights in a box or in fog that falls with height. See "
    "vtkAirlight::SetRadiantIntensity().";
}

//------------------------------------------------------------------------------
bool HasScattering(const f64::AirlightMedia& media)
{
  return std::any_of(media.item, media.item + media.count,
    [](const f64::AirlightMedium& medium) { return medium.sigmaS != glm::dvec3(0.0); });
}

//------------------------------------------------------------------------------
bool Shines(const f64::AirlightMedia& media)
{
  return std::any_of(media.item, media.item + media.count, [](const f64::AirlightMedium& medium) {
    return medium.sigmaS * medium.ambient != glm::dvec3(0.0) ||
      medium.emission != glm::dvec3(0.0) ||
      (medium.sky.on != 0 && medium.sigmaS != glm::dvec3(0.0));
  });
}

//------------------------------------------------------------------------------
LightSupport ConvertLight(const f64::AirlightMedia& media, vtkLight* light,
  const glm::dvec3& origin, f64::AirlightLight& result)
{
  result = f64::AirlightLight{};
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  vtkAirlight::GetRadiantIntensity(light, &result.intensity.x);
  light->GetTransformedPosition(&position.x);
  light->GetTransformedFocalPoint(&focalPoint.x);
  light->GetAttenuationValues(&result.attenuation.x);
  result.cosCone = -1.0;
  result.exponent = light->GetExponent();
  if (!light->GetSwitch() || result.intensity == glm::dvec3(0.0))
  {
    return LightSupport::Off;
  }
  const glm::dvec3 axis = focalPoint - position;
  const double length = glm::length(axis);
  if (!IsModerate(result.intensity) || !IsModerate(position) || !IsModerate(focalPoint) ||
    !std::isfinite(result.exponent) || result.exponent < 0.0)
  {
    return LightSupport::Invalid;
  }
  const bool isSpot = light->GetPositional() && light->GetConeAngle() < 90.0;
  if ((!light->GetPositional() || isSpot) && !(length > 0.0))
  {
    return LightSupport::Invalid;
  }
  if (!light->GetPositional())
  {
    result.position = -axis / length;
    result.attenuation = glm::dvec3(1.0, 0.0, 0.0);
    result.kind = DirectionalKind(media);
    return LightSupport::Scatters;
  }
  if (!IsModerate(result.attenuation) ||
    glm::any(glm::lessThan(result.attenuation, glm::dvec3(0.0))) ||
    result.attenuation == glm::dvec3(0.0))
  {
    return LightSupport::Invalid;
  }
  if (isSpot)
  {
    result.axis = axis / length;
    result.cosCone = std::cos(vtkMath::RadiansFromDegrees(std::max(light->GetConeAngle(), 0.0)));
  }
  result.position = position - origin;
  result.kind = PointKind(media, result);
  if (IsInverseSquare(result))
  {
    result.intensity /= result.attenuation.z;
    result.attenuation.z = 1.0;
  }
  return LightSupport::Scatters;
}

//------------------------------------------------------------------------------
bool HasUniformPaths(const f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  const f64::AirlightMedium& first = media.item[0];
  return media.count == 1 && first.density == AIRLIGHT_DENSITY_UNIFORM &&
    first.region.kind != AIRLIGHT_REGION_SURFACE &&
    f64::airlightHolds(first.region, light.position) && IsInverseSquare(light);
}

//------------------------------------------------------------------------------
bool IsInHeightFog(const f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  const f64::AirlightMedium& first = media.item[0];
  return media.count == 1 && first.density == AIRLIGHT_DENSITY_HEIGHT &&
    first.region.kind == AIRLIGHT_REGION_UNBOUNDED && IsInverseSquare(light);
}
}
