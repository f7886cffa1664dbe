// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightCasterMesh.h"

#include "Region/AirlightTriangulate.h"
#include "Silhouette/AirlightCasterEdges.h"
#include "Silhouette/AirlightMergedPoints.h"
#include "Silhouette/AirlightParallel.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"

#include <atomic>
#include <memory>

namespace airlight
{
namespace
{
// Uses of edges have twice a triangle's number, in an int.
constexpr size_t MostTriangles = (size_t(1) << 30) - 1;

// Where the building stands after its steps, by their measured times.
constexpr double AfterTriangulation = 0.1;
constexpr double AfterMerging = 0.3;
constexpr double AfterTriangles = 0.45;
constexpr double AfterPlanes = 0.55;

bool HasOnlyTriangles(vtkPolyData* data)
{
  return data->GetNumberOfStrips() == 0 && data->GetPolys()->IsHomogeneous() == 3;
}

vtkSmartPointer<vtkPolyData> GetTriangles(vtkPolyData* data)
{
  return HasOnlyTriangles(data) ? vtkSmartPointer<vtkPolyData>(data) : Triangulate(data);
}

// The point ids of cells that all are triangles, in a row where VTK keeps them.
class Corners
{
public:
  explicit Corners(vtkCellArray* triangles)
    : Count(triangles->GetNumberOfCells())
  {
    vtkDataArray* ids = triangles->GetConnectivityArray();
    if (auto* ids64 = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(ids))
    {
      this->Ids64 = ids64->GetPointer(0);
    }
    else if (auto* ids32 = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(ids))
    {
      this->Ids32 = ids32->GetPointer(0);
    }
    else // from VTK 9.6 on cells may be kept in other ways
    {
      this->Copy = vtkSmartPointer<vtkTypeInt64Array>::New();
      this->Copy->DeepCopy(ids);
      this->Ids64 = this->Copy->GetPointer(0);
    }
  }

  size_t GetCount() const { return this->Count; }
  std::array<vtkIdType, 3> operator[](size_t triangle) const
  {
    const size_t i = 3 * triangle;
    return this->Ids64
      ? std::array<vtkIdType, 3>{ this->Ids64[i], this->Ids64[i + 1], this->Ids64[i + 2] }
      : std::array<vtkIdType, 3>{ this->Ids32[i], this->Ids32[i + 1], this->Ids32[i + 2] };
  }

private:
  vtkSmartPointer<vtkTypeInt64Array> Copy;
  const vtkTypeInt64* Ids64 = nullptr;
  const vtkTypeInt32* Ids32 = nullptr;
  size_t Count = 0;
};

bool AreDistinct(const std::array<vtkIdType, 3>& ids)
{
  return ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0];
}

// Replaces the points by their vertices. False where the triangle casts nothing: a point does not
// exist or has no vertex, or two have the same.
bool FindVertices(const std::vector<vtkIdType>& vertices, std::array<vtkIdType, 3>& ids)
{
  for (vtkIdType& id : ids)
  {
    id = id >= 0 && id < static_cast<vtkIdType>(vertices.size()) ? vertices[id] : -1;
  }
  return ids[0] >= 0 && ids[1] >= 0 && ids[2] >= 0 && AreDistinct(ids);
}

// Marks what is not a vertex of any triangle, and tells how many triangles each chunk has.
std::vector<size_t> FindUnused(const Corners& corners, std::vector<vtkIdType>& vertices)
{
  // Threads may mark the same vertex at the same time.
  const std::unique_ptr<std::atomic<bool>[]> used(new std::atomic<bool>[vertices.size()]());
  std::vector<size_t> counts(CountChunks(corners.GetCount()));
  ForEachChunk(corners.GetCount(), [&](size_t chunk, size_t begin, size_t end) {
    size_t count = 0;
    for (size_t f = begin; f < end; ++f)
    {
      std::array<vtkIdType, 3> ids = corners[f];
      if (FindVertices(vertices, ids))
      {
        ++count;
        for (const vtkIdType id : ids)
        {
          used[id].store(true, std::memory_order_relaxed);
        }
      }
    }
    counts[chunk] = count;
  });
  ForEachChunk(vertices.size(), [&](size_t, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
    {
      if (vertices[i] >= 0 && !used[vertices[i]].load(std::memory_order_relaxed))
      {
        vertices[i] = -1;
      }
    }
  });
  return counts;
}
}

