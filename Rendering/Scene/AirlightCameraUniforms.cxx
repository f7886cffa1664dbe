// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightCameraUniforms.h"

#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
CameraUniforms::CameraUniforms(vtkRenderer* renderer, int width, int height)
  : CameraRays(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(), width, height)
{
  if (!this->Valid)
  {
    return;
  }
  this->NormalMatrix = glm::mat3(glm::transpose(glm::dmat3(this->WorldToView)));
  for (int i = 0; i < 3; ++i)
  {
    this->RayOrigin[i] = this->Parallel ? glm::vec3(this->Affine[i]) : glm::vec3(0.0f);
    this->RayDirection[i] = this->Parallel ? glm::vec3(0.0f) : glm::vec3(this->Affine[i]);
  }
  if (this->Parallel)
  {
    this->RayDirection[0] = glm::vec3(this->Along);
  }
}

//------------------------------------------------------------------------------
glm::dvec4 CameraUniforms::GetStart() const
{
  return this->Parallel ? glm::dvec4(-this->Along, 0.0) : glm::dvec4(this->Eye, 1.0);
}

//------------------------------------------------------------------------------
glm::mat4 CameraUniforms::GetClipMatrix(const glm::dvec3& origin) const
{
  glm::dmat4 shift(1.0);
  shift[3] = glm::dvec4(origin, 1.0);
  return glm::mat4(this->WorldToClip * shift);
}

//------------------------------------------------------------------------------
glm::vec4 CameraUniforms::GetPixelsFrom(const CameraUniforms& other) const
{
  glm::vec4 result;
  for (int i = 0; i < 2; ++i)
  {
    const glm::dvec3& step = this->Affine[i + 1];
    const double square = glm::dot(step, step);
    result[i] = static_cast<float>(glm::dot(other.Affine[i + 1], step) / square);
    result[i + 2] = static_cast<float>(glm::dot(other.Affine[0] - this->Affine[0], step) / square);
  }
  return result;
}

//------------------------------------------------------------------------------
void CameraUniforms::SetUniforms(
  vtkShaderProgram* program, int x, int y, const glm::vec4& pixels) const
{
  const int corner[2] = { x, y };
  // Of the depth buffer: linear in the distance, in a perspective in its reciprocal.
  const double start = this->Parallel ? this->PerDepth * this->Near : 1.0 / this->Near;
  const double end = this->Parallel ? this->PerDepth * this->Far : 1.0 / this->Far;
  const float depth[2] = { static_cast<float>(start), static_cast<float>(end - start) };
  program->SetUniform2i("airlightViewport", corner);
  program->SetUniform4f("airlightTargetPixels", &pixels.x);
  program->SetUniform3fv("airlightRayOrigin", 3, &this->RayOrigin[0].x);
  program->SetUniform3fv("airlightRayDirection", 3, &this->RayDirection[0].x);
  program->SetUniform2f("airlightDepthToDistance", depth);
  program->SetUniformi("airlightParallel", this->Parallel ? 1 : 0);
}

//------------------------------------------------------------------------------
CameraUniforms::LightPixel CameraUniforms::GetLightPixel(const glm::dvec3& position) const
{
  // In a perspective the light is a multiple of one pixel's direction; in parallel projection it is
  // one pixel's origin plus a multiple of the common direction.
  const glm::dvec3 along = this->Parallel ? this->Along : position;
  const glm::dmat3 basis(
    this->Affine[1], this->Affine[2], this->Parallel ? this->Along : this->Affine[0]);
  const glm::dvec3 solution =
    glm::inverse(basis) * (this->Parallel ? position - this->Affine[0] : position);
  const glm::dvec2 pixel =
    this->Parallel ? glm::dvec2(solution) : glm::dvec2(solution) / solution.z;
  LightPixel result;
  // A light far outside the view passes no ray closely.
  result.IsNear = std::abs(pixel.x) < 1e5 && std::abs(pixel.y) < 1e5;
  if (result.IsNear)
  {
    result.Integer = glm::vec2(glm::floor(pixel));
    result.Fraction = glm::vec2(pixel - glm::floor(pixel));
    result.PerX = glm::vec3(glm::cross(along, this->Affine[1]));
    result.PerY = glm::vec3(glm::cross(along, this->Affine[2]));
  }
  return result;
}

//------------------------------------------------------------------------------
void SetLightPixelUniforms(vtkShaderProgram* program, const std::string& name,
  const CameraUniforms& rays, const f64::AirlightLight& light)
{
  if (f64::airlightIsDirectional(light))
  {
    program->SetUniformi((name + ".isNear").c_str(), 0);
    return;
  }
  const CameraUniforms::LightPixel pixel = rays.GetLightPixel(light.position);
  program->SetUniformi((name + ".isNear").c_str(), pixel.IsNear ? 1 : 0);
  program->SetUniform2f((name + ".whole").c_str(), &pixel.Integer.x);
  program->SetUniform2f((name + ".rest").c_str(), &pixel.Fraction.x);
  program->SetUniform3f((name + ".perX").c_str(), &pixel.PerX.x);
  program->SetUniform3f((name + ".perY").c_str(), &pixel.PerY.x);
}
}
