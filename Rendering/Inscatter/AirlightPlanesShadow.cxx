// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightPlanesShadow.h"

#include "OpenGL/AirlightOpenGL.h"
#include "ShadowVolumes/AirlightBoundaryEstimate.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace airlight
{
namespace
{
// So many of all edges tell the number of boundaries.
constexpr size_t EstimatedEdges = 2000;

// The silhouettes that other processes made for the light as it is, up to rounding.
ShadowVolumes::RemoteSilhouettes FindSilhouettes(
  const std::vector<ProcessSilhouettes>& processes, size_t index, const glm::dvec4& light)
{
  ShadowVolumes::RemoteSilhouettes found;
  for (const ProcessSilhouettes& process : processes)
  {
    if (index < process.size() &&
      glm::distance(process[index]->Light, light) <= 1e-9 * glm::length(light))
    {
      found.push_back(process[index]);
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
PlanesShadow::PlanesShadow(ShadowLists& lists)
  : Lists(lists)
{
}

//------------------------------------------------------------------------------
void PlanesShadow::UpdateSilhouettes(
  const FrameScene& scene, int light, const ShadowCasters& casters)
{
  const glm::dvec4& position = scene.Lights[light].World;
  this->TruncationPlanes =
    FindTruncationPlanes(casters.Polygonal, casters.Faces, position, scene.Rays.GetEye());
  this->Volumes.SetRemoteSilhouettes(
    FindSilhouettes(casters.Remote, static_cast<size_t>(light), position));
  this->Volumes.UpdateSilhouettes(casters.Polygonal, position, scene.Rays);
}

//------------------------------------------------------------------------------
bool PlanesShadow::Update(
  const FrameScene& scene, int light, const ShadowCasters& casters, const InscatterTargets&)
{
  this->UpdateSilhouettes(scene, light, casters);
  std::vector<bool> left = this->FindLeftOut(scene, casters.Polygonal);
  this->LeftOut.clear();
  for (size_t i = 0; i < left.size(); ++i)
  {
    if (left[i])
    {
      this->LeftOut.push_back(casters.Polygonal[i]);
    }
  }
  left.resize(this->OpaqueOnly ? casters.Polygonal.size() : left.size());
  for (size_t i = 0; i < left.size(); ++i)
  {
    left[i] = left[i] || (this->OpaqueOnly && !casters.Polygonal[i].IsOpaque());
  }
  this->Volumes.LeaveOut(left);
  return !this->Volumes.Collect(scene.Rays) || this->Lists.SetVolumes(light, this->Volumes) ||
    this->Fail(this->Lists.GetError());
}

//------------------------------------------------------------------------------
// How many boundaries a pixel has of each caster's edges. Of many edges some are enough.
std::vector<double> PlanesShadow::EstimateEdges(
  const FrameScene& scene, const std::vector<Caster>& casters) const
{
  size_t edges = 0;
  for (size_t i = 0; i < casters.size(); ++i)
  {
    edges += this->Volumes.GetEdges(i).size();
  }
  const size_t stride = 1 + edges / EstimatedEdges;
  const BoundaryEstimate estimate(scene.Rays, this->Volumes.GetAnchor(), this->Volumes.GetLight());
  std::vector<double> boundaries(casters.size(), 0.0);
  size_t next = 0; // of the edges of all casters, one after the other
  size_t first = 0;
  for (size_t i = 0; i < casters.size(); ++i)
  {
    const std::vector<ShadowEdge>& own = this->Volumes.GetEdges(i);
    for (; next < first + own.size(); next += stride)
    {
      boundaries[i] += stride * estimate.Get(own[next - first], this->TruncationPlanes[i]);
    }
    first += own.size();
  }
  return boundaries;
}

//------------------------------------------------------------------------------
std::vector<bool> PlanesShadow::FindLeftOut(
  const FrameScene& scene, const std::vector<Caster>& casters)
{
  if (std::isinf(this->MaximumBoundaries))
  {
    return {};
  }
  std::vector<double> boundaries = this->EstimateEdges(scene, casters);
  for (size_t i = 0; i < casters.size(); ++i)
  {
    boundaries[i] = this->OpaqueOnly && !casters[i].IsOpaque() ? 0.0 : boundaries[i];
  }
  this->Estimate = std::accumulate(boundaries.begin(), boundaries.end(), 0.0);
  return FindCostlyCasters(casters, boundaries, this->MaximumBoundaries);
}

//------------------------------------------------------------------------------
// Rays cross the triangles of translucent casters, too.
double PlanesShadow::EstimateTranslucent(
  const FrameScene& scene, int light, const ShadowCasters& casters)
{
  this->UpdateSilhouettes(scene, light, casters);
  const std::vector<double> edges = this->EstimateEdges(scene, casters.Polygonal);
  size_t triangles = 0;
  for (size_t i = 0; i < edges.size(); ++i)
  {
    triangles += casters.Polygonal[i].IsOpaque() ? 0 : this->Volumes.GetCaps(i).size();
  }
  const size_t stride = 1 + triangles / EstimatedEdges;
  const BoundaryEstimate estimate(scene.Rays, this->Volumes.GetAnchor(), this->Volumes.GetLight());
  double sum = 0.0;
  size_t skip = 0;
  for (size_t i = 0; i < edges.size(); ++i)
  {
    if (casters.Polygonal[i].IsOpaque())
    {
      continue;
    }
    sum += edges[i];
    const std::vector<ShadowCap>& caps = this->Volumes.GetCaps(i);
    for (; skip < caps.size(); skip += stride)
    {
      sum += stride * estimate.Get(caps[skip]);
    }
    skip -= caps.size();
  }
  return sum;
}

//------------------------------------------------------------------------------
ShadowLists::Source PlanesShadow::GetSource(
  const FrameScene& scene, int light, vtkTextureObject* distances)
{
  const glm::dvec4& position = scene.Lights[light].World;
  return { light, this->Volumes, position, scene.Rays, distances, this->TruncationPlanes };
}

//------------------------------------------------------------------------------
bool PlanesShadow::ForEachDraw(const FrameScene& scene, int light, const InscatterTargets& targets,
  bool counted, const Draw& draw)
{
  const ShadowLists::Source source = this->GetSource(scene, light, targets.Distances);
  for (int row = 0; row < scene.Height;)
  {
    const std::string reason = targets.Bind({}, targets.Depth);
    if (!reason.empty())
    {
      return this->Fail(reason);
    }
    const int rows = this->Lists.Fill(source, targets.Area, row, scene.Height - row);
    if (rows == 0)
    {
      return this->Fail(this->Lists.GetError());
    }
    if (!draw({ BoundaryPixels::Short, row, rows }) || !this->DrawLong(counted, row, rows, draw))
    {
      return false;
    }
    row += rows;
  }
  return true;
}

//------------------------------------------------------------------------------
// The pixels whose lists are long: counted boundaries in one draw, others in several.
bool PlanesShadow::DrawLong(bool counted, int row, int rows, const Draw& draw)
{
  const int draws = this->Lists.GetLongDraws();
  if (draws == 0)
  {
    return true;
  }
  if (!this->Lists.Sort())
  {
    return this->Fail(this->Lists.GetError());
  }
  bool ok = draw({ BoundaryPixels::Long, row, rows });
  for (int i = 1; i < draws && ok && !counted; ++i)
  {
    ok = draw({ BoundaryPixels::LongRest, row, rows });
  }
  return ok;
}

//------------------------------------------------------------------------------
std::string PlanesShadow::GetBoundarySource(const InscatterDraw& draw, bool counted) const
{
  return this->Lists.GetBoundarySource(draw.Pixels != BoundaryPixels::Short, counted);
}

//------------------------------------------------------------------------------
void PlanesShadow::Bind(vtkShaderProgram* program, const FrameScene&, const InscatterDraw& draw)
{
  this->Lists.Use(program);
  program->SetUniformi("resume", draw.Pixels == BoundaryPixels::LongRest ? 1 : 0);
  // No test fails without it, see AirlightOpenGL.h.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
double PlanesShadow::GetThicknessError() const
{
  double error = 0.0;
  for (const CasterOpticalThickness& layer : this->Volumes.GetLayers())
  {
    error = std::max(error, airlight::GetThicknessError(layer));
  }
  return error;
}

//------------------------------------------------------------------------------
bool PlanesShadow::FillNodes(
  const FrameScene& scene, int light, const InscatterTargets& targets, const FroxelNodes& nodes)
{
  const std::string reason = targets.Bind({}, targets.Depth);
  if (!reason.empty())
  {
    return this->Fail(reason);
  }
  return this->Lists.FillNodes(
           scene.Window, this->GetSource(scene, light, targets.Distances), nodes) ||
    this->Fail(this->Lists.GetError());
}

//------------------------------------------------------------------------------
bool PlanesShadow::DrawWireframe(const FrameScene& scene, int light, vtkTextureObject* distances)
{
  return this->Lists.DrawWireframe(this->GetSource(scene, light, distances)) ||
    this->Fail(this->Lists.GetError());
}
}
