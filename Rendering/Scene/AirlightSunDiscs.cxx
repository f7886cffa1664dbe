// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSunDiscs.h"

#include "AirlightSunDisc.h"
#include "OpenGL/AirlightProgram.h"
#include "Photometry/AirlightLightProperties.h"
#include "vtkAirlightLight.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace airlight
{
namespace
{
constexpr double LargestRadiance = 1e30; // single precision holds no more, times an exposure

bool IsShownSun(vtkLight* light)
{
  return light->GetSwitch() && !light->GetPositional() && light->LightTypeIsSceneLight() &&
    GetProperties(light).Visible;
}

SunDisc MakeSunDisc(vtkLight* light)
{
  SunDisc sun;
  glm::dvec3 position;
  glm::dvec3 focalPoint;
  light->GetTransformedPosition(&position.x);
  light->GetTransformedFocalPoint(&focalPoint.x);
  const double length = glm::length(position - focalPoint);
  if (length > 0.0)
  {
    sun.Towards = (position - focalPoint) / length;
    sun.Chord = 2.0 * std::sin(0.25 * glm::radians(GetProperties(light).Extent.AngularDiameter));
    // A cap of the unit sphere has the area of a disc whose radius is its chord.
    const double solidAngle = vtkMath::Pi() * sun.Chord * sun.Chord;
    vtkAirlightLight::GetRadiantIntensity(light, &sun.Radiance.x); // its irradiance
    sun.Radiance = glm::min(sun.Radiance / solidAngle, glm::dvec3(LargestRadiance));
  }
  return sun;
}
}

//------------------------------------------------------------------------------
std::vector<SunDisc> CollectSunDiscs(vtkRenderer* renderer)
{
  std::vector<SunDisc> suns;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (IsShownSun(light) && !IsInvisibleSun(light) && suns.size() < MaximumSunDiscs &&
      !renderer->GetActiveCamera()->GetParallelProjection())
    {
      suns.push_back(MakeSunDisc(light));
    }
  }
  return suns;
}

//------------------------------------------------------------------------------
bool IsInvisibleSun(vtkLight* light)
{
  return IsShownSun(light) && !(GetProperties(light).Extent.AngularDiameter > 0.0);
}

//------------------------------------------------------------------------------
std::string GetSunSource(const std::vector<SunDisc>& suns)
{
  return suns.empty() ? ""
                      : Define("AIRLIGHT_SUNS", static_cast<int>(suns.size())) + AirlightSunDisc;
}

//------------------------------------------------------------------------------
void SetSunUniforms(vtkShaderProgram* program, const std::vector<SunDisc>& suns)
{
  std::vector<glm::vec4> towards;
  std::vector<glm::vec3> radiances;
  for (const SunDisc& sun : suns)
  {
    towards.emplace_back(sun.Towards, sun.Chord * sun.Chord);
    radiances.emplace_back(sun.Radiance);
  }
  if (!suns.empty())
  {
    const int count = static_cast<int>(suns.size());
    program->SetUniform4fv("airlightSunTowards", count, &towards[0].x);
    program->SetUniform3fv("airlightSunRadiance", count, &radiances[0].x);
  }
}
}
