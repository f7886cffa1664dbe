// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ImportedLights.h"

#include <vtkCamera.h>
#include <vtkGLTFImporter.h>
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

LightSource MakeLamp(vtkLight* light, const std::string& extension, const Vector3& center)
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

bool IsUsable(const LightSource& lamp)
{
  return IsFinite(lamp.Position) && IsFinite(lamp.Direction) && IsFinite(lamp.Power) &&
    vtkMath::Norm(lamp.Power.data()) > 0.0 &&
    (lamp.Type == LightSource::Kind::Point ||
      vtkMath::Norm(lamp.Direction.data()) > DirectionEpsilon);
}
}

//------------------------------------------------------------------------------
std::vector<LightSource> GetImportedLights(
  vtkRenderer* renderer, const std::string& extension, const Vector3& center)
{
  std::vector<LightSource> lamps;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal();
  while (vtkLight* light = lights->GetNextItem())
  {
    const LightSource lamp = MakeLamp(light, extension, center);
    if (light->GetSwitch() && IsUsable(lamp))
    {
      lamps.push_back(lamp);
    }
  }
  return lamps;
}

//------------------------------------------------------------------------------
std::optional<CameraSettings> GetImportedCamera(
  vtkImporter* importer, vtkRenderer* renderer, const Vector3& center)
{
  vtkSmartPointer<vtkCamera> camera;
  auto* gltf = vtkGLTFImporter::SafeDownCast(importer);
  if (gltf && gltf->GetNumberOfCameras() > 0)
  {
    camera = gltf->GetCamera(0);
  }
  else if (!gltf && renderer->IsActiveCameraCreated())
  {
    camera = renderer->GetActiveCamera();
  }
  if (!camera || camera->GetParallelProjection())
  {
    return std::nullopt;
  }
  CameraSettings settings;
  std::copy_n(camera->GetPosition(), 3, settings.Position.begin());
  std::copy_n(camera->GetViewUp(), 3, settings.ViewUp.begin());
  settings.ViewAngle = std::clamp(camera->GetViewAngle(), 0.001, 179.0);
  Vector3 forward = Subtract(camera->GetFocalPoint(), camera->GetPosition());
  Vector3 right;
  vtkMath::Cross(forward.data(), settings.ViewUp.data(), right.data());
  if (!IsFinite(settings.Position) || !IsFinite(right) ||
    !(vtkMath::Norm(right.data()) > DirectionEpsilon))
  {
    return std::nullopt;
  }
  vtkMath::Normalize(forward.data());
  const Vector3 way = Subtract(center.data(), settings.Position.data());
  const double ahead = vtkMath::Dot(way.data(), forward.data());
  // Who looks away from the middle looks as far as it is away.
  vtkMath::MultiplyScalar(
    forward.data(), ahead > 0.0 ? ahead : std::max(vtkMath::Norm(way.data()), 1e-30));
  vtkMath::Add(settings.Position.data(), forward.data(), settings.FocalPoint.data());
  return settings;
}

}
