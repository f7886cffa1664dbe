// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the eye stands to a light's shadow planes: on some, and within shadows.

#include "ShadowVolumes/AirlightShadowVolumes.h"

#include "Scene/AirlightCameraUniforms.h"
#include "ShadowVolumes/AirlightSilhouetteExchange.h"
#include "Silhouette/AirlightSilhouette.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Relative to the distances involved: where single precision begins to lose on which side of a
// plane the eye is.
constexpr double PlaneTolerance = 2e-5;
// An eye on a plane is on neither side of it. Where it counts, the eye is this much beside itself,
// in a direction without symmetry.
constexpr double AsideLength = 1e-11;
const glm::dvec3 AsideDirection{ 0.61, 0.47, 0.64 };

// Where a point of the edge's plane is: from the sides that begin at A and at B, and beyond the
// edge, each times the length of what it is measured from. The light is the anchor, or at infinity.
glm::dvec3 GetSides(const ShadowEdge& edge, const glm::dvec4& light, const glm::dvec3& point,
  const glm::dvec3& normal)
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const bool isPoint = light.w != 0.0;
  const glm::dvec3 away = -glm::dvec3(light);
  const glm::dvec3 fromA = glm::cross(isPoint ? a : away, isPoint ? point : point - a);
  const glm::dvec3 fromB = glm::cross(isPoint ? point : point - b, isPoint ? b : away);
  const glm::dvec3 beyond = glm::cross(point - a, b - a);
  return { glm::dot(fromA, normal), glm::dot(fromB, normal), glm::dot(beyond, normal) };
}
}

//------------------------------------------------------------------------------
// Whether a point, relative to the anchor, lies on the plane beyond its edge, within tolerance.
bool ShadowVolumes::IsOnPlane(const ShadowEdge& edge, const glm::dvec3& eye) const
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const glm::dvec3 n(edge.Normal);
  const bool isPoint = this->Light.w != 0.0;
  const glm::dvec3 toEye = isPoint ? eye : eye - a;
  const double tolerance = PlaneTolerance * (glm::length(eye) + glm::length(a));
  if (std::abs(glm::dot(n, toEye)) > tolerance)
  {
    return false;
  }
  // Between the two sides of the plane, and farther from the light than the edge.
  const glm::dvec3 away = -glm::dvec3(this->Light);
  const glm::dvec3 sideA = isPoint ? a : away;
  const glm::dvec3 sideB = isPoint ? b : away;
  const glm::dvec3 along = b - a;
  const double reach = tolerance * (glm::length(sideA) + glm::length(sideB));
  const glm::dvec3 sides = GetSides(edge, this->Light, eye, n);
  return sides.x >= -reach && sides.y >= -reach && sides.z >= -tolerance * glm::length(along);
}

//------------------------------------------------------------------------------
// With all that single precision could not find out of an eye so near: on which side of the plane
// it is, and in it of the edge's ends, where the light, a vertex and the eye lie on a line.
NearEdge ShadowVolumes::MakeNear(const ShadowEdge& edge, const glm::dvec3& eye) const
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const bool isPoint = this->Light.w != 0.0;
  const glm::dvec3 away = -glm::dvec3(this->Light);
  const glm::dvec3 normal = glm::normalize(glm::cross(isPoint ? a : away, b - a));
  NearEdge near;
  near.Edge = edge;
  near.Edge.Normal = glm::vec4(glm::vec3(normal), edge.Normal.w);
  near.Edge.B.w = static_cast<float>(glm::dot(normal, a - eye));
  near.Sides = glm::vec4(glm::vec3(GetSides(edge, this->Light, eye, normal)), 0.0f);
  return near;
}

//------------------------------------------------------------------------------
// Moves the edges whose planes the eye lies on to a list of their own. True where there are any.
bool ShadowVolumes::SplitNearEdges(const CameraUniforms& view)
{
  // In parallel projection rays do not meet in an eye.
  if (view.IsParallel())
  {
    return false;
  }
  const glm::dvec3 eye = view.GetEye() - this->Anchor;
  const auto split = std::stable_partition(this->Edges.begin(), this->Edges.end(),
    [&](const ShadowEdge& edge) { return !this->IsOnPlane(edge, eye); });
  const glm::dvec3 aside = eye + AsideLength * glm::length(eye) * AsideDirection;
  this->NearEdges.clear();
  for (auto edge = split; edge != this->Edges.end(); ++edge)
  {
    this->NearEdges.push_back(this->MakeNear(*edge, aside));
  }
  this->Edges.erase(split, this->Edges.end());
  return !this->NearEdges.empty();
}

//------------------------------------------------------------------------------
void ShadowVolumes::CountAtStart(const CameraUniforms& view)
{
  const double distance = glm::length(view.GetEye() - this->Anchor);
  const glm::dvec4 start = view.IsParallel()
    ? view.GetStart()
    : view.GetStart() + glm::dvec4(AsideLength * distance * AsideDirection, 0.0);
  this->StartCount = 0;
  this->StartLayers = CasterOpticalThickness{};
  for (const Part& part : this->Parts)
  {
    const glm::dmat4 toLocal = glm::inverse(part.Source.ToWorld);
    const int count = CountShadowsAt(*part.Source.Mesh, toLocal * this->Light, toLocal * start);
    this->StartCount += count;
    this->StartLayers.Blocks += count * part.Source.OpticalThickness.Blocks;
    this->StartLayers.Thickness += count * part.Source.OpticalThickness.Thickness;
  }
  for (const auto& remote : this->Remote)
  {
    this->StartCount += remote->StartCount;
    this->StartLayers.Blocks += remote->StartCount;
  }
}
}
