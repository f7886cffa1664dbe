// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where rays start, in perspective at the eye and in parallel projection at infinity: on some of a
// light's shadow planes, and within shadows.

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
// A start of rays on a plane is on neither side of it. Where it counts, the start is this much
// beside itself, in a direction without symmetry.
constexpr double AsideLength = 1e-11;
const glm::dvec3 AsideDirection{ 0.61, 0.47, 0.64 };
// A directional light against a parallel view is turned by this many radians: shadows move by less
// than pixels show, and single precision tells to which side its planes extend.
constexpr double AsideAngle = 1e-5;

// Where a homogeneous point of the edge's plane is: from the sides that begin at A and at B, and
// beyond the edge, each times the length of what it is measured from. The light is the anchor, or
// at infinity.
glm::dvec3 GetSides(const ShadowEdge& edge, const glm::dvec4& light, const glm::dvec4& point,
  const glm::dvec3& normal)
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const glm::dvec3 p(point);
  const bool isPoint = light.w != 0.0;
  const glm::dvec3 away = -glm::dvec3(light);
  const glm::dvec3 fromA = glm::cross(isPoint ? a : away, isPoint ? p : p - point.w * a);
  const glm::dvec3 fromB = glm::cross(isPoint ? p : p - point.w * b, isPoint ? b : away);
  const glm::dvec3 beyond = glm::cross(p - point.w * a, b - a);
  return { glm::dot(fromA, normal), glm::dot(fromB, normal), glm::dot(beyond, normal) };
}
}

//------------------------------------------------------------------------------
// Against a directional light, all rays of a parallel view start on all of the light's planes.
bool ShadowVolumes::TurnLightAside(glm::dvec4& light, const CameraUniforms& view)
{
  if (!view.IsParallel() || light.w != 0.0)
  {
    return false;
  }
  const glm::dvec3 along(-view.GetStart());
  const glm::dvec3 towards = glm::normalize(glm::dvec3(light));
  if (glm::dot(towards, along) < 0.0 || glm::length(glm::cross(towards, along)) > AsideAngle)
  {
    return false;
  }
  light = glm::dvec4(along + AsideAngle * glm::normalize(glm::cross(along, AsideDirection)), 0.0);
  return true;
}

//------------------------------------------------------------------------------
// Whether the start of rays, relative to the anchor, lies on the plane beyond its edge, within
// tolerance.
bool ShadowVolumes::IsOnPlane(const ShadowEdge& edge, const glm::dvec4& start) const
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const glm::dvec3 n(edge.Normal);
  const glm::dvec3 point(start);
  const bool isPoint = this->Light.w != 0.0;
  const glm::dvec3 toStart = isPoint ? point : point - start.w * a;
  const double tolerance = PlaneTolerance * (glm::length(point) + start.w * glm::length(a));
  if (std::abs(glm::dot(n, toStart)) > tolerance)
  {
    return false;
  }
  // Between the two sides of the plane, and farther from the light than the edge.
  const glm::dvec3 away = -glm::dvec3(this->Light);
  const glm::dvec3 sideA = isPoint ? a : away;
  const glm::dvec3 sideB = isPoint ? b : away;
  const glm::dvec3 along = b - a;
  const double reach = tolerance * (glm::length(sideA) + glm::length(sideB));
  const glm::dvec3 sides = GetSides(edge, this->Light, start, n);
  return sides.x >= -reach && sides.y >= -reach && sides.z >= -tolerance * glm::length(along);
}

//------------------------------------------------------------------------------
// With all that single precision could not find out of a start so near: on which side of the plane
// it is, and in it of the edge's ends, where the light, a vertex and the start lie on a line.
NearEdge ShadowVolumes::MakeNear(const ShadowEdge& edge, const glm::dvec4& start) const
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const bool isPoint = this->Light.w != 0.0;
  const glm::dvec3 away = -glm::dvec3(this->Light);
  const glm::dvec3 normal = glm::normalize(glm::cross(isPoint ? a : away, b - a));
  NearEdge near;
  near.Edge = edge;
  near.Edge.Normal = glm::vec4(glm::vec3(normal), edge.Normal.w);
  near.Edge.B.w = static_cast<float>(glm::dot(normal, start.w * a - glm::dvec3(start)));
  near.Sides = glm::vec4(glm::vec3(GetSides(edge, this->Light, start, normal)), 0.0f);
  return near;
}

//------------------------------------------------------------------------------
// Moves the edges on whose planes rays start to a list of their own. True where there are any.
bool ShadowVolumes::SplitNearEdges(const CameraUniforms& view)
{
  // Only a light that TurnLightAside() has turned has planes on which a parallel view starts.
  if (view.IsParallel() && this->Light.w == 0.0)
  {
    return false;
  }
  glm::dvec4 start = view.GetStart();
  start -= start.w * glm::dvec4(this->Anchor, 0.0);
  const auto split = std::stable_partition(this->Edges.begin(), this->Edges.end(),
    [&](const ShadowEdge& edge) { return !this->IsOnPlane(edge, start); });
  const double distance = glm::length(glm::dvec3(start));
  start += AsideLength * distance * glm::dvec4(AsideDirection, 0.0);
  this->NearEdges.clear();
  for (auto edge = split; edge != this->Edges.end(); ++edge)
  {
    this->NearEdges.push_back(this->MakeNear(*edge, start));
  }
  this->Edges.erase(split, this->Edges.end());
  return !this->NearEdges.empty();
}

//------------------------------------------------------------------------------
void ShadowVolumes::CountAtStart(const CameraUniforms& view)
{
  const double distance = view.IsParallel() ? 1.0 : glm::length(view.GetEye() - this->Anchor);
  const glm::dvec4 start =
    view.GetStart() + AsideLength * distance * glm::dvec4(AsideDirection, 0.0);
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
