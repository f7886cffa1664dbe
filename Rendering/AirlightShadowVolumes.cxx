// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightShadowVolumes.h"

#include "AirlightSilhouette.h"

#include <utility>

namespace airlight
{
namespace
{
glm::dvec3 Transform(const glm::dmat4& matrix, const glm::dvec3& point)
{
  return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}
}

//------------------------------------------------------------------------------
void ShadowVolumes::SetAnchor(const std::vector<Caster>& casters)
{
  if (this->Light.w != 0.0)
  {
    this->Anchor = glm::dvec3(this->Light);
  }
  else if (!casters.empty())
  {
    this->Anchor = Transform(casters[0].ToWorld, casters[0].Mesh->BoundsMin);
  }
}

//------------------------------------------------------------------------------
std::vector<ShadowEdge> ShadowVolumes::MakeEdges(const Caster& caster) const
{
  const CasterMesh& mesh = *caster.Mesh;
  const glm::dvec4 localLight = glm::inverse(caster.ToWorld) * this->Light;
  // A mirrored caster's triangles turn the other way in the world.
  const bool mirrored = glm::determinant(caster.ToWorld) < 0.0;
  std::vector<ShadowEdge> edges;
  for (const SilhouetteEdge& edge : FindSilhouette(mesh, localLight))
  {
    // Rounded to single precision vertex by vertex, so that planes that share a vertex share its
    // position to the last bit and leave no gap.
    const glm::dvec3 a =
      Transform(caster.ToWorld, mesh.Points[mirrored ? edge.B : edge.A]) - this->Anchor;
    const glm::dvec3 b =
      Transform(caster.ToWorld, mesh.Points[mirrored ? edge.A : edge.B]) - this->Anchor;
    const glm::dvec3 away = this->Light.w != 0.0 ? a : -glm::dvec3(this->Light);
    glm::dvec3 normal = glm::cross(away, b - a);
    const double length = glm::length(normal);
    if (length > 0.0)
    {
      normal /= length;
    }
    edges.push_back({ glm::vec4(glm::vec3(a), static_cast<float>(edge.Weight)),
      glm::vec4(glm::vec3(b), 0.0f), glm::vec4(glm::vec3(normal), 0.0f) });
  }
  return edges;
}

//------------------------------------------------------------------------------
bool ShadowVolumes::Update(
  const std::vector<Caster>& casters, const glm::dvec4& light, const glm::dvec4& start)
{
  const bool lightMoved = this->Light != light;
  const bool startMoved = this->Start != start;
  this->Light = light;
  this->Start = start;
  const glm::dvec3 oldAnchor = this->Anchor;
  this->SetAnchor(casters);
  const bool anchorMoved = oldAnchor != this->Anchor;

  bool edgesChanged = casters.size() != this->Parts.size();
  this->Parts.resize(casters.size());
  this->StartCount = 0;
  for (size_t i = 0; i < casters.size(); ++i)
  {
    Part& part = this->Parts[i];
    const bool casterChanged = !(part.Source == casters[i]);
    if (casterChanged || lightMoved || anchorMoved)
    {
      part.Source = casters[i];
      part.Edges = this->MakeEdges(casters[i]);
      edgesChanged = true;
    }
    if (casterChanged || lightMoved || startMoved)
    {
      const glm::dmat4 toLocal = glm::inverse(casters[i].ToWorld);
      part.StartCount = CountShadowsAt(*casters[i].Mesh, toLocal * light, toLocal * start);
    }
    this->StartCount += part.StartCount;
  }
  if (edgesChanged)
  {
    this->Edges.clear();
    for (const Part& part : this->Parts)
    {
      this->Edges.insert(this->Edges.end(), part.Edges.begin(), part.Edges.end());
    }
  }
  return edgesChanged;
}
}