//------------------------------------------------------------------------------
CasterMesh::CasterMesh(vtkPolyData* data, const Progress& progress)
{
  if (data && data->GetPoints() && data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0 &&
    !this->Build(
      data, progress ? progress : [](double) { return true; }))
  {
    *this = CasterMesh(nullptr);
  }
}

//------------------------------------------------------------------------------
bool CasterMesh::Build(vtkPolyData* data, const Progress& progress)
{
  if (!this->ReadTriangles(data, progress) || !progress(AfterTriangles))
  {
    return false;
  }
  this->BuildPlanes();
  if (!progress(AfterPlanes))
  {
    return false;
  }
  BuildEdges(*this);
  return progress(1.0);
}

//------------------------------------------------------------------------------
bool CasterMesh::ReadTriangles(vtkPolyData* data, const Progress& progress)
{
  const vtkSmartPointer<vtkPolyData> triangles = GetTriangles(data);
  if (!progress(AfterTriangulation))
  {
    return false;
  }
  MergedPoints merged = MergeByPosition(triangles->GetPoints());
  if (!progress(AfterMerging))
  {
    return false;
  }
  const Corners corners(triangles->GetPolys());
  if (corners.GetCount() > MostTriangles ||
    merged.Positions.size() > static_cast<size_t>(std::numeric_limits<int>::max()))
  {
    vtkGenericWarningMacro("A mesh of " << corners.GetCount()
                                        << " triangles casts no shadows: at most " << MostTriangles
                                        << " can. Split it into several data sets.");
    return true;
  }
  std::vector<size_t> first = FindUnused(corners, merged.First);
  size_t count = 0;
  for (size_t& slot : first)
  {
    const size_t size = slot;
    slot = count;
    count += size;
  }
  this->AddPoints(merged.Positions, merged.First);
  this->Triangles.resize(count);
  ForEachChunk(corners.GetCount(), [&](size_t chunk, size_t begin, size_t end) {
    size_t slot = first[chunk];
    for (size_t f = begin; f < end; ++f)
    {
      std::array<vtkIdType, 3> ids = corners[f];
      if (FindVertices(merged.First, ids))
      {
        this->Triangles[slot++] = { static_cast<int>(ids[0]), static_cast<int>(ids[1]),
          static_cast<int>(ids[2]) };
      }
    }
  });
  return true;
}

//------------------------------------------------------------------------------
// Turns each point's first point at the same position into the index of their common vertex.
void CasterMesh::AddPoints(
  const std::vector<glm::dvec3>& positions, std::vector<vtkIdType>& vertices)
{
  this->Points.reserve(positions.size());
  this->SourcePoints.reserve(positions.size());
  // The first point at a position comes before the others, which then find its index.
  for (size_t i = 0; i < positions.size(); ++i)
  {
    const vtkIdType first = vertices[i];
    if (first == static_cast<vtkIdType>(i))
    {
      vertices[i] = static_cast<vtkIdType>(this->Points.size());
      this->Points.push_back(positions[i]);
      this->SourcePoints.push_back(first);
    }
    else if (first >= 0)
    {
      vertices[i] = vertices[first];
    }
  }
  if (!this->Points.empty())
  {
    this->BoundsMin = this->BoundsMax = this->Points[0];
  }
  for (const glm::dvec3& p : this->Points)
  {
    this->BoundsMin = glm::min(this->BoundsMin, p);
    this->BoundsMax = glm::max(this->BoundsMax, p);
  }
}

//------------------------------------------------------------------------------
void CasterMesh::BuildPlanes()
{
  this->Planes.resize(this->Triangles.size());
  ForEachChunk(this->Triangles.size(), [&](size_t, size_t begin, size_t end) {
    for (size_t f = begin; f < end; ++f)
    {
      const std::array<int, 3>& t = this->Triangles[f];
      const glm::dvec3& a = this->Points[t[0]];
      const glm::dvec3 normal = glm::cross(this->Points[t[1]] - a, this->Points[t[2]] - a);
      this->Planes[f] = glm::dvec4(normal, -glm::dot(normal, a));
    }
  });
}
}
