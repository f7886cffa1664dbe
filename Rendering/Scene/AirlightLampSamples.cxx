// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLampSamples.h"

#include "Scene/AirlightSceneLights.h"
#include "Scene/AirlightScrambledNet.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
bool HasExtent(vtkLight* light)
{
  const LampExtent& extent = GetProperties(light).Extent;
  return light->GetPositional() ? extent.Radius > 0.0 || extent.Size != glm::dvec2(0.0)
                                : extent.AngularDiameter > 0.0;
}

bool IsMovingLamp(vtkLight* light)
{
  return light->GetSwitch() && light->LightTypeIsSceneLight() && HasExtent(light);
}

// Of an axis, whatever crosses it.
glm::dvec3 MakeRight(const glm::dvec3& axis, const glm::dvec3& up) { return glm::cross(axis, up); }

glm::dvec3 GetDiscOffset(
  double radius, const glm::dvec3& axis, const glm::dvec3& up, double u, double v)
{
  const double r = radius * std::sqrt(u);
  return r *
    (std::cos(2.0 * vtkMath::Pi() * v) * MakeRight(axis, up) +
      std::sin(2.0 * vtkMath::Pi() * v) * up);
}

// On a plane at this distance, of directions that are even in solid angle.
glm::dvec3 GetSkyOffset(double distance, double diameter, const glm::dvec3& axis,
  const glm::dvec3& up, const glm::dvec3& numbers)
{
  const double cosine = 1.0 - numbers.x * (1.0 - std::cos(0.5 * glm::radians(diameter)));
  const double radius = distance * std::sqrt(1.0 - cosine * cosine) / cosine;
  return GetDiscOffset(radius, axis, up, 1.0, numbers.y);
}

// Of points that are even on the sphere in four dimensions, three coordinates have the density
// 1/sqrt(R^2 - r^2), whose projection is an even disc.
glm::dvec3 GetBallOffset(double radius, const glm::dvec3& numbers)
{
  const double outer = radius * std::sqrt(1.0 - numbers.x);
  const double inner = radius * std::sqrt(numbers.x);
  return { outer * std::sin(2.0 * vtkMath::Pi() * numbers.y),
    outer * std::cos(2.0 * vtkMath::Pi() * numbers.y),
    inner * std::sin(2.0 * vtkMath::Pi() * numbers.z) };
}
}

//------------------------------------------------------------------------------
glm::dvec3 GetLampOffset(
  const LampExtent& extent, const glm::dvec3& axis, const glm::dvec3& up, const glm::dvec3& numbers)
{
  if (axis == glm::dvec3(0.0))
  {
    return GetBallOffset(extent.Radius, numbers);
  }
  if (extent.Size != glm::dvec2(0.0))
  {
    return (numbers.x - 0.5) * extent.Size.x * MakeRight(axis, up) +
      (numbers.y - 0.5) * extent.Size.y * up;
  }
  return GetDiscOffset(extent.Radius, axis, up, numbers.x, numbers.y);
}

//------------------------------------------------------------------------------
glm::dvec3 GetLampAxis(vtkLight* light)
{
  const LightProperties& properties = GetProperties(light);
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  light->GetPosition(&position.x);
  light->GetFocalPoint(&focalPoint.x);
  const double length = glm::length(focalPoint - position);
  const bool aims = length > 0.0 &&
    (!light->GetPositional() || light->GetConeAngle() < 90.0 || properties.Table ||
      properties.Extent.Size != glm::dvec2(0.0));
  return aims ? (focalPoint - position) / length : glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
bool HasMovingLamps(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (IsMovingLamp(light))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
MovedLamps::MovedLamps(vtkRenderer* renderer, int number)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  int index = 0;
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (IsMovingLamp(light))
    {
      this->Move(light, GetLampNumbers(number, index));
    }
    ++index;
  }
}

//------------------------------------------------------------------------------
MovedLamps::~MovedLamps()
{
  for (const Place& place : this->Places)
  {
    place.Light->SetPosition(place.Position.x, place.Position.y, place.Position.z);
    place.Light->SetFocalPoint(place.FocalPoint.x, place.FocalPoint.y, place.FocalPoint.z);
  }
}

//------------------------------------------------------------------------------
// A lamp keeps its direction; the sun's changes. A collection may have a light twice.
void MovedLamps::Move(vtkLight* light, const glm::dvec3& numbers)
{
  if (std::any_of(this->Places.begin(), this->Places.end(),
        [light](const Place& place) { return place.Light == light; }))
  {
    return;
  }
  Place place{ light, {}, {} };
  light->GetPosition(&place.Position.x);
  light->GetFocalPoint(&place.FocalPoint.x);
  const double length = glm::length(place.FocalPoint - place.Position);
  const LightProperties& properties = GetProperties(light);
  const bool positional = light->GetPositional() != 0;
  const glm::dvec3 axis = GetLampAxis(light);
  const bool aims = axis != glm::dvec3(0.0);
  if (!positional && !aims)
  {
    return;
  }
  const glm::dvec3 up = aims ? MakeAcross(properties.PhotometryUp, axis) : glm::dvec3(0.0);
  const glm::dvec3 offset = positional
    ? GetLampOffset(properties.Extent, axis, up, numbers)
    : GetSkyOffset(length, properties.Extent.AngularDiameter, axis, up, numbers);
  this->Places.push_back(place);
  const glm::dvec3 position = place.Position + offset;
  light->SetPosition(position.x, position.y, position.z);
  if (positional)
  {
    const glm::dvec3 focalPoint = place.FocalPoint + offset;
    light->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
  }
}
}
