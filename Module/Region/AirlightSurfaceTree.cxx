// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Region/AirlightSurfaceTree.h"

#include "Region/AirlightSurfaceOrientation.h"
#include "Region/AirlightTriangulate.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

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
// Above it, numbers of nodes in texels are no longer exact in single precision.
constexpr size_t MostTriangles = 4000000;
}

//------------------------------------------------------------------------------
std::shared_ptr<const SurfaceTree> SurfaceTree::Build(vtkPolyData* mesh, std::string& error)
{
  auto tree = std::make_shared<SurfaceTree>();
  if (!tree->ReadMesh(mesh, error))
  {
    return nullptr;
  }
  SurfaceOrientation orientation(tree->Points, tree->GetCentre(), tree->Triangles);
  if (!orientation.OrientAlike(error))
  {
    return nullptr;
  }
  tree->Pack();
  orientation.OrientOutwards(*tree);
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
           << "); all points must be finite and below 1e15: fix or remove it";
      error = text.str();
      return false;
    }
  }
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(Triangulate(mesh));
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
  const bool isLeaf = end - begin == 1;
  this->Texels.emplace_back(least - margin, 0.0);
  this->Texels.emplace_back(greatest + margin, isLeaf ? begin : -1.0);
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
  const size_t nodes = this->Texels.size() / 2;
  this->Texels[node].w = static_cast<double>(nodes);
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
