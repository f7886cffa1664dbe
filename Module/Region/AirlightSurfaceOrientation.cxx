// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Region/AirlightSurfaceOrientation.h"

#include "Integration/AirlightMath.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace airlight
{
namespace
{
// The triangles on an edge, each with whether it passes the edge from the lower to the higher
// point.
struct EdgeUse
{
  // They are used, through a structured binding.
  int Triangle; // cppcheck-suppress unusedStructMember
  bool Upwards; // cppcheck-suppress unusedStructMember
};
using EdgeMap = std::map<std::pair<int, int>, std::vector<EdgeUse>>;

EdgeMap MapEdges(const std::vector<Triangle>& triangles)
{
  EdgeMap edges;
  for (size_t i = 0; i < triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangles[i][k];
      const int b = triangles[i][(k + 1) % 3];
      edges[{ std::min(a, b), std::max(a, b) }].push_back({ static_cast<int>(i), a < b });
    }
  }
  return edges;
}
}

//------------------------------------------------------------------------------
SurfaceOrientation::SurfaceOrientation(
  const std::vector<glm::dvec3>& points, const glm::dvec3& centre, std::vector<Triangle>& triangles)
  : Points(points)
  , Centre(centre)
  , Triangles(triangles)
{
}

//------------------------------------------------------------------------------
bool SurfaceOrientation::OrientAlike(std::string& error)
{
  const EdgeMap edges = MapEdges(this->Triangles);
  size_t open = 0;
  glm::dvec3 where(0.0);
  std::vector<std::vector<std::pair<int, bool>>> neighbours(this->Triangles.size());
  for (const auto& [edge, uses] : edges)
  {
    if (uses.size() % 2 != 0)
    {
      ++open;
      where = 0.5 * (this->Points[edge.first] + this->Points[edge.second]) + this->Centre;
    }
    else if (uses.size() == 2)
    {
      const bool agree = uses[0].Upwards != uses[1].Upwards;
      neighbours[uses[0].Triangle].push_back({ uses[1].Triangle, agree });
      neighbours[uses[1].Triangle].push_back({ uses[0].Triangle, agree });
    }
  }
  if (open > 0)
  {
    std::ostringstream text;
    text << "is not closed: " << open << " edges have an odd number of polygons, one of them at ("
         << where.x << ", " << where.y << ", " << where.z
         << "); close it with vtkFillHolesFilter, or merge points that should be one with "
            "vtkCleanPolyData";
    error = text.str();
    return false;
  }
  std::vector<int> flipped(this->Triangles.size(), -1); // -1: not seen, 0: as it is, 1: over
  this->Patches.assign(this->Triangles.size(), 0);
  for (size_t seed = 0; seed < this->Triangles.size(); ++seed)
  {
    if (flipped[seed] >= 0)
    {
      continue;
    }
    std::vector<int> waiting = { static_cast<int>(seed) };
    flipped[seed] = 0;
    while (!waiting.empty())
    {
      const int i = waiting.back();
      waiting.pop_back();
      this->Patches[i] = this->PatchCount;
      for (const auto& [other, agree] : neighbours[i])
      {
        const int wanted = agree ? flipped[i] : 1 - flipped[i];
        if (flipped[other] < 0)
        {
          flipped[other] = wanted;
          waiting.push_back(other);
        }
        else if (flipped[other] != wanted)
        {
          error = "has only one side, as a Klein bottle: nothing is inside of it";
          return false;
        }
      }
    }
    ++this->PatchCount;
  }
  for (size_t i = 0; i < this->Triangles.size(); ++i)
  {
    if (flipped[i] == 1)
    {
      std::swap(this->Triangles[i][1], this->Triangles[i][2]);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
glm::dvec3 SurfaceOrientation::GetAreaVector(int triangle) const
{
  const Triangle& t = this->Triangles[triangle];
  const glm::dvec3& a = this->Points[t[0]];
  return glm::cross(this->Points[t[1]] - a, this->Points[t[2]] - a);
}

//------------------------------------------------------------------------------
// Whether the place just above a triangle (side 1: where its corners run counter-clockwise) or
// below it (-1) is inside. The crossings on the way from there to infinity, each 1 or -1, have an
// odd sum where their number is odd, however their triangles are oriented.
bool SurfaceOrientation::IsInsideFrom(const SurfaceTree& tree, int triangle, double side) const
{
  const Triangle& t = this->Triangles[triangle];
  f64::AirlightMedium medium{};
  medium.region.kind = AIRLIGHT_REGION_SURFACE;
  medium.region.boxMin = tree.GetLeast() - this->Centre;
  medium.region.boxMax = tree.GetGreatest() - this->Centre;
  medium.region.data = tree.GetTexels().data();
  medium.region.nodes = tree.GetNodeCount();
  const glm::dvec3 middle = (this->Points[t[0]] + this->Points[t[1]] + this->Points[t[2]]) / 3.0;
  const glm::dvec3 way = side * glm::normalize(this->GetAreaVector(triangle));
  const double above = 1e-9 * glm::distance(tree.GetLeast(), tree.GetGreatest());
  const glm::dvec3 sums = f64::airlightSurfaceSums(medium, middle, way, 0.0, above);
  return std::lround(sums.z) % 2 != 0;
}

//------------------------------------------------------------------------------
// 1 where the patch's triangles look outwards or have no area, -1 where they look inwards, 0 where
// they bound nothing. Larger triangles are judged first; one that lies on another body's has the
// same on both sides and says nothing.
int SurfaceOrientation::JudgePatch(const SurfaceTree& tree, const std::vector<int>& patch) const
{
  std::vector<std::pair<double, int>> sizes;
  sizes.reserve(patch.size());
  for (int triangle : patch)
  {
    sizes.emplace_back(-glm::length(this->GetAreaVector(triangle)), triangle);
  }
  std::sort(sizes.begin(), sizes.end());
  for (const auto& [size, triangle] : sizes)
  {
    if (size < 0.0)
    {
      const bool above = this->IsInsideFrom(tree, triangle, 1.0);
      if (above != this->IsInsideFrom(tree, triangle, -1.0))
      {
        return above ? -1 : 1;
      }
    }
  }
  return sizes.front().first < 0.0 ? 0 : 1;
}

//------------------------------------------------------------------------------
void SurfaceOrientation::OrientOutwards(const SurfaceTree& tree)
{
  std::vector<std::vector<int>> patches(this->PatchCount);
  for (size_t i = 0; i < this->Triangles.size(); ++i)
  {
    patches[this->Patches[i]].push_back(static_cast<int>(i));
  }
  std::vector<Triangle> kept;
  for (const std::vector<int>& patch : patches)
  {
    const int looks = this->JudgePatch(tree, patch);
    for (int i : patch)
    {
      const Triangle& t = this->Triangles[i];
      if (looks != 0)
      {
        kept.push_back(looks > 0 ? t : Triangle{ t[0], t[2], t[1] });
      }
    }
  }
  this->Triangles = kept;
}
}
