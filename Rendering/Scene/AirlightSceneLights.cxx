// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneLights.h"

#include "Integration/AirlightMatrix.h"
#include "Photometry/AirlightLightProperties.h"
#include "Scene/AirlightCameraUniforms.h"
#include "vtkAirlightLight.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// What single precision resolves of the distance between a ray and a light.
constexpr double RelativeRadius = 1e-5;

SceneLight MakeSceneLight(
  vtkLight* light, const f64::AirlightMedia& media, const CameraUniforms& view, double radius)
{
  SceneLight sceneLight;
  sceneLight.Light = light;
  sceneLight.Support = ConvertLight(media, light, view.GetEye(), sceneLight.Values);
  if (sceneLight.Scatters())
  {
    const bool directional = f64::airlightIsDirectional(sceneLight.Values);
    sceneLight.World = directional ? glm::dvec4(sceneLight.Values.position, 0.0)
                                   : glm::dvec4(sceneLight.Values.position + view.GetEye(), 1.0);
    const double distance = directional ? 1.0 : glm::length(sceneLight.Values.position);
    sceneLight.Values.radius =
      std::max(radius, RelativeRadius * std::max(distance, view.GetNear()));
    // A headlight sees what the camera sees: all its shadows lie behind what casts them.
    sceneLight.CastsShadows = !light->LightTypeIsHeadlight();
  }
  return sceneLight;
}

// The camera carries headlights and camera lights along; VTK gives its matrix to the latter only.
glm::dvec3 TransformDirection(vtkLight* light, vtkRenderer* renderer, const glm::dvec3& direction)
{
  vtkMatrix4x4* matrix = light->LightTypeIsHeadlight()
    ? renderer->GetActiveCamera()->GetCameraLightTransformMatrix()
    : light->GetTransformMatrix();
  return matrix ? glm::dvec3(ToGlm(matrix) * glm::dvec4(direction, 0.0)) : direction;
}

// A light without power in the medium still lights surfaces: those have its colour from VTK.
void LeaveOut(SceneLight& sceneLight)
{
  if (vtkAirlightLight::GetScatters(sceneLight.Light))
  {
    return;
  }
  sceneLight.LeftOut = sceneLight.HasPower() && !GetProperties(sceneLight.Light).ScattersIsSet;
  sceneLight.CastsShadows = sceneLight.CastsShadows && !IsFixedToCamera(sceneLight.Light);
  sceneLight.Values.intensity = glm::dvec3(0.0);
}

void ApplyPhotometry(vtkRenderer* renderer, SceneLight& sceneLight)
{
  const LightProperties& properties = GetProperties(sceneLight.Light);
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  sceneLight.Light->GetTransformedPosition(&position.x);
  sceneLight.Light->GetTransformedFocalPoint(&focalPoint.x);
  const glm::dvec3 axis = focalPoint - position;
  if (!properties.Table || !sceneLight.Scatters() ||
    f64::airlightIsDirectional(sceneLight.Values) || !(glm::length(axis) > 0.0))
  {
    return;
  }
  sceneLight.Table = properties.Table;
  sceneLight.Values.kind = AIRLIGHT_POINT_QUADRATURE;
  sceneLight.Values.goniometric = 1;
  sceneLight.Values.photometry.axis = glm::normalize(axis);
  sceneLight.Values.photometry.up =
    MakeAcross(TransformDirection(sceneLight.Light, renderer, properties.PhotometryUp),
      sceneLight.Values.photometry.axis);
}
}

//------------------------------------------------------------------------------
glm::dvec3 MakeAcross(glm::dvec3 up, const glm::dvec3& axis)
{
  // Squares of very small or large components would leave the range of numbers.
  up /= std::max({ std::abs(up.x), std::abs(up.y), std::abs(up.z) });
  for (const glm::dvec3& other : { up, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(1.0, 0.0, 0.0) })
  {
    const glm::dvec3 across = other - glm::dot(other, axis) * axis;
    if (glm::length(across) > 1e-6 * glm::length(other))
    {
      return glm::normalize(across);
    }
  }
  return glm::dvec3(0.0, 1.0, 0.0);
}

//------------------------------------------------------------------------------
std::vector<SceneLight> CollectSceneLights(vtkRenderer* renderer, const f64::AirlightMedia& media,
  const CameraUniforms& view, double radius, bool photometric)
{
  std::vector<SceneLight> sceneLights;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      sceneLights.push_back(MakeSceneLight(light, media, view, radius));
      LeaveOut(sceneLights.back());
      if (photometric)
      {
        ApplyPhotometry(renderer, sceneLights.back());
      }
    }
  }
  return sceneLights;
}

//------------------------------------------------------------------------------
int AddMultipleLamps(const std::vector<SceneLight>& sceneLights, f64::AirlightMedia& media)
{
  return static_cast<int>(
    std::count_if(sceneLights.begin(), sceneLights.end(), [&](const SceneLight& sceneLight) {
      f64::AirlightLight light = sceneLight.Values;
      if (sceneLight.Table)
      {
        light.photometry.data = sceneLight.Table->data();
        light.photometry.first = 0;
      }
      return sceneLight.HasPower() && !AddMultipleLamp(media, light);
    }));
}

//------------------------------------------------------------------------------
std::string DescribeLeftOut(const std::vector<SceneLight>& sceneLights)
{
  const auto count = std::count_if(sceneLights.begin(), sceneLights.end(), IsLeftOut);
  const bool dark = std::none_of(sceneLights.begin(), sceneLights.end(),
    [](const SceneLight& sceneLight) { return sceneLight.HasPower(); });
  return GetCameraLightsText(static_cast<int>(count), dark);
}

//------------------------------------------------------------------------------
int CommonKind(const std::vector<SceneLight>& sceneLights)
{
  int kind = AIRLIGHT_POINT_CLOSED;
  bool first = true;
  for (const SceneLight& sceneLight : sceneLights)
  {
    if (sceneLight.HasPower())
    {
      kind = first || sceneLight.Values.kind == kind ? sceneLight.Values.kind : -1;
      first = false;
    }
  }
  return kind;
}
}
