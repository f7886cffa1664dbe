// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AirlightShadowMapProjection.h"

#include "Scene/AirlightCameraUniforms.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// Six faces, three in a row.
constexpr int FacesInRow = 3;
// Of the largest distance: what is nearer to the light the camera cuts off.
constexpr double RelativeNear = 1e-4;
// What is farther away, along a face's axis: what mappers draw around points is not in their boxes.
constexpr double CameraFar = 2.0;
// In the corners of a face it may be so far away.
constexpr double CameraReach = 1.7321 * CameraFar;
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

void AddCorners(const std::vector<NonPolygonalCaster>& casters, std::vector<glm::dvec3>& corners)
{
  for (const NonPolygonalCaster& caster : casters)
  {
    const std::vector<glm::dvec3> box = caster.GetCorners();
    corners.insert(corners.end(), box.begin(), box.end());
  }
}

// The corners of the casters' boxes.
std::vector<glm::dvec3> GetCorners(
  const std::vector<Caster>& casters, const std::vector<NonPolygonalCaster>& nonPolygonal)
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
  AddCorners(nonPolygonal, corners);
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

// Turned so that the casters' boxes fill the map well.
glm::dmat3 FindParallelFrame(const glm::dvec3& toLight, const std::vector<glm::dvec3>& corners)
{
  const glm::dmat3 frame = MakeFrame(-glm::normalize(toLight));
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
}

//------------------------------------------------------------------------------
void ShadowMapProjection::Set(const std::vector<Caster>& casters,
  const std::vector<NonPolygonalCaster>& nonPolygonal, const SceneLight& light, int resolution)
{
  *this = ShadowMapProjection();
  if (casters.empty() && nonPolygonal.empty())
  {
    return;
  }
  if (light.World.w == 0.0)
  {
    this->Side = static_cast<int>(SingleFace * resolution);
    this->SetParallel(casters, nonPolygonal, glm::dvec3(light.World));
    return;
  }
  this->Anchor = glm::dvec3(light.World);
  this->Side = resolution;
  this->Kind = Kinds::Cube;
  const double cosine = light.Values.cosCone;
  if (cosine >= NarrowCone)
  {
    this->Kind = Kinds::Cone;
    this->Side = static_cast<int>(SingleFace * resolution);
    this->Frame = MakeFrame(glm::normalize(light.Values.axis));
    const double tangent = std::sqrt(1.0 - cosine * cosine) / cosine;
    this->Scale = glm::dvec2((1.0 - 2.0 * Margin / this->Side) / tangent);
  }
  const std::vector<glm::dvec3> corners = GetCorners(casters, nonPolygonal);
  for (const glm::dvec3& corner : corners)
  {
    this->Farthest = std::max(this->Farthest, glm::length(corner - this->Anchor));
  }
  this->Extent = this->Farthest;
  this->Reach = CameraReach * this->Farthest;
  this->SetCover(corners, cosine, nonPolygonal.empty());
}

//------------------------------------------------------------------------------
// Around a ball that holds the casters, or the spot's cone if that is narrower. What mappers draw
// around points is not in their boxes.
void ShadowMapProjection::SetCover(
  const std::vector<glm::dvec3>& corners, double cosCone, bool polygonal)
{
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const glm::dvec3& corner : corners)
  {
    low = glm::min(low, corner - this->Anchor);
    high = glm::max(high, corner - this->Anchor);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  const double radius = 0.5 * glm::length(high - low);
  const double distance = glm::length(middle);
  this->Covered = { glm::dvec3(0.0, 0.0, 1.0), glm::radians(180.0) };
  if (polygonal && distance > radius)
  {
    this->Covered = { middle / distance, std::asin(radius / distance) };
  }
  if (this->Kind == Kinds::Cone && std::acos(cosCone) < this->Covered.Angle)
  {
    this->Covered = { this->Frame[2], std::acos(cosCone) };
  }
}

