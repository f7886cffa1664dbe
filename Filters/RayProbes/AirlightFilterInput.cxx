// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RayProbes/AirlightFilterInput.h"

#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkParticipatingMedium.h"
#include "vtkPolyData.h"

namespace airlight
{
//------------------------------------------------------------------------------
Occluders CollectOccluders(vtkInformationVector* input)
{
  Occluders occluders;
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    occluders.Add(vtkPolyData::GetData(input, i), nullptr, i);
  }
  occluders.Build();
  return occluders;
}

//------------------------------------------------------------------------------
HomogeneousPoint GetHomogeneousPosition(vtkLight* light)
{
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  light->GetTransformedPosition(&position.x);
  light->GetTransformedFocalPoint(&focalPoint.x);
  return light->GetPositional() ? HomogeneousPoint(position, 1.0)
                                : HomogeneousPoint(glm::normalize(position - focalPoint), 0.0);
}

//------------------------------------------------------------------------------
LightSupport ConvertSceneLight(const f64::AirlightMedia& media, vtkLight* light,
  const glm::dvec3& origin, f64::AirlightLight& sceneLight)
{
  const LightSupport support = ConvertLight(media, light, origin, sceneLight);
  sceneLight.radius = std::max(1e-12 * glm::length(sceneLight.position), 1e-100);
  return support;
}

//------------------------------------------------------------------------------
bool CheckSceneLight(vtkObject* filter, vtkParticipatingMedium* medium, vtkLight* light)
{
  f64::AirlightLight sceneLight;
  const f64::AirlightMedia media = ConvertMedia({ medium }, glm::dvec3(0.0));
  if (ConvertLight(media, light, glm::dvec3(0.0), sceneLight) != LightSupport::Invalid)
  {
    return true;
  }
  glm::dvec3 p;
  glm::dvec3 a;
  light->GetTransformedPosition(&p.x);
  light->GetAttenuationValues(&a.x);
  vtkErrorWithObjectMacro(filter,
    "The light at ("
      << p.x << ", " << p.y << ", " << p.z << ") with attenuation (" << a.x << ", " << a.y << ", "
      << a.z << ") and exponent " << light->GetExponent()
      << " cannot be used: its position, colour and attenuation must be finite, its "
         "attenuation at least 0 with one term above 0, its exponent at least 0, and "
         "the focal point of a spot or a directional light apart from its position.");
  return false;
}

//------------------------------------------------------------------------------
vtkMTimeType GetLightTime(vtkLight* light)
{
  vtkMatrix4x4* matrix = light->GetTransformMatrix();
  return std::max(light->GetMTime(), matrix ? matrix->GetMTime() : 0);
}
}
