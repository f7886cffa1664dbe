// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a renderer as the shaders take them.
 */

#ifndef AirlightSceneLights_h
#define AirlightSceneLights_h

#include "Medium/AirlightConvert.h"
#include "vtkWeakPointer.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;

namespace airlight
{
class CameraUniforms;

struct SceneLight
{
  vtkLight* Light;
  LightSupport Support;
  f64::AirlightLight Values; // relative to the eye
  glm::dvec4 World{ 0.0 };   // homogeneous position
  bool CastsShadows = false;
  bool LeftOut = false; // of the medium, as it is fixed to the camera and its user did not set it
  // Of a light that shines by a photometric file, else null.
  std::shared_ptr<const std::vector<glm::dvec4>> Table;
  double GridError = 0.0; // of the optical depth on the way to it, where an image is the density

  bool Scatters() const { return this->Support == LightSupport::Scatters; }
  bool HasPower() const { return this->Scatters() && this->Values.intensity != glm::dvec3(0.0); }
};

// The kind of all lights that are scattered, -1 where there are several.
int CommonKind(const std::vector<SceneLight>& sceneLights);

// The switched-on lights, in the order in which VTK's mappers number them. `radius` is the light
// requested radius, 0 for the smallest that single precision resolves. `photometric`: lights with
// photometric files emit by them.
std::vector<SceneLight> CollectSceneLights(vtkRenderer* renderer, const f64::AirlightMedia& media,
  const CameraUniforms& view, double radius, bool photometric);

// Relative to all light that is scattered, of that which was scattered more than once.
constexpr double MultipleQuadratureError = 0.01;

// Adds the lamps whose multiple scattering is computed; returns how many lights are left out of it.
int AddMultipleLamps(const std::vector<SceneLight>& sceneLights, f64::AirlightMedia& media);

// `up` made perpendicular to the axis; another direction across it where up lies along it.
glm::dvec3 MakeAcross(glm::dvec3 up, const glm::dvec3& axis);

// GetCameraLightsText() of these lights.
inline bool IsLeftOut(const SceneLight& sceneLight) { return sceneLight.LeftOut; }
std::string DescribeLeftOut(const std::vector<SceneLight>& sceneLights);
}

#endif
