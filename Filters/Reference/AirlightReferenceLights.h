// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's lights for vtkAirlightReference: how they light media, and how VTK's mappers shade
 * surfaces by them.
 */

#ifndef AirlightReferenceLights_h
#define AirlightReferenceLights_h

#include "Medium/AirlightConvert.h"
#include "Reference/AirlightReferenceScene.h"
#include "Silhouette/AirlightSilhouette.h" // for HomogeneousPoint

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkLight;
class vtkRenderer;

namespace airlight
{
struct ReferenceLight
{
  LightSupport Support = LightSupport::Off;
  f64::AirlightLight Values;     // relative to the eye
  HomogeneousPoint World{ 0.0 }; // its position
  bool CastsShadows = false;
  std::shared_ptr<const std::vector<glm::dvec4>> Table; // of its photometric file
  bool LeftOut = false; // of the medium, as it is fixed to the camera and its user did not set it

  // As mappers take it.
  glm::dvec3 Colour{ 0.0 };
  bool Positional = false;
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Direction{ 0.0 }; // unit, from the light
  glm::dvec3 Attenuation{ 1.0, 0.0, 0.0 };
  double ConeAngle = 90.0;
  double Exponent = 0.0;
};

class ReferenceLights
{
public:
  // The switched-on lights, in the renderer's order; creates and moves lights as VTK does before it
  // draws. `radius` is the requested light radius, 0 for the smallest that double precision
  // resolves. A lamp with an extent becomes `lampPoints` lights.
  ReferenceLights(vtkRenderer* renderer, const f64::AirlightMedia& media, const glm::dvec3& eye,
    double radius, int lampPoints);

  const std::vector<ReferenceLight>& GetAll() const { return this->Lights; }

  // The same with lamps of an extent as points in their middles.
  const std::vector<ReferenceLight>& GetPoints() const { return this->Points; }
  bool HasInvalid() const;
  std::string DescribeLeftOut() const; // GetCameraLightsText(), empty if none was left out

  // What VTK's mappers show of a triangle met by a ray, and its opacity. `position` in the world,
  // `eye` there, too; `arriving` has the share of each light that arrives.
  glm::dvec4 Shade(const ReferencePart& part, const OccluderTriangle& triangle,
    const glm::dvec3& position, const glm::dvec3& direction, const glm::dvec3& eye,
    const std::vector<glm::dvec3>& arriving) const;

private:
  std::vector<ReferenceLight> Lights;
  std::vector<ReferenceLight> Points;
  bool IsHeadlight = false; // one headlight alone is shaded in a way of its own
  glm::dvec3 Forward{ 0.0 };
};
}

#endif