//------------------------------------------------------------------------------
// Around all casters.
void ShadowMapProjection::SetParallel(const std::vector<Caster>& casters,
  const std::vector<NonPolygonalCaster>& nonPolygonal, const glm::dvec3& toLight)
{
  this->Kind = Kinds::Parallel;
  this->Frame = FindParallelFrame(toLight, GetCorners(casters, nonPolygonal));
  const glm::dmat3 toFrame = glm::transpose(this->Frame);
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const Caster& caster : casters)
  {
    for (int i = 0; i < static_cast<int>(caster.Mesh->Points.size()); ++i)
    {
      const glm::dvec3 point = toFrame * caster.GetPoint(i);
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  std::vector<glm::dvec3> corners;
  AddCorners(nonPolygonal, corners);
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
  this->Farthest = half.z;
  // What mappers draw around points is not in their boxes.
  this->Reach = nonPolygonal.empty() ? half.z : this->Extent;
}

//------------------------------------------------------------------------------
int ShadowMapProjection::GetFacesInRow() const
{
  return this->Kind == Kinds::Cube ? FacesInRow : 1;
}

//------------------------------------------------------------------------------
int ShadowMapProjection::GetWidth() const { return this->GetFacesInRow() * this->Side; }

//------------------------------------------------------------------------------
int ShadowMapProjection::GetHeight() const
{
  return this->GetFaceCount() / this->GetFacesInRow() * this->Side;
}

//------------------------------------------------------------------------------
glm::ivec2 ShadowMapProjection::GetTile(int face) const
{
  return { face % FacesInRow * this->Side, face / FacesInRow * this->Side };
}

//------------------------------------------------------------------------------
// Of six, face 2 k looks along axis k, face 2 k + 1 against it.
glm::dmat3 ShadowMapProjection::GetFrame(int face) const
{
  if (this->Kind != Kinds::Cube)
  {
    return this->Frame;
  }
  const int k = face / 2;
  glm::dmat3 frame(0.0);
  frame[0][(k + 1) % 3] = 1.0;
  frame[1][(k + 2) % 3] = 1.0;
  frame[2][k] = face % 2 == 0 ? 1.0 : -1.0;
  return frame;
}

//------------------------------------------------------------------------------
double ShadowMapProjection::GetCameraOffset() const
{
  return this->IsParallel() ? 2.0 * this->Extent : 0.0;
}

//------------------------------------------------------------------------------
void ShadowMapProjection::SetCamera(vtkCamera* camera, int face) const
{
  const bool parallel = this->IsParallel();
  const glm::dmat3 frame = this->GetFrame(face);
  const double offset = this->GetCameraOffset();
  const glm::dvec3 position = this->Anchor - offset * frame[2];
  const glm::dvec3 focus = position + std::max(this->Extent, 1e-30) * frame[2];
  const double nearest = parallel ? offset - this->Extent : RelativeNear * this->Farthest;
  const double farthest = parallel ? offset + this->Extent : CameraFar * this->Farthest;
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(frame[1].x, frame[1].y, frame[1].z);
  camera->SetParallelProjection(parallel);
  camera->SetClippingRange(nearest, farthest);
  // A camera's right hand is where the face's first direction is, or opposite.
  const double hand = glm::dot(glm::cross(frame[2], frame[1]), frame[0]);
  vtkNew<vtkMatrix4x4> projection;
  projection->Zero();
  projection->SetElement(0, 0, hand * this->Scale.x);
  projection->SetElement(1, 1, this->Scale.y);
  projection->SetElement(2, 2, (parallel ? -2.0 : -farthest - nearest) / (farthest - nearest));
  projection->SetElement(
    2, 3, (parallel ? -farthest - nearest : -2.0 * farthest * nearest) / (farthest - nearest));
  projection->SetElement(3, parallel ? 3 : 2, parallel ? 1.0 : -1.0);
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->UseExplicitProjectionTransformMatrixOn();
}

//------------------------------------------------------------------------------
double ShadowMapProjection::GetSlack(const CameraUniforms& view) const
{
  return Rounding * glm::length(this->Anchor - view.GetEye()) +
    (this->IsParallel() ? MapRounding * this->Extent : 0.0);
}

//------------------------------------------------------------------------------
void ShadowMapProjection::SetUniforms(vtkShaderProgram* program, const CameraUniforms& view) const
{
  const glm::vec3 origin(this->Anchor - view.GetEye());
  const glm::mat3 frame(this->Frame);
  const glm::vec2 scale(this->Scale);
  program->SetUniformi("mapKind", static_cast<int>(this->Kind));
  program->SetUniformi("mapResolution", this->Side);
  program->SetUniform3f("mapOrigin", &origin.x);
  program->SetUniform3fv("mapFrame", 3, &frame[0].x);
  program->SetUniform2f("mapScale", &scale.x);
  program->SetUniformf("mapSlack", static_cast<float>(this->GetSlack(view)));
  program->SetUniformf(
    "mapRelativeSlack", this->IsParallel() ? 0.0f : static_cast<float>(MapRounding));
}
}
