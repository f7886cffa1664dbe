// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightCasterMesh.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace airlight
{
namespace
{
bool HasOnlyTriangles(vtkPolyData* data)
{
  return data->GetNumberOfStrips() == 0 && data->GetPolys()->IsHomogeneous() == 3;
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// For each point the first point at the same position; -1 for points that are not finite.
std::vector<vtkIdType> MergeByPosition(vtkPoints* points)
{
  const vtkIdType n = points->GetNumberOfPoints();
  // The locator cannot take points that are not finite; they go to the origin and are unmarked.
  vtkNew<vtkPoints> finite;
  finite->SetDataTypeToDouble();
  finite->SetNumberOfPoints(n);
  std::vector<vtkIdType> map(n, -1);
  std::vector<char> isFinite(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    glm::dvec3 p;
    points->GetPoint(i, &p.x);
    isFinite[i] = IsFinite(p);
    finite->SetPoint(i, isFinite[i] ? p.x : 0.0, isFinite[i] ? p.y : 0.0, isFinite[i] ? p.z : 0.0);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(finite);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  locator->MergePoints(0.0, map.data());
  for (vtkIdType i = 0; i < n; ++i)
  {
    map[i] = isFinite[i] ? map[i] : -1;
  }
  return map;
}
}

//------------------------------------------------------------------------------
CasterMesh::CasterMesh(vtkPolyData* data)
{
  if (!data || !data->GetPoints() || data->GetNumberOfPolys() + data->GetNumberOfStrips() == 0)
  {
    return;
  }
  this->ReadTriangles(data);
  this->BuildPlanes();
  this->BuildEdges();
}

//------------------------------------------------------------------------------
void CasterMesh::ReadTriangles(vtkPolyData* data)
{
  vtkNew<vtkTriangleFilter> triangulate;
  if (!HasOnlyTriangles(data))
  {
    vtkNew<vtkPolyData> copy; // keeps the pipeline from touching the caller's data
    copy->ShallowCopy(data);
    triangulate->SetInputData(copy);
    triangulate->PassVertsOff();
    triangulate->PassLinesOff();
    triangulate->Update();
    data = triangulate->GetOutput();
  }
  const std::vector<vtkIdType> merged = MergeByPosition(data->GetPoints());
  std::vector<int> compact(merged.size(), -1);
  const auto vertex = [&](vtkIdType id) -> int {
    if (id < 0 || id >= static_cast<vtkIdType>(merged.size()) || merged[id] < 0)
    {
      return -1;
    }
    int& index = compact[merged[id]];
    if (index < 0)
    {
      index = static_cast<int>(this->Points.size());
      glm::dvec3 p;
      data->GetPoint(merged[id], &p.x);
      this->Points.push_back(p);
    }
    return index;
  };
  this->Triangles.reserve(data->GetNumberOfPolys());
  auto cell = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    if (size != 3)
    {
      continue;
    }
    const std::array<int, 3> t = { vertex(ids[0]), vertex(ids[1]), vertex(ids[2]) };
    if (t[0] >= 0 && t[1] >= 0 && t[2] >= 0 && t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      this->Triangles.push_back(t);
    }
  }
}

//------------------------------------------------------------------------------
void CasterMesh::BuildPlanes()
{
  if (!this->Points.empty())
  {
    this->BoundsMin = this->BoundsMax = this->Points[0];
  }
  for (const glm::dvec3& p : this->Points)
  {
    this->BoundsMin = glm::min(this->BoundsMin, p);
    this->BoundsMax = glm::max(this->BoundsMax, p);
  }
  this->Planes.reserve(this->Triangles.size());
  for (const std::array<int, 3>& t : this->Triangles)
  {
    const glm::dvec3& a = this->Points[t[0]];
    const glm::dvec3 normal = glm::cross(this->Points[t[1]] - a, this->Points[t[2]] - a);
    this->Planes.emplace_back(normal, -glm::dot(normal, a));
  }
}

//------------------------------------------------------------------------------
void CasterMesh::BuildEdges()
{
  struct Use
  {
    std::uint64_t Key;
    EdgeUse Value;
  };
  std::vector<Use> uses;
  uses.reserve(3 * this->Triangles.size());
  for (size_t f = 0; f < this->Triangles.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto a = static_cast<std::uint64_t>(this->Triangles[f][k]);
      const auto b = static_cast<std::uint64_t>(this->Triangles[f][(k + 1) % 3]);
      uses.push_back(
        { std::min(a, b) << 32 | std::max(a, b), static_cast<EdgeUse>(2 * f + (a < b ? 1 : 0)) });
    }
  }
  std::sort(uses.begin(), uses.end(),
    [](const Use& a, const Use& b) { return a.Key != b.Key ? a.Key < b.Key : a.Value < b.Value; });
  this->Uses.reserve(uses.size());
  this->Edges.reserve(uses.size() / 2);
  for (size_t i = 0; i < uses.size(); ++i)
  {
    if (i == 0 || uses[i].Key != uses[i - 1].Key)
    {
      this->Edges.push_back({ static_cast<int>(uses[i].Key >> 32),
        static_cast<int>(uses[i].Key & 0xffffffffu), static_cast<int>(i) });
    }
    this->Uses.push_back(uses[i].Value);
  }
}
}
