// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/CurvedMesh.h"

#include "formats/Vector3.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace airlight
{

namespace
{
constexpr vtkIdType MostTriangles = 24000; // of the curved mesh
constexpr int MostParts = 4;               // of an edge
constexpr double Shape = 0.75;             // of the way to the tangent planes, the paper's
constexpr double StiffAngle = 30.0;        // degrees
constexpr double SameNormal = 1.0 - 1e-6;

using Edge = std::pair<vtkIdType, vtkIdType>;
using Triangle = std::array<vtkIdType, 3>;

class Curver
{
public:
  Curver(vtkPolyData* triangles, int parts);

  vtkSmartPointer<vtkPolyData> Make();

private:
  void FindStiff();
  Vector3 GetPoint(vtkIdType id) const;
  Vector3 GetNormal(vtkIdType id) const;
  Vector3 Place(const Triangle& triangle, const Vector3& weights) const;
  vtkIdType Insert(const Triangle& triangle, const Vector3& weights);
  vtkIdType GetEdgePoint(vtkIdType a, vtkIdType b, int part);
  vtkIdType GetNode(const Triangle& triangle, int i, int j);
  void Cut(const Triangle& triangle);

  vtkPolyData* Mesh;
  vtkDataArray* Normals;
  int Parts;
  std::vector<Triangle> Triangles;
  std::vector<bool> Stiff;      // points whose normals say nothing about a curve
  std::vector<vtkIdType> First; // point at the same place, so that seams stay shut to the last bit
  std::map<std::pair<Edge, int>, vtkIdType> EdgePoints;
  vtkNew<vtkPoints> NewPoints;
  vtkNew<vtkCellArray> NewTriangles;
  vtkNew<vtkPolyData> Curved;
};

//------------------------------------------------------------------------------
Curver::Curver(vtkPolyData* triangles, int parts)
  : Mesh(triangles)
  , Normals(triangles->GetPointData()->GetNormals())
  , Parts(parts)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfPolys(); ++cell)
  {
    triangles->GetPolys()->GetCellAtId(cell, ids);
    this->Triangles.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
  }
  this->FindStiff();
}

//------------------------------------------------------------------------------
// Those of sharp edges, whose place has several normals, and those of corners.
void Curver::FindStiff()
{
  const vtkIdType count = this->Mesh->GetNumberOfPoints();
  this->Stiff.assign(count, false);
  this->First.resize(count);
  const double smallest = std::cos(vtkMath::RadiansFromDegrees(StiffAngle));
  for (const Triangle& triangle : this->Triangles)
  {
    Vector3 flat;
    vtkTriangle::ComputeNormal(this->GetPoint(triangle[0]).data(),
      this->GetPoint(triangle[1]).data(), this->GetPoint(triangle[2]).data(), flat.data());
    for (const vtkIdType id : triangle)
    {
      const double cosine = vtkMath::Dot(this->GetNormal(id).data(), flat.data());
      this->Stiff[id] = this->Stiff[id] || !(cosine > smallest);
    }
  }
  std::map<Vector3, std::vector<vtkIdType>> places;
  for (vtkIdType id = 0; id < count; ++id)
  {
    places[this->GetPoint(id)].push_back(id);
  }
  for (const auto& place : places)
  {
    const Vector3 normal = this->GetNormal(place.second.front());
    const bool stiff =
      std::any_of(place.second.begin(), place.second.end(), [this, &normal](vtkIdType id) {
        return this->Stiff[id] ||
          vtkMath::Dot(this->GetNormal(id).data(), normal.data()) < SameNormal;
      });
    for (const vtkIdType id : place.second)
    {
      this->Stiff[id] = stiff;
      this->First[id] = place.second.front();
    }
  }
}

//------------------------------------------------------------------------------
Vector3 Curver::GetPoint(vtkIdType id) const
{
  Vector3 point;
  this->Mesh->GetPoint(id, point.data());
  return point;
}

//------------------------------------------------------------------------------
Vector3 Curver::GetNormal(vtkIdType id) const
{
  Vector3 normal;
  this->Normals->GetTuple(id, normal.data());
  vtkMath::Normalize(normal.data());
  return normal;
}

//------------------------------------------------------------------------------
// On an edge only its two corners count, so that both of its triangles have the same points.
Vector3 Curver::Place(const Triangle& triangle, const Vector3& weights) const
{
  Vector3 flat = { 0.0, 0.0, 0.0 };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 corner = this->GetPoint(triangle[k]);
    std::transform(flat.begin(), flat.end(), corner.begin(), flat.begin(),
      [&weights, k](double sum, double x) { return sum + weights[k] * x; });
  }
  Vector3 place = flat;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (this->Stiff[triangle[k]])
    {
      continue;
    }
    const Vector3 normal = this->GetNormal(this->First[triangle[k]]);
    Vector3 way;
    vtkMath::Subtract(flat.data(), this->GetPoint(triangle[k]).data(), way.data());
    const double off = Shape * weights[k] * vtkMath::Dot(way.data(), normal.data());
    std::transform(place.begin(), place.end(), normal.begin(), place.begin(),
      [off](double x, double n) { return x - off * n; });
  }
  return place;
}

