// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightUnseenLights.h"

#include "Scene/AirlightLampShapes.h"
#include "Scene/AirlightSunDiscs.h"
#include "vtkAirlight.h"
#include "vtkAirlightLight.h"
#include "vtkParticipatingMedium.h"

#include "vtkCamera.h"
#include "vtkLight.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr double Far = 1e12; // world units, on the way to the sun

std::string GetRemedy(UnseenReason reason)
{
  switch (reason)
  {
    case UnseenReason::NoExtent:
      return "it is a point: call SetRadius(), or SetSize() with a width and a height above 0, or "
             "for a directional light SetAngularDiameter()";
    case UnseenReason::FixedToCamera:
      return "it is fixed to the camera: call vtkLight::SetLightTypeToSceneLight()";
    case UnseenReason::ParallelProjection:
      return "all rays of a parallel projection have one direction, so that none shows a disc in "
             "the sky: call vtkCamera::ParallelProjectionOff()";
    case UnseenReason::UnboundedMedium:
      return "the medium between it and the eye has no end: give the medium a region, as by "
             "SetRegionToBox(), or a density that thins out, as by SetDensityToExponentialHeight()";
    default:
      return "the first " + std::to_string(MaximumSunDiscs) +
        " directional lights alone are shown: call SetVisible(light, false) for others";
  }
}

UnseenLight Describe(int number, vtkLight* light, UnseenReason reason)
{
  return { reason,
    "vtkAirlightLight::SetVisible() was called for light " + std::to_string(number) +
      " (of those that are on, from 0; a " +
      (light->GetPositional() ? "positional" : "directional") +
      " one), of which nothing is seen: " + GetRemedy(reason) +
      ", or SetVisible(light, false) to silence this." };
}

// Other regions and images end somewhere.
bool IsOpaque(vtkParticipatingMedium* medium, vtkCamera* camera, vtkLight* sun)
{
  if (medium->GetRegion() != vtkParticipatingMedium::UNBOUNDED ||
    medium->GetDensity() == vtkParticipatingMedium::IMAGE)
  {
    return false;
  }
  glm::dvec3 eye;
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  camera->GetPosition(&eye.x);
  sun->GetTransformedPosition(&position.x);
  sun->GetTransformedFocalPoint(&focalPoint.x);
  const double length = glm::length(position - focalPoint);
  const glm::dvec3 end = eye + (length > 0.0 ? Far / length : 0.0) * (position - focalPoint);
  glm::dvec3 rgb(1.0);
  vtkAirlight::Transmittance(medium, &eye.x, &end.x, &rgb.x);
  return rgb == glm::dvec3(0.0);
}

UnseenReason FindSunReason(
  vtkLight* sun, vtkCamera* camera, const std::vector<vtkParticipatingMedium*>& media)
{
  if (camera->GetParallelProjection())
  {
    return UnseenReason::ParallelProjection;
  }
  const bool hidden = std::any_of(media.begin(), media.end(),
    [&](vtkParticipatingMedium* medium) { return IsOpaque(medium, camera, sun); });
  return hidden ? UnseenReason::UnboundedMedium : UnseenReason::None;
}
}

//------------------------------------------------------------------------------
std::vector<UnseenLight> FindUnseenLights(const std::vector<SceneLight>& lights, vtkCamera* camera,
  const std::vector<vtkParticipatingMedium*>& media)
{
  std::vector<UnseenLight> unseen;
  std::size_t suns = 0;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    vtkLight* light = lights[k].Light;
    if (!vtkAirlightLight::GetVisible(light))
    {
      continue;
    }
    UnseenReason reason = UnseenReason::None;
    if (!light->LightTypeIsSceneLight())
    {
      reason = UnseenReason::FixedToCamera;
    }
    else if (IsInvisiblePoint(light) || IsInvisibleSun(light))
    {
      reason = UnseenReason::NoExtent;
    }
    else if (!light->GetPositional())
    {
      reason =
        ++suns > MaximumSunDiscs ? UnseenReason::TooManySuns : FindSunReason(light, camera, media);
    }
    if (reason != UnseenReason::None)
    {
      unseen.push_back(Describe(static_cast<int>(k), light, reason));
    }
  }
  return unseen;
}
}
