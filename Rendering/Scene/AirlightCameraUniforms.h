// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The rays of a renderer's pixels as the uniforms of glsl/AirlightCameraShader.glsl. World axes,
 * the eye as origin: subtracted in double precision, so that single precision serves the shaders
 * even far from the world's origin.
 */

#ifndef AirlightCameraUniforms_h
#define AirlightCameraUniforms_h

#include "Medium/AirlightConvert.h"
#include "Scene/AirlightCameraRays.h"

#include <glm/glm.hpp>

#include <string>

class vtkRenderer;
class vtkShaderProgram;

namespace airlight
{
class CameraUniforms : public CameraRays
{
public:
  // Of the active camera, for a viewport of this size in pixels.
  CameraUniforms(vtkRenderer* renderer, int width, int height);

  // From normals in view coordinates to normals in the world, of any length.
  const glm::mat3& GetNormalMatrix() const { return this->NormalMatrix; }

  // Where every ray starts, as a homogeneous point of the world: the eye, or for parallel
  // projection the point at infinity that the rays come from.
  glm::dvec4 GetStart() const;

  // From positions relative to `origin` [world] to clip coordinates.
  glm::mat4 GetClipMatrix(const glm::dvec3& origin) const;

  // Where a light at `position` [from the eye] is in the picture: the pixel, its whole part and the
  // rest, and what its moment about a pixel's ray grows by per pixel away from it (airlightMoment).
  // It vanishes, linearly, at the light's own pixel, and is taken from there: as a cross product of
  // long vectors it would be lost in single precision near the light.
  struct LightPixel
  {
    bool IsNear = false; // in or somewhere around the view; else the rest is not set
    glm::vec2 Integer = glm::vec2(0.0f);
    glm::vec2 Fraction = glm::vec2(0.0f);
    glm::vec3 PerX = glm::vec3(0.0f);
    glm::vec3 PerY = glm::vec3(0.0f);
  };
  LightPixel GetLightPixel(const glm::dvec3& position) const;

  // Scale (x, y) and shift (z, w) from the pixels of another view from the same place to those of
  // this one with the same rays.
  glm::vec4 GetPixelsFrom(const CameraUniforms& other) const;

  // For a target in which the viewport's lower left corner is at x, y, and whose pixels are scaled
  // and shifted so.
  void SetUniforms(vtkShaderProgram* program, int x, int y,
    const glm::vec4& pixels = glm::vec4(1.0f, 1.0f, 0.0f, 0.0f)) const;

private:
  glm::mat3 NormalMatrix{ 1.0f };
  glm::vec3 RayOrigin[3];
  glm::vec3 RayDirection[3];
};

// A light's pixel, as the uniform `name` of glsl/AirlightLightPixel.glsl.
void SetLightPixelUniforms(vtkShaderProgram* program, const std::string& name,
  const CameraUniforms& rays, const f64::AirlightLight& light);
}

#endif
