// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightShadowVolumes.h"

#include "Casters/AirlightCasterBox.h"
#include "Scene/AirlightCameraUniforms.h"
#include "ShadowVolumes/AirlightClippedRegions.h"
#include "ShadowVolumes/AirlightMergedEdges.h"
#include "ShadowVolumes/AirlightRayStart.h"
#include "ShadowVolumes/AirlightSilhouetteExchange.h"
#include "Silhouette/AirlightSilhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace airlight
{
namespace
{
// The size of the coordinates, in the world's unit, that VTK's mappers round to single precision.
// Of points farther from their origin than ten thousand times their extent they subtract the middle
// beforehand.
float GetCoordinateSize(const Caster& caster)
{
  const CasterMesh& mesh = *caster.Mesh;
  const glm::dmat3 linear(caster.ToWorld);
  const double extent = glm::length(linear * (mesh.BoundsMax - mesh.BoundsMin));
  const double farthest =
    std::max(glm::length(linear * mesh.BoundsMin), glm::length(linear * mesh.BoundsMax));
  return static_cast<float>(farthest <= 1e4 * extent ? farthest : extent);
}

bool IsMirrored(const Caster& caster) { return glm::determinant(caster.ToWorld) < 0.0; }
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
    this->Anchor = FindAnchor(casters);
  }
  else if (!this->Remote.empty())
  {
    this->Anchor = this->Remote[0]->Anchor;
  }
}

//------------------------------------------------------------------------------
void ShadowVolumes::SetRemoteSilhouettes(const RemoteSilhouettes& remotes)
{
  this->RemoteChanged = this->RemoteChanged || remotes != this->Remote;
  this->Remote = remotes;
}

//------------------------------------------------------------------------------
// Rounded to single precision vertex by vertex, planes that share a vertex share its position to
// the last bit and leave no gap.
glm::dvec3 ShadowVolumes::GetRelativePoint(const Caster& caster, int point) const
{
  return caster.GetPoint(point) - this->Anchor;
}

//------------------------------------------------------------------------------
void ShadowVolumes::MakeEdges(Part& part) const
{
  const Caster& caster = part.Source;
  // A mirrored caster's triangles turn the other way in the world.
  const bool mirrored = IsMirrored(caster);
  part.Edges.clear();
  for (const SilhouetteEdge& edge :
    FindSilhouette(*caster.Mesh, glm::inverse(caster.ToWorld) * this->Light))
  {
    const glm::dvec3 a = this->GetRelativePoint(caster, mirrored ? edge.B : edge.A);
    const glm::dvec3 b = this->GetRelativePoint(caster, mirrored ? edge.A : edge.B);
    if (glm::vec3(a) == glm::vec3(b))
    {
      continue; // no length is left, as at the poles of a textured ball: its plane has no area
    }
    const glm::dvec3 away = this->Light.w != 0.0 ? a : -glm::dvec3(this->Light);
    glm::dvec3 normal = glm::cross(away, b - a);
    const double length = glm::length(normal);
    if (length > 0.0)
    {
      normal /= length;
    }
    AddEdge(part.Edges,
      { glm::vec4(glm::vec3(a), 0.0f), glm::vec4(glm::vec3(b), 0.0f),
        glm::vec4(glm::vec3(normal), 0.0f) },
      static_cast<float>(edge.Weight));
  }
}

//------------------------------------------------------------------------------
void ShadowVolumes::MakeCaps(Part& part) const
{
  part.Caps.clear();
  if (!part.Capped)
  {
    return;
  }
  const Caster& caster = part.Source;
  const CasterMesh& mesh = *caster.Mesh;
  const bool mirrored = IsMirrored(caster);
  const glm::dvec4 localLight = glm::inverse(caster.ToWorld) * this->Light;
  const float size = GetCoordinateSize(caster);
  for (size_t f = 0; f < mesh.Triangles.size(); ++f)
  {
    // A mirrored caster's triangles turn the other way in the world.
    const double side = glm::dot(mesh.Planes[f], localLight) * (mirrored ? -1.0 : 1.0);
    const float sign = static_cast<float>((side > 0.0) - (side < 0.0));
    const std::array<int, 3>& t = mesh.Triangles[f];
    part.Caps.push_back({ glm::vec4(glm::vec3(this->GetRelativePoint(caster, t[0])), sign),
      glm::vec4(glm::vec3(this->GetRelativePoint(caster, t[1])), size),
      glm::vec4(glm::vec3(this->GetRelativePoint(caster, t[2])), 0.0f) });
  }
}

//------------------------------------------------------------------------------
bool ShadowVolumes::UpdateParts(
  const std::vector<Caster>& casters, const ClippedRegions& view, bool moved)
{
  bool changed = casters.size() != this->Parts.size();
  this->Parts.resize(casters.size());
  for (size_t i = 0; i < casters.size(); ++i)
  {
    Part& part = this->Parts[i];
    // Rays may go through parts that are not drawn.
    const bool capped = casters[i].HidesFaces || view.MayCutOff(casters[i]);
    const bool remake = moved || !part.Source.HasSameShape(casters[i]);
    changed = changed || !(part.Source.OpticalThickness == casters[i].OpticalThickness);
    part.Source = casters[i];
    if (remake)
    {
      this->MakeEdges(part);
    }
    if (remake || capped != part.Capped)
    {
      part.Capped = capped;
      this->MakeCaps(part);
      changed = true;
    }
  }
  return changed;
}

//------------------------------------------------------------------------------
float ShadowVolumes::GetLayerIndex(const CasterOpticalThickness& layer)
{
  const auto place = std::find(this->Layers.begin(), this->Layers.end(), layer);
  const auto index = static_cast<float>(place - this->Layers.begin());
  if (place == this->Layers.end())
  {
    this->Layers.push_back(layer);
  }
  return index;
}

