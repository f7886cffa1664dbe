// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightLight stores in a vtkLight's information.
 */

#ifndef AirlightLightProperties_h
#define AirlightLightProperties_h

#include "Photometry/AirlightPhotometry.h"
#include "vtkAirlightModule.h" // for export macro

#include "vtkLight.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace airlight
{
// vtkAirlightLight::SetRadius() and the like.
struct LampExtent
{
  double Radius = 0.0;
  glm::dvec2 Size{ 0.0, 0.0 };
  double AngularDiameter = 0.0; // degrees
};

struct LightProperties
{
  bool ScattersIsSet = false;
  bool Scatters = false;
  std::string PhotometryFile;
  std::shared_ptr<const Photometry> Goniometry; // null: the same intensity in all directions
  std::shared_ptr<const std::vector<glm::dvec4>> Table; // the packed goniometry
  glm::dvec3 PhotometryUp{ 0.0, 1.0, 0.0 };
  LampExtent Extent;
  bool Visible = false;
};

// Those of a light; the defaults if nothing was set, and for null.
VTKAIRLIGHT_EXPORT const LightProperties& GetProperties(vtkLight* light);

// Each changes a light that is not null, and returns an error, or nothing.
VTKAIRLIGHT_EXPORT void SetScatters(vtkLight* light, bool scatters);
VTKAIRLIGHT_EXPORT std::string SetPhotometry(vtkLight* light, const char* file);
VTKAIRLIGHT_EXPORT std::string SetPhotometryUp(vtkLight* light, const glm::dvec3& up);
VTKAIRLIGHT_EXPORT void SetVisible(vtkLight* light, bool visible);
VTKAIRLIGHT_EXPORT std::string SetExtent(vtkLight* light, const LampExtent& extent);

// Headlights and camera lights are there to show surfaces. Scattered, they would veil every picture
// evenly.
inline bool IsFixedToCamera(vtkLight* light) { return !light->LightTypeIsSceneLight(); }

// The warning about so many lights that are fixed to the camera and not set. `dark`: the medium
// scatters no other light.
VTKAIRLIGHT_EXPORT std::string GetCameraLightsText(int count, bool dark);
}

#endif
