// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RayProbes/AirlightProbe.h"

#include "Integration/AirlightIntegrate.h"
#include "RayProbes/AirlightFilterInput.h"
#include "vtkLight.h"

#include <cmath>

namespace airlight
{
namespace
{
// Unshadowed. The light, which scatters, and the media are relative to the point.
glm::dvec3 IrradianceOf(
  const f64::AirlightMedia& media, const f64::AirlightLight& sceneLight, const glm::dvec3* normal)
{
  const glm::dvec3 point(0.0);
  const bool sun = f64::airlightIsDirectional(sceneLight);
  const double r = glm::length(sceneLight.position);
  if (!(r > 0.0))
  {
    return glm::dvec3(0.0); // in the light's position, light has no direction
  }
  const glm::dvec3 toLight = sceneLight.position / r;
  const double cosine = normal ? std::max(glm::dot(*normal, toLight), 0.0) : 1.0;
  if (sceneLight.cosCone > 0.0 && glm::dot(-toLight, sceneLight.axis) < sceneLight.cosCone)
  {
    return glm::dvec3(0.0);
  }
  const glm::dvec3 depth = sun ? f64::airlightSunDepths(media, point, toLight)
                               : f64::airlightDepthBetween(media, point, sceneLight.position);
  // The square of the least distance is not 0.
  const double fall = sun ? 1.0 : f64::airlightFalloff(sceneLight, point, std::max(r, 1e-100));
  return sceneLight.intensity * (cosine * fall) * glm::exp(-depth);
}

// Calls use(light, sceneLight) for the lights that shine, relative to the point.
template <typename Use>
void ForEachSceneLight(
  const Probe& probe, const f64::AirlightMedia& media, const glm::dvec3& point, const Use& use)
{
  for (vtkLight* light : probe.Lights)
  {
    f64::AirlightLight sceneLight;
    if (ConvertSceneLight(media, light, point, sceneLight) == LightSupport::Scatters)
    {
      use(light, sceneLight);
    }
  }
}

// Its light is scattered more than once on rays through it, too.
void SetLeastRadius(f64::AirlightLight& light)
{
  light.radius = std::max(1e-12 * glm::length(light.position), 1e-100);
}

// Unshadowed airlight of [from, to] of a ray of unit direction.
glm::dvec3 ScatterBetween(const f64::AirlightMedia& media, vtkLight* light, const glm::dvec3& eye,
  const glm::dvec3& direction, double from, double to)
{
  f64::AirlightLight sceneLight;
  return ConvertLight(media, light, eye, sceneLight) == LightSupport::Scatters
    ? IntegrateLight(media, sceneLight, direction, from, to)
    : glm::dvec3(0.0);
}

// The number of a light among the media's lamps, -1 where it is none.
int FindLamp(const f64::AirlightMedia& media, const glm::dvec3& point, vtkLight* light)
{
  f64::AirlightLight sceneLight;
  if (media.multiple.count == 0 ||
    ConvertSceneLight(media, light, point, sceneLight) != LightSupport::Scatters)
  {
    return -1;
  }
  SetLeastRadius(sceneLight);
  return FindMultipleLamp(media, sceneLight);
}

// The lamps whose light is scattered more than once become the media's.
void AddMultipleLamps(const Probe& probe, const glm::dvec3& point, f64::AirlightMedia& media)
{
  if (media.multiple.on == 0)
  {
    return; // for each ray and point
  }
  ForEachSceneLight(probe, media, point, [&](vtkLight*, f64::AirlightLight& sceneLight) {
    SetLeastRadius(sceneLight);
    AddMultipleLamp(media, sceneLight);
  });
}
}

//------------------------------------------------------------------------------
glm::dvec3 Probe::FindRadiance(const glm::dvec3& eye, const glm::dvec3& point) const
{
  glm::dvec3 sum(0.0);
  const double length = glm::distance(eye, point);
  if (!(length > 0.0))
  {
    return sum;
  }
  const glm::dvec3 direction = (point - eye) / length;
  f64::AirlightMedia media = ConvertMedia(this->Media, eye);
  AddMultipleLamps(*this, eye, media);
  sum = IntegrateAmbient(media, glm::dvec3(0.0), direction, length);
  std::vector<Occluders::Shadow> shadows;
  std::vector<Occluders::Interval> lit;
  for (vtkLight* light : this->Lights)
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const HomogeneousPoint position = GetHomogeneousPosition(light);
    this->Shades->FindShadows(position, eye, direction, 0.0, length, shadows);
    Occluders::LitIntervals(shadows, 0.0, length, lit, this->Shades->GetGap(position, eye));
    glm::dvec3 own(0.0);
    for (const Occluders::Interval& part : lit)
    {
      own += ScatterBetween(media, light, eye, direction, part.From, part.To);
    }
    sum += own;
    const int lamp = FindLamp(media, eye, light);
    if (lamp >= 0)
    {
      sum += IntegrateMultiple(media, lamp, glm::dvec3(0.0), direction, length, own);
    }
  }
  return sum + IntegrateCollisions(media, glm::dvec3(0.0), direction, length);
}

//------------------------------------------------------------------------------
glm::dvec3 Probe::FindTransmittance(const glm::dvec3& eye, const glm::dvec3& point) const
{
  const f64::AirlightMedia media = ConvertMedia(this->Media, eye);
  return glm::exp(-f64::airlightDepthBetween(media, glm::dvec3(0.0), point - eye));
}

//------------------------------------------------------------------------------
glm::dvec3 Probe::FindDirect(const glm::dvec3& point, const glm::dvec3* normal, double margin) const
{
  glm::dvec3 sum(0.0);
  const f64::AirlightMedia media = ConvertMedia(this->Media, point);
  ForEachSceneLight(
    *this, media, point, [&](vtkLight* light, const f64::AirlightLight& sceneLight) {
      const glm::dvec3 irradiance = IrradianceOf(media, sceneLight, normal);
      const bool arrives = irradiance != glm::dvec3(0.0);
      if (arrives && !this->Shades->Blocked(point, GetHomogeneousPosition(light), margin))
      {
        sum += irradiance;
      }
    });
  return sum;
}

//------------------------------------------------------------------------------
glm::dvec3 Probe::FindScattered(const glm::dvec3& point, const glm::dvec3& normal) const
{
  glm::dvec3 sum(0.0);
  f64::AirlightMedia media = ConvertMedia(this->Media, point);
  AddMultipleLamps(*this, point, media);
  if (media.multiple.count > 0)
  {
    return f64::airlightMultipleIrradiance(media.multiple, media, glm::dvec3(0.0), normal);
  }
  ForEachSceneLight(*this, media, point, [&](vtkLight*, const f64::AirlightLight& sceneLight) {
    const glm::dvec3 irradiance =
      f64::airlightScatteredIrradiance(media, sceneLight, glm::dvec3(0.0), normal);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += std::isfinite(irradiance[c]) ? irradiance[c] : 0.0; // with the light on the point
    }
  });
  return sum;
}
}
