// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ImportedLights.h"

#include "formats/GLTFNodes.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace airlight
{

namespace
{
constexpr double DirectionEpsilon = 1e-12;
constexpr double NearestFocus = 0.1; // diagonals; inside a model the middle may be anywhere

bool IsFinite(const Vector3& vector)
{
  return std::all_of(vector.begin(), vector.end(),
    [](double x) { return std::isfinite(x) && std::abs(x) <= LargestNumber; });
}

Vector3 Subtract(const double a[3], const double b[3])
{
  Vector3 difference;
  vtkMath::Subtract(a, b, difference.data());
  return difference;
}

// A glTF lamp is at the origin of its node and shines along -z.
void PlaceByNode(vtkMatrix4x4* node, LightSource& lamp)
{
  for (int i = 0; i < 3; ++i)
  {
    lamp.Position[i] = node->GetElement(i, 3);
    lamp.Direction[i] = -node->GetElement(i, 2);
  }
}

void Place3DS(vtkLight* light, const Vector3& center, LightSource& lamp)
{
  std::copy_n(light->GetPosition(), 3, lamp.Position.begin());
  lamp.Direction = Subtract(light->GetFocalPoint(), light->GetPosition());
  if (light->GetPositional())
  {
    lamp.Type = LightSource::Kind::Spot;
    lamp.ConeHalfAngle = 0.5 * light->GetConeAngle(); // the file has whole angles
  }
  else
  {
    lamp.Type = LightSource::Kind::Point;
  }
  vtkMath::MultiplyScalar(
    lamp.Power.data(), vtkMath::Distance2BetweenPoints(lamp.Position.data(), center.data()));
}

// `before`: lights in the same place that come before it.
LightSource MakeLamp(vtkLight* light, int before, vtkImporter* importer,
  const std::string& extension, const Vector3& center)
{
  LightSource lamp;
  for (int i = 0; i < 3; ++i)
  {
    lamp.Power[i] = std::max(0.0, light->GetIntensity() * light->GetDiffuseColor()[i]);
  }
  if (!light->GetPositional())
  {
    lamp.Type = LightSource::Kind::Directional;
  }
  else if (light->GetConeAngle() < 90.0)
  {
    lamp.Type = LightSource::Kind::Spot;
    lamp.ConeHalfAngle = light->GetConeAngle();
  }
  if (light->GetTransformMatrix())
  {
    PlaceByNode(light->GetTransformMatrix(), lamp);
    auto* gltf = GLTFNodes::SafeDownCast(importer);
    if (gltf && lamp.Type == LightSource::Kind::Spot)
    {
      lamp.Exponent = FindSpotExponent(gltf->GetInnerConeAngle(light, before), lamp.ConeHalfAngle);
    }
  }
  else if (extension == "3ds")
  {
    Place3DS(light, center, lamp);
  }
  else // VRML: VTK leaves the direction in the focal point
  {
    std::copy_n(light->GetFocalPoint(), 3, lamp.Direction.begin());
  }
  lamp.ConeHalfAngle = std::clamp(lamp.ConeHalfAngle, SmallestConeAngle, LargestConeAngle);
  return lamp;
}

int CountBefore(vtkLightCollection* lights, vtkLight* light)
{
  int count = 0;
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  for (vtkLight* other = lights->GetNextLight(it); other && other != light;
       other = lights->GetNextLight(it))
  {
    count += IsSame(other->GetTransformMatrix(), light->GetTransformMatrix()) ? 1 : 0;
  }
  return count;
}

bool IsUsable(const LightSource& lamp)
{
  return IsFinite(lamp.Position) && IsFinite(lamp.Direction) && IsFinite(lamp.Power) &&
    vtkMath::Norm(lamp.Power.data()) > 0.0 &&
    (lamp.Type == LightSource::Kind::Point ||
      vtkMath::Norm(lamp.Direction.data()) > DirectionEpsilon);
}

// The last of the file; VRML's are not read.
std::optional<CameraSettings> Find3DSCamera(vtkRenderer* renderer)
{
  if (!renderer->IsActiveCameraCreated() || renderer->GetActiveCamera()->GetParallelProjection())
  {
    return std::nullopt;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  CameraSettings settings;
  std::copy_n(camera->GetPosition(), 3, settings.Position.begin());
  std::copy_n(camera->GetFocalPoint(), 3, settings.FocalPoint.begin());
  std::copy_n(camera->GetViewUp(), 3, settings.ViewUp.begin());
  settings.ViewAngle = camera->GetViewAngle();
  settings.Vertical = Vector3{ 0.0, 0.0, 1.0 };
  return settings;
}
}

//------------------------------------------------------------------------------
// The light is 2 pi times the integral of the intensity over the cosine: of KHR_lights_punctual's
// square of a linear ramp 1 - inner + (inner - outer)/3, of a power n (1 - outer^(n + 1))/(n + 1),
// which falls with n.
double FindSpotExponent(double innerAngle, double outerAngle)
{
  const double inner = std::cos(vtkMath::RadiansFromDegrees(std::min(innerAngle, outerAngle)));
  const double outer = std::cos(vtkMath::RadiansFromDegrees(outerAngle));
  const double light = 1.0 - inner + (inner - outer) / 3.0;
  double low = 0.0;
  double high = LargestExponent;
  for (int i = 0; i < 50 && innerAngle < outerAngle; ++i)
  {
    const double middle = 0.5 * (low + high);
    const bool more = (1.0 - std::pow(outer, middle + 1.0)) / (middle + 1.0) > light;
    (more ? low : high) = middle;
  }
  return low;
}

//------------------------------------------------------------------------------
std::vector<LightSource> GetImportedLights(
  vtkImporter* importer, vtkRenderer* renderer, const std::string& extension, const Vector3& center)
{
  std::vector<LightSource> lamps;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal();
  while (vtkLight* light = lights->GetNextItem())
  {
    const LightSource lamp =
      MakeLamp(light, CountBefore(lights, light), importer, extension, center);
    if (light->GetSwitch() && IsUsable(lamp))
    {
      lamps.push_back(lamp);
    }
  }
  return lamps;
}

//------------------------------------------------------------------------------
std::optional<CameraSettings> GetImportedCamera(
  vtkImporter* importer, vtkRenderer* renderer, const Vector3& center, double diagonal)
{
  auto* gltf = GLTFNodes::SafeDownCast(importer);
  std::optional<CameraSettings> camera = gltf ? gltf->FindCamera() : Find3DSCamera(renderer);
  if (!camera)
  {
    return std::nullopt;
  }
  camera->ViewAngle = std::clamp(camera->ViewAngle, 0.001, 179.0);
  Vector3 forward = Subtract(camera->FocalPoint.data(), camera->Position.data());
  Vector3 right;
  vtkMath::Cross(forward.data(), camera->ViewUp.data(), right.data());
  if (!IsFinite(camera->Position) || !IsFinite(right) ||
    !(vtkMath::Norm(right.data()) > DirectionEpsilon))
  {
    return std::nullopt;
  }
  vtkMath::Normalize(forward.data());
  const Vector3 way = Subtract(center.data(), camera->Position.data());
  const double ahead = vtkMath::Dot(way.data(), forward.data());
  // Who looks away from the middle looks as far as it is away.
  const double distance = ahead > 0.0 ? ahead : vtkMath::Norm(way.data());
  vtkMath::MultiplyScalar(forward.data(), std::max(distance, NearestFocus * diagonal));
  vtkMath::Add(camera->Position.data(), forward.data(), camera->FocalPoint.data());
  return camera;
}

}
