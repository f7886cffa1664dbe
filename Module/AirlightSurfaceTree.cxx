// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightSurfaceTree.h"

#include "AirlightMath.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>

namespace airlight
{
namespace
{
// A leaf's triangles are counted by two bits (glsl/AirlightClosedSurface.glsl).
constexpr int LeafSize = 4;
// Above it, numbers of triangles in texels are no longer exact in single precision.
constexpr size_t MostTriangles = 4000000;

// The triangles on an edge, each with whether it passes the edge from the lower to the higher point.
struct EdgeUse
{
  int Triangle;
  bool Upwards;
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
std::shared_ptr<const SurfaceTree> SurfaceTree::Build(vtkPolyData* mesh, std::string& error)
{
  auto tree = std::make_shared<SurfaceTree>();
  if (!tree->ReadMesh(mesh, error) || !tree->OrientAlike(error))
  {
    return nullptr;
  }
  tree->Pack();
  tree->OrientOutwards();
  if (tree->Triangles.empty())
  {
    error = "encloses nothing: all of it is flat or there twice";
    return nullptr;
  }
  tree->Pack();
  return tree;
}

//------------------------------------------------------------------------------
// Triangles over points that are apart; those without area vanish.
bool SurfaceTree::ReadMesh(vtkPolyData* mesh, std::string& error)
{
  if (!mesh || mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() == 0)
  {
    error = "has no polygons: update its source before, or set another one";
    return false;
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    if (!(std::abs(p[0]) < 1e15 && std::abs(p[1]) < 1e15 && std::abs(p[2]) < 1e15))
    {
      std::ostringstream text;
      text << "has a point " << i << " at (" << p[0] << ", " << p[1] << ", " << p[2]
           << "); all points must be finite and below 1e15: mend or remove it";
      error = text.str();
      return false;
    }
  }
  vtkNew<vtkPolyData> copy;
  copy->CopyStructure(mesh);
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(copy);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangulate->GetOutputPort());
  clean->SetTolerance(0.0);
  clean->Update();
  vtkPolyData* output = clean->GetOutput();
  double bounds[6];
  output->GetBounds(bounds);
  this->Least = { bounds[0], bounds[2], bounds[4] };
  this->Greatest = { bounds[1], bounds[3], bounds[5] };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    output->GetPoint(i, &point.x);
    this->Points.push_back(point - this->GetCentre());
  }
  const auto polygons = vtk::TakeSmartPointer(output->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCurrentCell(count, ids);
    if (count == 3 && ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
    {
      this->Triangles.push_back(
        { static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]) });
    }
  }
  this->DropPairs();
  if (this->Triangles.empty() || this->Triangles.size() > MostTriangles)
  {
    error = "has " + std::to_string(this->Triangles.size()) + " triangles; it needs 1 to " +
      std::to_string(MostTriangles);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// Two triangles on the same corners bound nothing, as where two bodies share a face.
void SurfaceTree::DropPairs()
{
  std::map<Triangle, Triangle> single;
  for (const Triangle& triangle : this->Triangles)
  {
    Triangle corners = triangle;
    std::sort(corners.begin(), corners.end());
    if (!single.emplace(corners, triangle).second)
    {
      single.erase(corners);
    }
  }
  this->Triangles.clear();
  for (const auto& [corners, triangle] : single)
  {
    this->Triangles.push_back(triangle);
  }
}

//------------------------------------------------------------------------------
// Turns the triangles over so that neighbours on an edge of two agree. Where more than two meet,
// patches of triangles end.
bool SurfaceTree::OrientAlike(std::string& error)
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
      where = 0.5 * (this->Points[edge.first] + this->Points[edge.second]) + this->GetCentre();
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
  std::vector<int> turned(this->Triangles.size(), -1); // -1: not seen, 0: as it is, 1: over
  this->Patches.assign(this->Triangles.size(), 0);
  for (size_t seed = 0; seed < this->Triangles.size(); ++seed)
  {
    if (turned[seed] >= 0)
    {
      continue;
    }
    std::vector<int> open = { static_cast<int>(seed) };
    turned[seed] = 0;
    while (!open.empty())
    {
      const int i = open.back();
      open.pop_back();
      this->Patches[i] = this->PatchCount;
      for (const auto& [other, agree] : neighbours[i])
      {
        const int wanted = agree ? turned[i] : 1 - turned[i];
        if (turned[other] < 0)
        {
          turned[other] = wanted;
          open.push_back(other);
        }
        else if (turned[other] != wanted)
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
    if (turned[i] == 1)
    {
      std::swap(this->Triangles[i][1], this->Triangles[i][2]);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
glm::dvec3 SurfaceTree::GetAreaVector(int triangle) const
{
  const Triangle& t = this->Triangles[triangle];
  const glm::dvec3& a = this->Points[t[0]];
  return glm::cross(this->Points[t[1]] - a, this->Points[t[2]] - a);
}

//------------------------------------------------------------------------------
// Whether the place just above a triangle (side 1: where its corners run counter-clockwise) or below
// it (-1) is inside. The crossings on the way from there to infinity, each 1 or -1, have an odd sum
// where their number is odd, however their triangles are oriented.
bool SurfaceTree::IsInsideFrom(int triangle, double side) const
{
  const Triangle& t = this->Triangles[triangle];
  f64::AirlightMedium medium{};
  medium.region.kind = AIRLIGHT_REGION_SURFACE;
  medium.region.boxMin = this->Least - this->GetCentre();
  medium.region.boxMax = this->Greatest - this->GetCentre();
  medium.region.data = this->Texels.data();
  medium.region.nodes = this->NodeCount;
  const glm::dvec3 middle = (this->Points[t[0]] + this->Points[t[1]] + this->Points[t[2]]) / 3.0;
  const glm::dvec3 way = side * glm::normalize(this->GetAreaVector(triangle));
  const double above = 1e-9 * glm::distance(this->Least, this->Greatest);
  const glm::dvec3 sums = f64::airlightSurfaceSums(medium, middle, way, 0.0, above);
  return std::lround(sums.z) % 2 != 0;
}

//------------------------------------------------------------------------------
// 1 where the patch's triangles look outwards or have no area, -1 where they look inwards, 0 where
// they bound nothing. Larger triangles are judged first; one that lies on another body's has the
// same on both sides and says nothing.
int SurfaceTree::JudgePatch(const std::vector<int>& patch) const
{
  std::vector<std::pair<double, int>> sizes;
  for (int triangle : patch)
  {
    sizes.emplace_back(-glm::length(this->GetAreaVector(triangle)), triangle);
  }
  std::sort(sizes.begin(), sizes.end());
  for (const auto& [size, triangle] : sizes)
  {
    if (size < 0.0)
    {
      const bool above = this->IsInsideFrom(triangle, 1.0);
      if (above != this->IsInsideFrom(triangle, -1.0))
      {
        return above ? -1 : 1;
      }
    }
  }
  return sizes.front().first < 0.0 ? 0 : 1;
}

//------------------------------------------------------------------------------
// Patch by patch; those that bound nothing vanish.
void SurfaceTree::OrientOutwards()
{
  std::vector<std::vector<int>> patches(this->PatchCount);
  for (size_t i = 0; i < this->Triangles.size(); ++i)
  {
    patches[this->Patches[i]].push_back(static_cast<int>(i));
  }
  std::vector<Triangle> kept;
  for (const std::vector<int>& patch : patches)
  {
    const int looks = this->JudgePatch(patch);
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

//------------------------------------------------------------------------------
// The nodes of order[begin, end) and below, in depth-first order.
void SurfaceTree::PackNodes(
  std::vector<int>& order, int begin, int end, const std::vector<glm::dvec3>& centres)
{
  glm::dvec3 least(std::numeric_limits<double>::max());
  glm::dvec3 greatest(-std::numeric_limits<double>::max());
  glm::dvec3 leastCentre = least;
  glm::dvec3 greatestCentre = greatest;
  for (int i = begin; i < end; ++i)
  {
    for (int point : this->Triangles[order[i]])
    {
      least = glm::min(least, this->Points[point]);
      greatest = glm::max(greatest, this->Points[point]);
    }
    leastCentre = glm::min(leastCentre, centres[order[i]]);
    greatestCentre = glm::max(greatestCentre, centres[order[i]]);
  }
  // Larger by what single precision loses, so that no ray slips between a box and its triangles.
  const double margin = 1e-6 * glm::distance(this->Least, this->Greatest);
  const size_t node = this->Texels.size();
  const bool isLeaf = end - begin <= LeafSize;
  const double leaf = isLeaf ? 4.0 * begin + (end - begin - 1) : -1.0;
  this->Texels.emplace_back(least - margin, 0.0);
  this->Texels.emplace_back(greatest + margin, leaf);
  if (!isLeaf)
  {
    const glm::dvec3 size = greatestCentre - leastCentre;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int middle = (begin + end) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
      [&](int a, int b) { return centres[a][axis] < centres[b][axis]; });
    this->PackNodes(order, begin, middle, centres);
    this->PackNodes(order, middle, end, centres);
  }
  this->Texels[node].w = static_cast<double>(this->Texels.size() / 2);
}

//------------------------------------------------------------------------------
void SurfaceTree::Pack()
{
  std::vector<glm::dvec3> centres;
  for (const Triangle& t : this->Triangles)
  {
    centres.push_back((this->Points[t[0]] + this->Points[t[1]] + this->Points[t[2]]) / 3.0);
  }
  std::vector<int> order(this->Triangles.size());
  std::iota(order.begin(), order.end(), 0);
  this->Texels.clear();
  this->PackNodes(order, 0, static_cast<int>(order.size()), centres);
  this->NodeCount = static_cast<int>(this->Texels.size() / 2);
  for (int i : order)
  {
    for (int point : this->Triangles[i])
    {
      this->Texels.emplace_back(this->Points[point], 0.0);
    }
  }
}
}
