// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a shadow map's faces are, and how shaders find a point in them.

#include "ShadowMaps/AirlightShadowMap.h"

#include "Scene/AirlightCameraUniforms.h"
#include "vtkActor.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// Up to 60 degrees one face before a spot is finer than six around it.
constexpr double NarrowCone = 0.5;
// The square root of 6: a face on its own has as many texels as six together.
constexpr double SingleFace = 2.449;
// Directions that are tried for a directional light's map.
constexpr int Turns = 18;
// Texels left free at the borders: beyond the map everything is lit.
constexpr double Margin = 2.0;
// Single precision of positions, relative to their size.
constexpr double Rounding = 1e-6;
// A rough bound of what interpolation and the map's own numbers lose, relative to distances.
constexpr double MapRounding = 1e-5;

// The corners of the casters' boxes.
std::vector<glm::dvec3> GetCorners(const std::vector<Caster>& casters)
{
  std::vector<glm::dvec3> corners;
  for (const Caster& caster : casters)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const CasterMesh& mesh = *caster.Mesh;
      const glm::dvec3 local(corner & 1 ? mesh.BoundsMin.x : mesh.BoundsMax.x,
        corner & 2 ? mesh.BoundsMin.y : mesh.BoundsMax.y,
        corner & 4 ? mesh.BoundsMin.z : mesh.BoundsMax.z);
      corners.emplace_back(caster.ToWorld * glm::dvec4(local, 1.0));
    }
  }
  return corners;
}

// Two directions across an axis of unit length, and the axis.
glm::dmat3 MakeFrame(const glm::dvec3& axis)
{
  const glm::dvec3 a = glm::abs(axis);
  const glm::dvec3 least(a.x <= a.y && a.x <= a.z, a.y < a.x && a.y <= a.z, a.z < a.x && a.z < a.y);
  const glm::dvec3 across = glm::normalize(glm::cross(axis, least));
  return { across, glm::cross(axis, across), axis };
}
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> ShadowMap::GetBoxCorners() const
{
  std::vector<glm::dvec3> corners = GetCorners(this->Casters);
  for (const NonPolygonalCaster& other : this->NonPolygonal)
  {
    const std::vector<glm::dvec3> box = other.GetCorners();
    corners.insert(corners.end(), box.begin(), box.end());
  }
  return corners;
}

//------------------------------------------------------------------------------
void ShadowMap::SetProjection()
{
  if (this->Casters.empty() && this->NonPolygonal.empty())
  {
    this->Kind = Projection::None;
    return;
  }
  if (this->Light.w == 0.0)
  {
    this->SetParallelProjection();
    return;
  }
  this->Anchor = glm::dvec3(this->Light);
  this->Side = this->Resolution;
  this->Scale = glm::dvec2(1.0);
  this->Frame = glm::dmat3(1.0);
  this->Kind = Projection::Cube;
  if (this->CosCone >= NarrowCone)
  {
    this->Kind = Projection::Cone;
    this->Side = static_cast<int>(SingleFace * this->Resolution);
    this->Frame = MakeFrame(glm::normalize(this->Axis));
    const double tangent = std::sqrt(1.0 - this->CosCone * this->CosCone) / this->CosCone;
    this->Scale = glm::dvec2((1.0 - 2.0 * Margin / this->Side) / tangent);
  }
  this->Farthest = 0.0;
  for (const glm::dvec3& corner : this->GetBoxCorners())
  {
    this->Farthest = std::max(this->Farthest, glm::length(corner - this->Anchor));
  }
  this->Extent = this->Farthest;
}

//------------------------------------------------------------------------------
// Turned so that the casters' boxes fill the map well.
glm::dmat3 ShadowMap::FindParallelFrame() const
{
  const glm::dmat3 frame = MakeFrame(-glm::normalize(glm::dvec3(this->Light)));
  const std::vector<glm::dvec3> corners = this->GetBoxCorners();
  glm::dmat3 best = frame;
  double least = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < Turns; ++turn)
  {
    const double angle = glm::radians(90.0) * turn / Turns;
    glm::dmat3 turned = frame;
    turned[0] = std::cos(angle) * frame[0] + std::sin(angle) * frame[1];
    turned[1] = std::cos(angle) * frame[1] - std::sin(angle) * frame[0];
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high = -low;
    for (const glm::dvec3& corner : corners)
    {
      const glm::dvec2 point(glm::transpose(turned) * corner);
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
    // Rounding shall not turn the map of a scene that has no better direction.
    const double area = (high.x - low.x) * (high.y - low.y);
    if (area < (1.0 - 1e-9) * least)
    {
      least = area;
      best = turned;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
// Around all casters.
void ShadowMap::SetParallelProjection()
{
  this->Kind = Projection::Parallel;
  this->Side = static_cast<int>(SingleFace * this->Resolution);
  this->Frame = this->FindParallelFrame();
  const glm::dmat3 toFrame = glm::transpose(this->Frame);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Caster& caster : this->Casters)
  {
    for (int i = 0; i < static_cast<int>(caster.Mesh->Points.size()); ++i)
    {
      const glm::dvec3 point = toFrame * caster.GetPoint(i);
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  std::vector<glm::dvec3> corners;
  for (const NonPolygonalCaster& other : this->NonPolygonal)
  {
    const std::vector<glm::dvec3> box = other.GetCorners();
    corners.insert(corners.end(), box.begin(), box.end());
  }
  for (const glm::dvec3& corner : corners)
  {
    low = glm::min(low, toFrame * corner);
    high = glm::max(high, toFrame * corner);
  }
  this->Anchor = this->Frame * (0.5 * (low + high));
  const glm::dvec3 half = 0.5 * (high - low);
  this->Extent = 2.0 * glm::length(half);
  // Casters that the light sees edge-on have no width.
  const glm::dvec2 across = glm::max(glm::dvec2(half), 1e-6 * this->Extent);
  this->Scale = (1.0 - 2.0 * Margin / this->Side) / across;
  this->Nearest = -half.z;
  this->Farthest = half.z;
}

//------------------------------------------------------------------------------
void ShadowMap::SetUniforms(vtkShaderProgram* program, const CameraUniforms& view) const
{
  const glm::vec3 origin(this->Anchor - view.GetEye());
  const glm::mat3 frame(this->Frame);
  const glm::vec2 scale(this->Scale);
  const bool parallel = this->Kind == Projection::Parallel;
  const double slack =
    Rounding * glm::length(origin) + (parallel ? MapRounding * this->Extent : 0.0);
  program->SetUniformi("mapKind", static_cast<int>(this->Kind));
  program->SetUniformi("mapResolution", this->Side);
  program->SetUniform3f("mapOrigin", &origin.x);
  program->SetUniform3fv("mapFrame", 3, &frame[0].x);
  program->SetUniform2f("mapScale", &scale.x);
  program->SetUniformf("mapNearest", static_cast<float>(this->Nearest - slack));
  program->SetUniformf("mapSlack", static_cast<float>(slack));
  program->SetUniformf("mapRelativeSlack", parallel ? 0.0f : static_cast<float>(MapRounding));
}
}
