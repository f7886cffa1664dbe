// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightView.h"

#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
View::View(vtkRenderer* renderer, int width, int height)
  : PixelRays(renderer->GetActiveCamera(), renderer->GetTiledAspectRatio(), width, height)
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
glm::dvec4 View::GetStart() const
{
  return this->Parallel ? glm::dvec4(-this->Along, 0.0) : glm::dvec4(this->Eye, 1.0);
}

//------------------------------------------------------------------------------
glm::mat4 View::GetClipMatrix(const glm::dvec3& origin) const
{
  glm::dmat4 shift(1.0);
  shift[3] = glm::dvec4(origin, 1.0);
  return glm::mat4(this->WorldToClip * shift);
}

//------------------------------------------------------------------------------
glm::vec4 View::GetPixelsFrom(const View& other) const
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
void View::SetUniforms(vtkShaderProgram* program, int x, int y, const glm::vec4& pixels) const
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
void View::SetFootUniforms(
  vtkShaderProgram* program, const glm::dvec3& position, const std::string& prefix) const
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
  // A light far outside the view passes no ray closely.
  const bool isNear = std::abs(pixel.x) < 1e5 && std::abs(pixel.y) < 1e5;
  const glm::vec2 whole(glm::floor(pixel));
  const glm::vec2 rest(pixel - glm::floor(pixel));
  const glm::vec3 crossX(glm::cross(along, this->Affine[1]));
  const glm::vec3 crossY(glm::cross(along, this->Affine[2]));
  program->SetUniformi((prefix + "HasPixel").c_str(), isNear ? 1 : 0);
  if (isNear)
  {
    program->SetUniform2f((prefix + "Pixel").c_str(), &whole.x);
    program->SetUniform2f((prefix + "PixelRest").c_str(), &rest.x);
    program->SetUniform3f((prefix + "PerX").c_str(), &crossX.x);
    program->SetUniform3f((prefix + "PerY").c_str(), &crossY.x);
  }
}
}
