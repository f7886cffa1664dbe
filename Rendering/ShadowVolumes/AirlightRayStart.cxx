// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightRayStart.h"

#include "Scene/AirlightCameraUniforms.h"

#include <cmath>

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
bool TurnLightAside(glm::dvec4& light, const CameraUniforms& view)
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
RayStart::RayStart(const CameraUniforms& view, const glm::dvec4& light, const glm::dvec3& anchor)
  : Light(light)
  , World(view.GetStart())
  , FromAnchor(this->World - this->World.w * glm::dvec4(anchor, 0.0))
  , Aside(AsideLength * glm::length(glm::dvec3(this->FromAnchor)) * glm::dvec4(AsideDirection, 0.0))
{
}

//------------------------------------------------------------------------------
bool RayStart::IsOnPlane(const ShadowEdge& edge) const
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  const glm::dvec3 n(edge.Normal);
  const glm::dvec4& start = this->FromAnchor;
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
NearEdge RayStart::MakeNear(const ShadowEdge& edge) const
{
  const glm::dvec4 start = this->FromAnchor + this->Aside;
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
}
