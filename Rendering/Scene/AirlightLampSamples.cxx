// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLampSamples.h"

#include "Integration/AirlightMath.h"
#include "Scene/AirlightSceneLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <cmath>

namespace airlight
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

bool HasExtent(vtkLight* light)
{
  const LampExtent& extent = GetProperties(light).Extent;
  return light->GetPositional() ? extent.Radius > 0.0 || extent.Size != glm::dvec2(0.0)
                                : extent.AngularDiameter > 0.0;
}

// Of an axis, whatever crosses it.
glm::dvec3 MakeRight(const glm::dvec3& axis, const glm::dvec3& up) { return glm::cross(axis, up); }

glm::dvec3 GetDiscOffset(
  double radius, const glm::dvec3& axis, const glm::dvec3& up, double u, double v)
{
  const double r = radius * std::sqrt(u);
  return r * (std::cos(2.0 * Pi * v) * MakeRight(axis, up) + std::sin(2.0 * Pi * v) * up);
}

// Of points that are even on the sphere in four dimensions, three coordinates have the density
// 1/sqrt(R^2 - r^2), whose projection is an even disc.
glm::dvec3 GetBallOffset(double radius, const glm::dvec3& numbers)
{
  const double outer = radius * std::sqrt(1.0 - numbers.x);
  const double inner = radius * std::sqrt(numbers.x);
  return { outer * std::sin(2.0 * Pi * numbers.y), outer * std::cos(2.0 * Pi * numbers.y),
    inner * std::sin(2.0 * Pi * numbers.z) };
}
}

//------------------------------------------------------------------------------
glm::dvec3 GetLampNumbers(int number, int light)
{
  const double root = 1.2207440846057594754;
  const glm::dvec3 steps(1.0 / root, 1.0 / (root * root), 1.0 / (root * root * root));
  const glm::dvec3 shift = 0.5 + 0.6180339887498949 * light * glm::dvec3(1.0, 2.0, 3.0);
  return glm::fract(shift + static_cast<double>(number) * steps);
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
MovedLamps::MovedLamps(vtkRenderer* renderer, int number)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  int index = 0;
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (light->GetSwitch() && light->LightTypeIsSceneLight() && HasExtent(light))
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
// A lamp keeps its direction; the sun's changes.
void MovedLamps::Move(vtkLight* light, const glm::dvec3& numbers)
{
  Place place{ light, {}, {} };
  light->GetPosition(&place.Position.x);
  light->GetFocalPoint(&place.FocalPoint.x);
  const glm::dvec3 path = place.FocalPoint - place.Position;
  const double length = glm::length(path);
  const LightProperties& properties = GetProperties(light);
  const bool positional = light->GetPositional() != 0;
  const bool aims = !positional || light->GetConeAngle() < 90.0 || properties.Table ||
    properties.Extent.Size != glm::dvec2(0.0);
  if (aims && !(length > 0.0))
  {
    return;
  }
  const glm::dvec3 axis = aims ? path / length : glm::dvec3(0.0);
  const glm::dvec3 up = aims ? MakeAcross(properties.PhotometryUp, axis) : glm::dvec3(0.0);
  this->Places.push_back(place);
  if (positional)
  {
    const glm::dvec3 offset = GetLampOffset(properties.Extent, axis, up, numbers);
    const glm::dvec3 position = place.Position + offset;
    const glm::dvec3 focalPoint = place.FocalPoint + offset;
    light->SetPosition(position.x, position.y, position.z);
    light->SetFocalPoint(focalPoint.x, focalPoint.y, focalPoint.z);
    return;
  }
  LampExtent disc;
  disc.Radius = length * std::tan(0.5 * glm::radians(properties.Extent.AngularDiameter));
  const glm::dvec3 position = place.Position + GetLampOffset(disc, axis, up, numbers);
  light->SetPosition(position.x, position.y, position.z);
}
}
