// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/ModelLights.h"

#include "formats/UserError.h"

#include <vtkMath.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace airlight
{

namespace
{
// Lengths are in multiples of the reach, directions with y up and the view along -z.
struct Place
{
  const char* Name;
  Vector3 Lamp;     // from the middle
  double Radiance;  // factor of the mood's
  double SpotAngle; // half angle in degrees; 0 for a lamp that shines all around
  Vector3 Fill;     // direction of travel
  double FillShare; // factor of the mood's radiance
  double Ambient;
  double Brightness;
};

constexpr Vector3 FromEye{ -1.0, -0.45, -0.75 }; // from beside the camera

constexpr std::array<Place, 6> Places = { {
  { "behind", { -0.5, 0.78, -0.3 }, 1.0, 0.0, FromEye, 1.0, 1.0, 1.0 },
  { "left", { -1.0, 0.4, 0.15 }, 1.0, 0.0, FromEye, 0.4, 1.0, 0.85 },
  { "right", { 1.05, 0.4, 0.0 }, 1.0, 0.0, { 0.8, -0.35, -1.0 }, 0.4, 1.0, 0.85 },
  { "above", { 0.0, 1.1, 0.0 }, 1.0, 30.0, FromEye, 0.5, 0.35, 0.55 },
  { "front", { -0.15, 0.75, 1.2 }, 0.8, 0.0, { 0.9, -0.1, -0.5 }, 0.3, 1.0, 1.0 },
  { "inside", { 0.0, 0.0, 0.0 }, 1.0, 0.0, FromEye, 0.25, 0.2, 0.6 },
} };

constexpr double InsideDistance = 0.3; // at which a lamp in the middle has its radiance

Vector3 Scale(double factor, const Vector3& vector)
{
  return { factor * vector[0], factor * vector[1], factor * vector[2] };
}

// A surface that faces a lamp of intensity I at distance r sends albedo/pi * I/r^2.
LightSource MakeLamp(const Place& place, const Mood& mood, const Vector3& center, double reach)
{
  LightSource lamp;
  const Vector3 offset = Scale(reach, place.Lamp);
  vtkMath::Add(center.data(), offset.data(), lamp.Position.data());
  const double distance = std::max(vtkMath::Norm(offset.data()), InsideDistance * reach);
  lamp.Power = Scale(
    place.Radiance * mood.LampRadiance * vtkMath::Pi() * distance * distance, mood.LampColour);
  if (place.SpotAngle > 0.0)
  {
    lamp.Type = LightSource::Kind::Spot;
    lamp.Direction = Scale(-1.0, offset);
    lamp.ConeHalfAngle = place.SpotAngle;
  }
  return lamp;
}

LightSource MakeFill(const Place& place, const Mood& mood)
{
  LightSource fill;
  fill.Type = LightSource::Kind::Directional;
  fill.Direction = place.Fill;
  fill.Power = Scale(place.FillShare * mood.FillRadiance * vtkMath::Pi(), mood.FillColour);
  fill.Scatters = false;
  return fill;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetLampPlaces()
{
  std::vector<std::string> names;
  names.reserve(Places.size());
  for (const Place& place : Places)
  {
    names.emplace_back(place.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
ModelLights MakeModelLights(
  const std::string& name, const Mood& mood, const Vector3& center, double reach)
{
  const auto* place = std::find_if(
    Places.begin(), Places.end(), [&name](const Place& entry) { return entry.Name == name; });
  if (place == Places.end())
  {
    throw UserError(
      "unknown place of a lamp '" + name + "': expected " + ListNames(GetLampPlaces()));
  }
  return { { MakeLamp(*place, mood, center, reach), MakeFill(*place, mood) }, place->Ambient,
    place->Brightness };
}

//------------------------------------------------------------------------------
std::vector<LightSource> ScaleLights(
  const std::vector<LightSource>& lights, const Mood& mood, const Vector3& center, double diagonal)
{
  const double nearest = std::pow(InsideDistance * diagonal, 2);
  double sum = 0.0;
  for (const LightSource& light : lights)
  {
    const double brightest = *std::max_element(light.Power.begin(), light.Power.end());
    const double squared = vtkMath::Distance2BetweenPoints(light.Position.data(), center.data());
    sum += light.Type == LightSource::Kind::Directional ? brightest
                                                        : brightest / std::max(squared, nearest);
  }
  const double factor = mood.LampRadiance * vtkMath::Pi() / sum;
  if (!std::isnormal(factor))
  {
    return {};
  }
  std::vector<LightSource> scaled = lights;
  for (LightSource& light : scaled)
  {
    light.Power = Scale(factor, light.Power);
  }
  return scaled;
}

//------------------------------------------------------------------------------
void TurnLights(std::vector<LightSource>& lights, const Vector3& center, const ModelAxes& axes)
{
  for (LightSource& light : lights)
  {
    Vector3 offset;
    vtkMath::Subtract(light.Position.data(), center.data(), offset.data());
    vtkMath::Add(center.data(), Turn(offset, axes).data(), light.Position.data());
    light.Direction = Turn(light.Direction, axes);
  }
}

}
