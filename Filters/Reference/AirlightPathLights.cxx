// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathLights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
double GetDistance(const f64::AirlightLight& light, const glm::dvec3& position)
{
  return f64::airlightIsDirectional(light)
    ? 1.0
    : std::max(glm::length(light.position - position), light.radius);
}

// What a light sends to a position, but for its cone, its table and the media.
double GetStrength(const f64::AirlightLight& light, double distance)
{
  const glm::dvec3& a = light.attenuation;
  return (light.intensity.x + light.intensity.y + light.intensity.z) /
    (a.x + distance * (a.y + distance * a.z));
}
}

//------------------------------------------------------------------------------
PathLights::PathLights(const ReferenceTracer& tracer)
  : Tracer(tracer)
{
  bool hasPlaces = !Shines(tracer.GetMedia());
  for (const ReferenceLight& light : tracer.GetLights().GetAll())
  {
    if (light.Support == LightSupport::Scatters && light.Values.intensity != glm::dvec3(0.0))
    {
      this->Lights.push_back(&light);
      hasPlaces = hasPlaces && !f64::airlightIsDirectional(light.Values);
      this->Reach = std::max(this->Reach, 2.0 * glm::length(light.Values.position));
    }
  }
  // Lights at infinity and media that shine are everywhere.
  double least = std::numeric_limits<double>::infinity(); // extinction
  const f64::AirlightMedia& media = tracer.GetMedia();
  for (int i = 0; i < media.count; ++i)
  {
    const glm::dvec3& sigma = media.item[i].sigmaT;
    for (int c = 0; c < 3; ++c)
    {
      least = sigma[c] > 0.0 ? std::min(least, sigma[c]) : least;
    }
  }
  const bool fades = hasPlaces && !this->Lights.empty() && std::isfinite(least);
  this->Reach = fades ? this->Reach + 4.0 / least : 0.0;
}

//------------------------------------------------------------------------------
glm::dvec3 PathLights::GetDirection(const ReferenceLight& light, const glm::dvec3& position)
{
  const glm::dvec3 way = f64::airlightIsDirectional(light.Values)
    ? light.Values.position
    : light.Values.position - position;
  const double length = glm::length(way);
  return length > 0.0 ? way / length : glm::dvec3(0.0, 0.0, 1.0);
}

//------------------------------------------------------------------------------
PathLights::Choice PathLights::Choose(const glm::dvec3& position, RandomNumbers& random) const
{
  const auto count = static_cast<double>(this->Lights.size());
  const ReferenceLight* light = this->Lights.front();
  double probability = 1.0;
  if (this->Lights.size() > 1)
  {
    const auto getStrength = [&](const ReferenceLight* one) {
      return GetStrength(one->Values, GetDistance(one->Values, position));
    };
    double sum = 0.0;
    for (const ReferenceLight* one : this->Lights)
    {
      sum += getStrength(one);
    }
    double rest = random.Next();
    for (const ReferenceLight* one : this->Lights)
    {
      light = one;
      probability = 0.5 / count + 0.5 * getStrength(one) / sum;
      rest -= probability;
      if (rest < 0.0)
      {
        break;
      }
    }
  }
  return { light, probability };
}

//------------------------------------------------------------------------------
glm::dvec3 PathLights::GetArriving(const ReferenceLight& light, const glm::dvec3& position,
  double margin, bool shadows, glm::dvec3& toLight) const
{
  const f64::AirlightLight& values = light.Values;
  toLight = PathLights::GetDirection(light, position);
  if (values.cosCone > 0.0 && -glm::dot(toLight, values.axis) < values.cosCone)
  {
    return glm::dvec3(0.0);
  }
  if (shadows && light.CastsShadows &&
    this->Tracer.GetScene().GetCasters().Blocked(
      position + this->Tracer.GetEye(), light.World, margin))
  {
    return glm::dvec3(0.0);
  }
  const double falloff = f64::airlightFalloff(values, position, GetDistance(values, position)) *
    f64::airlightPhotometricShare(values, position);
  const glm::dvec3 casters = shadows && light.CastsShadows
    ? this->Tracer.GetScene().GetTransmittance(
        position + this->Tracer.GetEye(), light.World, margin)
    : glm::dvec3(1.0);
  return values.intensity * falloff * casters *
    glm::exp(-f64::airlightDepthToLight(this->Tracer.GetMedia(), values, position));
}

//------------------------------------------------------------------------------
double PathLights::GetImportance(const glm::dvec3& position) const
{
  if (!(this->Reach > 0.0))
  {
    return 1.0;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const ReferenceLight* light : this->Lights)
  {
    nearest = std::min(nearest, glm::length(light->Values.position - position));
  }
  // The power is what keeps both the mean length of paths and their variance finite in a medium
  // without bounds that absorbs nothing: there, distances of 1 and 2 would make one infinite.
  return std::pow(1.0 + nearest * nearest / (this->Reach * this->Reach), -0.75);
}
}
