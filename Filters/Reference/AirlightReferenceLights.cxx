// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceLights.h"

#include "Photometry/AirlightLightProperties.h"
#include "Reference/AirlightReferenceLamp.h"
#include "Reference/AirlightReferenceSurface.h"
#include "Scene/AirlightVTKVersions.h"
#include "vtkAirlightLight.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace airlight
{
namespace
{
// What double precision resolves of the distance between a ray and a light, with some room.
constexpr double RelativeRadius = 1e-12;

ReferenceLight Convert(
  vtkLight* light, const f64::AirlightMedia& media, const glm::dvec3& eye, double radius)
{
  ReferenceLight result;
  result.Support = ConvertLight(media, light, eye, result.Values);
  if (result.Support == LightSupport::Scatters)
  {
    const bool directional = f64::airlightIsDirectional(result.Values);
    result.World = directional ? HomogeneousPoint(result.Values.position, 0.0)
                               : HomogeneousPoint(result.Values.position + eye, 1.0);
    const double distance = directional ? 1.0 : glm::length(result.Values.position);
    result.Values.radius = std::max({ radius, RelativeRadius * distance, 1e-100 });
    // A headlight sees what the camera sees: all its shadows lie behind what casts them.
    result.CastsShadows = !light->LightTypeIsHeadlight();
  }
  if (!vtkAirlightLight::GetScatters(light))
  {
    result.LeftOut =
      result.Support == LightSupport::Scatters && !GetProperties(light).ScattersIsSet;
    result.CastsShadows = result.CastsShadows && !IsFixedToCamera(light);
    result.Values.intensity = glm::dvec3(0.0);
  }
  light->GetDiffuseColor(&result.Colour.x);
  result.Colour *= light->GetIntensity();
  result.Positional = light->GetPositional() != 0;
  glm::dvec3 focalPoint;
  light->GetTransformedPosition(&result.Position.x);
  light->GetTransformedFocalPoint(&focalPoint.x);
  result.Direction = focalPoint - result.Position;
  const double length = glm::length(result.Direction);
  result.Direction = length > 0.0 ? result.Direction / length : result.Direction;
  light->GetAttenuationValues(&result.Attenuation.x);
  result.ConeAngle = light->GetConeAngle();
  result.Exponent = light->GetExponent();
  return result;
}

glm::dvec3 TransformDirection(vtkLight* light, vtkRenderer* renderer, const glm::dvec3& direction)
{
  vtkMatrix4x4* matrix = light->LightTypeIsHeadlight()
    ? renderer->GetActiveCamera()->GetCameraLightTransformMatrix()
    : light->GetTransformMatrix();
  glm::dvec3 result = direction;
  for (int i = 0; matrix && i < 3; ++i)
  {
    result[i] = matrix->GetElement(i, 0) * direction.x + matrix->GetElement(i, 1) * direction.y +
      matrix->GetElement(i, 2) * direction.z;
  }
  return result;
}

// The photometric file of a light, for what was made of it.
void ApplyPhotometry(vtkLight* light, vtkRenderer* renderer, ReferenceLight& result)
{
  const LightProperties& properties = GetProperties(light);
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  light->GetTransformedPosition(&position.x);
  light->GetTransformedFocalPoint(&focalPoint.x);
  const glm::dvec3 axis = focalPoint - position;
  if (!properties.Table || result.Support != LightSupport::Scatters ||
    f64::airlightIsDirectional(result.Values) || !(glm::length(axis) > 0.0))
  {
    return;
  }
  result.Table = properties.Table;
  result.Values.kind = AIRLIGHT_POINT_QUADRATURE;
  result.Values.goniometric = 1;
  f64::AirlightPhotometry& photometry = result.Values.photometry;
  photometry.data = result.Table->data();
  photometry.axis = glm::normalize(axis);
  photometry.up =
    GetUpAcross(photometry.axis, TransformDirection(light, renderer, properties.PhotometryUp));
}

// The light's direction at a point and what is left of it there.
glm::dvec3 GetDirection(
  const ReferenceLight& light, const glm::dvec3& position, double& attenuation)
{
  attenuation = 1.0;
  if (!light.Positional)
  {
    return light.Direction;
  }
  const glm::dvec3 way = position - light.Position;
  const double r = glm::length(way);
  const glm::dvec3 direction = r > 0.0 ? way / r : glm::dvec3(0.0);
  const glm::dvec3& a = light.Attenuation;
  attenuation = 1.0 / (a.x + r * (a.y + r * a.z));
  if (light.ConeAngle < 90.0)
  {
    const double cosine = glm::dot(direction, light.Direction);
    attenuation *=
      cosine >= std::cos(glm::radians(light.ConeAngle)) ? std::pow(cosine, light.Exponent) : 0.0;
  }
  return direction;
}
}

//------------------------------------------------------------------------------
ReferenceLights::ReferenceLights(vtkRenderer* renderer, const f64::AirlightMedia& media,
  const glm::dvec3& eye, double radius, int lampPoints)
{
  vtkLightCollection* lights = renderer->GetLights();
  const auto visit = [&](const std::function<void(vtkLight*)>& use) {
    vtkCollectionSimpleIterator it = nullptr;
    lights->InitTraversal(it);
    while (vtkLight* light = lights->GetNextLight(it))
    {
      if (light->GetSwitch())
      {
        use(light);
      }
    }
  };
  int count = 0;
  visit([&](vtkLight*) { ++count; });
  if (count == 0 && renderer->GetAutomaticLightCreation())
  {
    renderer->CreateLight();
  }
  if (renderer->GetLightFollowCamera())
  {
    renderer->UpdateLightsGeometryToFollowCamera();
  }
  visit([&](vtkLight* light) {
    this->Points.push_back(Convert(light, media, eye, radius));
    for (vtkLight* lamp : SplitLamp(light, lampPoints))
    {
      this->Lights.push_back(Convert(lamp, media, eye, radius));
      ApplyPhotometry(light, renderer, this->Lights.back());
    }
    this->IsHeadlight =
      this->Lights.size() == 1 && light->LightTypeIsHeadlight() && !light->GetPositional();
  });
  renderer->GetActiveCamera()->GetDirectionOfProjection(&this->Forward.x);
}

//------------------------------------------------------------------------------
bool ReferenceLights::HasInvalid() const
{
  return std::any_of(this->Lights.begin(), this->Lights.end(),
    [](const ReferenceLight& light) { return light.Support == LightSupport::Invalid; });
}

//------------------------------------------------------------------------------
std::string ReferenceLights::DescribeLeftOut() const
{
  const auto count = std::count_if(this->Lights.begin(), this->Lights.end(),
    [](const ReferenceLight& light) { return light.LeftOut; });
  const bool dark =
    std::all_of(this->Lights.begin(), this->Lights.end(), [](const ReferenceLight& light) {
      return light.Support != LightSupport::Scatters || light.Values.intensity == glm::dvec3(0.0);
    });
  return count > 0 ? GetCameraLightsText(static_cast<int>(count), dark) : "";
}

//------------------------------------------------------------------------------
glm::dvec4 ReferenceLights::Shade(const ReferencePart& part, const OccluderTriangle& triangle,
  const glm::dvec3& position, const glm::dvec3& direction, const glm::dvec3& eye,
  const std::vector<glm::dvec3>& arriving) const
{
  const ReferenceSurface surface(part, triangle, position, direction);
  const ReferenceMaterial& material = surface.Material;
  if (!part.Lighting || this->Lights.empty())
  {
    return { material.Ambient + material.Diffuse, material.Opacity };
  }
  const glm::dvec3& normal = surface.Normal;
  const glm::dvec3 toEye = glm::normalize(eye - position);
  glm::dvec3 diffuse(0.0);
  glm::dvec3 specular(0.0);
  for (size_t k = 0; k < this->Lights.size(); ++k)
  {
    const glm::dvec3 colour = this->Lights[k].Colour * arriving[k];
    double attenuation = 0.0;
    const glm::dvec3 way = GetDirection(this->Lights[k], position, attenuation);
    const double towards = this->IsHeadlight
      ? std::max(LeastToHeadlight, glm::dot(normal, -this->Forward))
      : std::max(0.0, attenuation * glm::dot(normal, -way));
    diffuse += towards * colour;
    if (this->IsHeadlight)
    {
      specular += std::pow(towards, material.SpecularPower) * colour;
    }
    else if (towards > 0.0)
    {
      const double cosine = std::max(LeastReflection, glm::dot(glm::reflect(way, normal), toEye));
      specular += attenuation * std::pow(cosine, material.SpecularPower) * colour;
    }
  }
  return { material.Ambient + diffuse * material.Diffuse + specular * material.Specular,
    material.Opacity };
}
}