//------------------------------------------------------------------------------
vtkIdType Curver::Insert(const Triangle& triangle, const Vector3& weights)
{
  vtkNew<vtkIdList> ids;
  for (const vtkIdType id : triangle)
  {
    ids->InsertNextId(id);
  }
  const vtkIdType point = this->NewPoints->InsertNextPoint(this->Place(triangle, weights).data());
  Vector3 shares = weights;
  this->Curved->GetPointData()->InterpolatePoint(
    this->Mesh->GetPointData(), point, ids, shares.data());
  return point;
}

//------------------------------------------------------------------------------
vtkIdType Curver::GetEdgePoint(vtkIdType a, vtkIdType b, int part)
{
  if (this->First[a] > this->First[b])
  {
    return this->GetEdgePoint(b, a, this->Parts - part);
  }
  const auto [entry, isNew] = this->EdgePoints.emplace(std::make_pair(Edge(a, b), part), 0);
  if (isNew)
  {
    const double share = static_cast<double>(part) / this->Parts;
    entry->second = this->Insert({ a, b, b }, { 1.0 - share, share, 0.0 });
  }
  return entry->second;
}

//------------------------------------------------------------------------------
// The node of i parts of the way to the second corner, and j to the third.
vtkIdType Curver::GetNode(const Triangle& triangle, int i, int j)
{
  const int rest = this->Parts - i - j;
  if (i == this->Parts || j == this->Parts || rest == this->Parts)
  {
    return i > 0 ? triangle[1] : j > 0 ? triangle[2] : triangle[0];
  }
  if (rest == 0)
  {
    return this->GetEdgePoint(triangle[1], triangle[2], j);
  }
  if (i == 0)
  {
    return this->GetEdgePoint(triangle[0], triangle[2], j);
  }
  if (j == 0)
  {
    return this->GetEdgePoint(triangle[0], triangle[1], i);
  }
  const double part = 1.0 / this->Parts;
  return this->Insert(triangle, { rest * part, i * part, j * part });
}

//------------------------------------------------------------------------------
void Curver::Cut(const Triangle& triangle)
{
  std::vector<std::vector<vtkIdType>> rows;
  for (int j = 0; j <= this->Parts; ++j)
  {
    rows.emplace_back();
    for (int i = 0; i + j <= this->Parts; ++i)
    {
      rows.back().push_back(this->GetNode(triangle, i, j));
    }
  }
  const auto add = [this](vtkIdType a, vtkIdType b, vtkIdType c) {
    this->NewTriangles->InsertNextCell({ a, b, c });
  };
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
  {
    for (std::size_t i = 0; i + 1 < rows[j].size(); ++i)
    {
      add(rows[j][i], rows[j][i + 1], rows[j + 1][i]);
      if (i + 1 < rows[j + 1].size())
      {
        add(rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]);
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Curver::Make()
{
  const vtkIdType old = this->Mesh->GetNumberOfPoints();
  const auto count = static_cast<vtkIdType>(this->Triangles.size());
  this->NewPoints->SetDataTypeToDouble();
  this->Curved->GetPointData()->InterpolateAllocate(
    this->Mesh->GetPointData(), old + count * this->Parts * this->Parts);
  for (vtkIdType id = 0; id < old; ++id)
  {
    this->NewPoints->InsertNextPoint(this->Mesh->GetPoint(id));
    this->Curved->GetPointData()->CopyData(this->Mesh->GetPointData(), id, id);
  }
  for (const Triangle& triangle : this->Triangles)
  {
    this->Cut(triangle);
  }
  this->Curved->SetPoints(this->NewPoints);
  this->Curved->SetPolys(this->NewTriangles);
  return this->Curved;
}

// Polygons of three points and more: what is less, and strips of it, vtkTriangleFilter may not
// survive. Lines and single points would be lost.
bool HasPolygonsAlone(vtkPolyData* mesh)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    if (ids->GetNumberOfIds() < 3)
    {
      return false;
    }
  }
  return mesh->GetNumberOfStrips() == 0 && mesh->GetNumberOfLines() == 0 &&
    mesh->GetNumberOfVerts() == 0;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeCurved(vtkPolyData* mesh)
{
  if (!mesh->GetPointData()->GetNormals() || !HasPolygonsAlone(mesh))
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* triangulated = triangles->GetOutput();
  const vtkIdType count = std::max<vtkIdType>(1, triangulated->GetNumberOfPolys());
  const double fitting = std::sqrt(static_cast<double>(MostTriangles) / static_cast<double>(count));
  const int parts = std::min(MostParts, static_cast<int>(fitting));
  return parts > 1 ? Curver(triangulated, parts).Make() : vtkSmartPointer<vtkPolyData>(mesh);
}

}
