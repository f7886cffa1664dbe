// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceLamp.h"

#include "Photometry/AirlightLightProperties.h"

#include "vtkLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// Directions across another, the second one along `up` as far as that is across.
struct Across
{
  glm::dvec3 Right;
  glm::dvec3 Up;
};

Across GetAcross(const glm::dvec3& axis, glm::dvec3 up)
{
  up /= std::max({ std::abs(up.x), std::abs(up.y), std::abs(up.z) }); // of any size
  if (glm::length(glm::cross(axis, glm::normalize(up))) < 1e-6)
  {
    const glm::dvec3 z(0.0, 0.0, 1.0);
    up = glm::length(glm::cross(axis, z)) < 1e-6 ? glm::dvec3(1.0, 0.0, 0.0) : z;
  }
  const glm::dvec3 right = glm::normalize(glm::cross(axis, up));
  return { right, glm::cross(right, axis) };
}

glm::dvec3 GetOnDisc(const Across& across, double radius, double turn)
{
  const double angle = 2.0 * vtkMath::Pi() * turn;
  return radius * (std::cos(angle) * across.Right + std::sin(angle) * across.Up);
}

// The angle a from 0 to pi/2 with (a - sin a cos a)/(pi/2) = share, by bisection: of points whose
// density is 1/sqrt(R^2 - r^2), this share has r < R sin a.
double FindShell(double share)
{
  double low = 0.0;
  double high = 0.5 * vtkMath::Pi();
  for (int i = 0; i < 60; ++i)
  {
    const double angle = 0.5 * (low + high);
    const bool above = angle - std::sin(angle) * std::cos(angle) > 0.5 * vtkMath::Pi() * share;
    (above ? high : low) = angle;
  }
  return low;
}

glm::dvec3 GetInBall(double radius, double height, double turn, double share)
{
  const double z = 1.0 - 2.0 * height;
  const double across = std::sqrt(1.0 - z * z);
  const double angle = 2.0 * vtkMath::Pi() * turn;
  return radius * std::sin(FindShell(share)) *
    glm::dvec3(across * std::cos(angle), across * std::sin(angle), z);
}

// Of a lamp whose axis is 0 without one, the point of these numbers from 0 to 1.
glm::dvec3 GetPoint(
  const LightProperties& properties, const glm::dvec3& axis, const glm::dvec3& numbers)
{
  const LampExtent& extent = properties.Extent;
  if (axis == glm::dvec3(0.0))
  {
    return GetInBall(extent.Radius, numbers.x, numbers.y, numbers.z);
  }
  const Across across = GetAcross(axis, properties.PhotometryUp);
  if (extent.Size != glm::dvec2(0.0))
  {
    return (numbers.x - 0.5) * extent.Size.x * across.Right +
      (numbers.y - 0.5) * extent.Size.y * across.Up;
  }
  return GetOnDisc(across, extent.Radius * std::sqrt(numbers.x), numbers.y);
}

// As seen from the focal point, which the light keeps: zones of equal height on a sphere have equal
// solid angles.
glm::dvec3 GetInSky(
  const LightProperties& properties, const glm::dvec3& axis, const glm::dvec3& numbers)
{
  const double half = 0.5 * glm::radians(properties.Extent.AngularDiameter);
  const double angle = std::acos(1.0 - numbers.x * (1.0 - std::cos(half)));
  return GetOnDisc(GetAcross(axis, properties.PhotometryUp), std::tan(angle), numbers.y);
}
}

//------------------------------------------------------------------------------
glm::dvec3 GetUpAcross(const glm::dvec3& axis, const glm::dvec3& up)
{
  return GetAcross(axis, up).Up;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkLight>> SplitLamp(vtkLight* light, int count)
{
  const LightProperties& properties = GetProperties(light);
  const LampExtent& extent = properties.Extent;
  const bool positional = light->GetPositional() != 0;
  const bool flat = extent.Size != glm::dvec2(0.0);
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  light->GetPosition(&position.x);
  light->GetFocalPoint(&focalPoint.x);
  const double length = glm::length(focalPoint - position);
  const bool extended = positional ? extent.Radius > 0.0 || flat : extent.AngularDiameter > 0.0;
  if (count < 2 || !extended || !light->LightTypeIsSceneLight() || (!positional && !(length > 0.0)))
  {
    return { light };
  }
  const bool aims =
    length > 0.0 && (!positional || flat || light->GetConeAngle() < 90.0 || properties.Table);
  const glm::dvec3 axis = aims ? (focalPoint - position) / length : glm::dvec3(0.0);
  std::vector<vtkSmartPointer<vtkLight>> lamps;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 numbers((i + 0.5) / count, glm::fract(i * 0.6180339887498949),
      glm::fract(0.5 + i * 0.7548776662466927)); // 1 over the golden ratio, the plastic number
    const glm::dvec3 offset = positional ? GetPoint(properties, axis, numbers)
                                         : length * GetInSky(properties, axis, numbers);
    auto lamp = vtkSmartPointer<vtkLight>::New();
    lamp->DeepCopy(light);
    lamp->SetIntensity(light->GetIntensity() / count);
    lamp->SetPosition(position.x + offset.x, position.y + offset.y, position.z + offset.z);
    if (positional)
    {
      lamp->SetFocalPoint(
        focalPoint.x + offset.x, focalPoint.y + offset.y, focalPoint.z + offset.z);
    }
    lamps.push_back(lamp);
  }
  return lamps;
}
}
