// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceSurface.h"

#include "Reference/AirlightReferenceMesh.h"

namespace airlight
{
namespace
{
// The corners' weights of a point of a triangle.
glm::dvec3 GetWeights(const OccluderTriangle& t, const glm::dvec3& p)
{
  const glm::dvec3 normal = glm::cross(t.B - t.A, t.C - t.A);
  const double a = glm::dot(normal, glm::cross(t.B - p, t.C - p));
  const double b = glm::dot(normal, glm::cross(t.C - p, t.A - p));
  const double c = glm::dot(normal, glm::cross(t.A - p, t.B - p));
  return glm::dvec3(a, b, c) / (a + b + c);
}

// On the viewer's side. Given normals are turned by the winding of the corners, as mappers do it.
glm::dvec3 GetNormal(const ReferencePart& part, const OccluderTriangle& triangle,
  const glm::dvec3& weights, const glm::dvec3& direction)
{
  const glm::dvec3 flat = glm::cross(triangle.B - triangle.A, triangle.C - triangle.A);
  glm::dvec3 normal = flat;
  if (!part.Normals.empty())
  {
    const glm::dvec3* n = &part.Normals[3 * triangle.Cell];
    normal = weights.x * n[0] + weights.y * n[1] + weights.z * n[2];
  }
  const double length = glm::length(normal);
  normal = length > 0.0 ? normal / length : glm::dvec3(0.0);
  return IsSeenFromFront(triangle, direction) ? normal : -normal;
}
}

//------------------------------------------------------------------------------
ReferenceSurface::ReferenceSurface(const ReferencePart& part, const OccluderTriangle& triangle,
  const glm::dvec3& position, const glm::dvec3& direction)
  : Material(IsSeenFromFront(triangle, direction) ? part.Front : part.Back)
{
  const glm::dvec3 weights = GetWeights(triangle, position);
  if (!part.Colours.empty())
  {
    const glm::dvec4* c = &part.Colours[3 * triangle.Cell];
    const glm::dvec4 colour = weights.x * c[0] + weights.y * c[1] + weights.z * c[2];
    this->Material.Ambient = part.AmbientFactor * glm::dvec3(colour);
    this->Material.Diffuse = part.DiffuseFactor * glm::dvec3(colour);
    this->Material.Opacity *= colour.a;
  }
  if (part.Texture)
  {
    const glm::dvec2* c = &part.TextureCoordinates[3 * triangle.Cell];
    const glm::dvec4 texel =
      part.Texture->Get(weights.x * c[0] + weights.y * c[1] + weights.z * c[2]);
    this->Material.Ambient *= glm::dvec3(texel);
    this->Material.Diffuse *= glm::dvec3(texel);
    this->Material.Specular *= glm::dvec3(texel);
    this->Material.Opacity *= texel.a;
  }
  this->Normal = GetNormal(part, triangle, weights, direction);
}
}
