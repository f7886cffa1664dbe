// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightLamps.h"

#include "AirlightView.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace airlight
{
namespace
{
// What single precision resolves of the distance between a ray and a light.
constexpr double RelativeRadius = 1e-5;

Lamp MakeLamp(vtkLight* light, const f64::AirlightMedia& media, const View& view, double radius)
{
  Lamp lamp;
  lamp.Light = light;
  lamp.Support = ConvertLight(media, light, view.GetEye(), lamp.Values);
  if (lamp.Scatters())
  {
    const bool directional = f64::airlightIsDirectional(lamp.Values);
    lamp.World = directional ? glm::dvec4(lamp.Values.position, 0.0)
                             : glm::dvec4(lamp.Values.position + view.GetEye(), 1.0);
    const double distance = directional ? 1.0 : glm::length(lamp.Values.position);
    lamp.Values.radius = std::max(radius, RelativeRadius * std::max(distance, view.GetNear()));
    // A headlight sees what the camera sees: all its shadows lie behind what casts them.
    lamp.CastsShadows = !light->LightTypeIsHeadlight();
  }
  return lamp;
}
}

//------------------------------------------------------------------------------
std::vector<Lamp> CollectLamps(
  vtkRenderer* renderer, const f64::AirlightMedia& media, const View& view, double radius)
{
  std::vector<Lamp> lamps;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (light->GetSwitch())
    {
      lamps.push_back(MakeLamp(light, media, view, radius));
    }
  }
  return lamps;
}
}