//------------------------------------------------------------------------------
void ShadowVolumes::CollectEdges()
{
  this->Layers.clear();
  this->Edges.clear();
  this->NearEdges.clear();
  this->Caps.clear();
  for (size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (this->IsLeftOut(i))
    {
      continue;
    }
    const Part& part = this->Parts[i];
    const size_t edges = this->Edges.size();
    const size_t caps = this->Caps.size();
    this->Edges.insert(this->Edges.end(), part.Edges.begin(), part.Edges.end());
    this->Caps.insert(this->Caps.end(), part.Caps.begin(), part.Caps.end());
    const float layer = this->GetLayerIndex(part.Source.OpticalThickness);
    std::for_each(this->Edges.begin() + edges, this->Edges.end(), [layer, i](ShadowEdge& edge) {
      edge.B.w = static_cast<float>(i);
      edge.Normal.w = layer;
    });
    std::for_each(
      this->Caps.begin() + caps, this->Caps.end(), [layer](ShadowCap& cap) { cap.C.w = layer; });
  }
  if (!this->Remote.empty())
  {
    this->CollectRemoteSilhouettes();
    this->Edges = MergeEdges(this->Edges);
  }
}

//------------------------------------------------------------------------------
// All of a process are moved by the same way: planes that share a vertex still do.
void ShadowVolumes::CollectRemoteSilhouettes()
{
  for (const auto& remote : this->Remote)
  {
    const float layer = this->GetLayerIndex(GetOpticalThickness(glm::dvec3(1.0)));
    const glm::vec4 shift(glm::vec3(remote->Anchor - this->Anchor), 0.0f);
    for (ShadowEdge edge : remote->Edges)
    {
      edge.A += shift;
      edge.B += shift;
      edge.B.w = static_cast<float>(this->Parts.size());
      edge.Normal.w = layer;
      this->Edges.push_back(edge);
    }
    for (ShadowCap cap : remote->Caps)
    {
      cap.A += shift;
      cap.B += shift;
      cap.C = glm::vec4(glm::vec3(cap.C + shift), layer);
      this->Caps.push_back(cap);
    }
  }
}

//------------------------------------------------------------------------------
// Moves the edges on whose planes rays start to a list of their own. True where there are any.
bool ShadowVolumes::SplitNearEdges(const RayStart& start)
{
  const auto split = std::stable_partition(this->Edges.begin(), this->Edges.end(),
    [&](const ShadowEdge& edge) { return !start.IsOnPlane(edge); });
  this->NearEdges.clear();
  std::transform(split, this->Edges.end(), std::back_inserter(this->NearEdges),
    [&](const ShadowEdge& edge) { return start.MakeNear(edge); });
  this->Edges.erase(split, this->Edges.end());
  return !this->NearEdges.empty();
}

//------------------------------------------------------------------------------
void ShadowVolumes::CountAtStart(const RayStart& start)
{
  this->StartCount = 0;
  this->StartLayers = CasterOpticalThickness{};
  for (size_t i = 0; i < this->Parts.size(); ++i)
  {
    if (this->IsLeftOut(i))
    {
      continue;
    }
    const Part& part = this->Parts[i];
    const glm::dmat4 toLocal = glm::inverse(part.Source.ToWorld);
    const int count =
      CountShadowsAt(*part.Source.Mesh, toLocal * this->Light, toLocal * start.GetPosition());
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

//------------------------------------------------------------------------------
bool ShadowVolumes::Update(const std::vector<Caster>& casters, const glm::dvec4& light,
  const CameraUniforms& view, bool anyPicture)
{
  this->UpdateSilhouettes(casters, light, view, anyPicture);
  this->LeaveOut({});
  return this->Collect(view);
}

//------------------------------------------------------------------------------
void ShadowVolumes::UpdateSilhouettes(const std::vector<Caster>& casters,
  const glm::dvec4& givenLight, const CameraUniforms& view, bool anyPicture)
{
  const glm::dvec3 oldAnchor = this->Anchor;
  glm::dvec4 light = givenLight;
  this->AgainstView = TurnLightAside(light, view);
  const bool lightMoved = this->Light != light;
  this->Light = light;
  this->SetAnchor(casters);
  const bool changed = this->UpdateParts(
    casters, ClippedRegions(view, anyPicture), lightMoved || oldAnchor != this->Anchor);
  this->Changed = changed || this->Changed;
}

//------------------------------------------------------------------------------
void ShadowVolumes::LeaveOut(const std::vector<bool>& casters)
{
  this->Changed = this->Changed || casters != this->LeftOut;
  this->LeftOut = casters;
}

//------------------------------------------------------------------------------
bool ShadowVolumes::Collect(const CameraUniforms& view)
{
  const bool viewMoved = this->Start != view.GetStart();
  this->Start = view.GetStart();
  // Edges that were near at the old start go back among the others.
  bool changed = this->Changed || this->RemoteChanged || (viewMoved && !this->NearEdges.empty());
  this->Changed = false;
  this->RemoteChanged = false;
  if (changed)
  {
    this->CollectEdges();
  }
  if (changed || viewMoved)
  {
    const RayStart start(view, this->Light, this->Anchor);
    // Only a light that TurnLightAside() has turned has planes on which a parallel view starts.
    const bool onPlanes = !view.IsParallel() || this->Light.w != 0.0;
    changed = (onPlanes && this->SplitNearEdges(start)) || changed;
    this->CountAtStart(start);
  }
  return changed;
}
}
