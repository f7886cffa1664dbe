// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/SolidMesh.h"

#include "formats/Vector3.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace airlight
{

namespace
{
// In diagonals of the box around all points.
constexpr double TubeRadius = 0.003;
constexpr double SmallestBead = 0.001, LargestBead = 0.02;

constexpr int Sides = 8;           // of a tube
constexpr vtkIdType Round = 10000; // more beads have fewer triangles

// The surface so far. Its points have the scalars of points of the mesh.
class Solid
{
public:
  explicit Solid(vtkPolyData* mesh)
    : From(mesh->GetPointData()->GetScalars())
  {
    this->Points->SetDataType(mesh->GetPoints()->GetDataType());
    this->Normals->SetNumberOfComponents(3);
    if (this->From)
    {
      this->To = vtk::TakeSmartPointer(this->From->NewInstance());
      this->To->SetName(this->From->GetName());
      this->To->SetNumberOfComponents(this->From->GetNumberOfComponents());
    }
  }

  vtkIdType AddPoint(const Vector3& middle, double radius, const Vector3& direction,
    const Vector3& normal, vtkIdType original)
  {
    Vector3 point;
    for (std::size_t i = 0; i < 3; ++i)
    {
      point[i] = middle[i] + radius * direction[i];
    }
    this->Normals->InsertNextTuple(normal.data());
    if (this->From)
    {
      this->To->InsertNextTuple(original, this->From);
    }
    return this->Points->InsertNextPoint(point.data());
  }

  void AddPolygon(const std::vector<vtkIdType>& corners)
  {
    this->Polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }

  vtkSmartPointer<vtkPolyData> GetMesh() const
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Polygons);
    mesh->GetPointData()->SetNormals(this->Normals);
    mesh->GetPointData()->SetScalars(this->To);
    return mesh;
  }

private:
  vtkDataArray* From;
  vtkSmartPointer<vtkDataArray> To;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkCellArray> Polygons;
};

Vector3 GetPoint(vtkPolyData* mesh, vtkIdType id)
{
  Vector3 point;
  mesh->GetPoint(id, point.data());
  return point;
}

// From one point to the other; of length 0 where they are one.
Vector3 GetDirection(vtkPolyData* mesh, vtkIdType from, vtkIdType to)
{
  const Vector3 start = GetPoint(mesh, from);
  Vector3 way = GetPoint(mesh, to);
  vtkMath::Subtract(way.data(), start.data(), way.data());
  vtkMath::Normalize(way.data());
  return way;
}

// The points of a line without those where it does not move on.
std::vector<vtkIdType> GetMovingPoints(vtkPolyData* mesh, vtkIdList* line)
{
  std::vector<vtkIdType> points;
  for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = line->GetId(i);
    if (points.empty() || vtkMath::Norm(GetDirection(mesh, points.back(), id).data()) > 0.0)
    {
      points.push_back(id);
    }
  }
  return points;
}

// Of a bend the middle of both directions, and of a line that turns back the one that it leaves by.
Vector3 GetTangent(vtkPolyData* mesh, const std::vector<vtkIdType>& points, std::size_t i)
{
  const std::size_t last = points.size() - 1;
  const Vector3 after =
    GetDirection(mesh, points[std::min(i, last - 1)], points[std::min(i, last - 1) + 1]);
  const Vector3 before = i > 0 ? GetDirection(mesh, points[i - 1], points[i]) : after;
  Vector3 tangent;
  vtkMath::Add(before.data(), after.data(), tangent.data());
  return vtkMath::Normalize(tangent.data()) > 1e-3 ? tangent : after;
}

// Moves a direction across the line on to a tangent; any one if it lies along it.
void MoveAcross(Vector3& across, const Vector3& tangent)
{
  const double along = vtkMath::Dot(across.data(), tangent.data());
  for (std::size_t i = 0; i < 3; ++i)
  {
    across[i] -= along * tangent[i];
  }
  if (vtkMath::Normalize(across.data()) < 1e-3)
  {
    Vector3 other;
    vtkMath::Perpendiculars(tangent.data(), across.data(), other.data(), 0.0);
  }
}

void AddTube(vtkPolyData* mesh, const std::vector<vtkIdType>& points, double radius, Solid& solid)
{
  std::vector<vtkIdType> ring;
  Vector3 across{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3 middle = GetPoint(mesh, points[i]);
    const Vector3 tangent = GetTangent(mesh, points, i);
    MoveAcross(across, tangent);
    Vector3 other;
    vtkMath::Cross(tangent.data(), across.data(), other.data());
    const std::vector<vtkIdType> before = ring;
    ring.clear();
    for (int side = 0; side < Sides; ++side)
    {
      const double angle = 2.0 * vtkMath::Pi() * side / Sides;
      Vector3 out;
      for (std::size_t k = 0; k < 3; ++k)
      {
        out[k] = std::cos(angle) * across[k] + std::sin(angle) * other[k];
      }
      ring.push_back(solid.AddPoint(middle, radius, out, out, points[i]));
    }
    for (int side = 0; side < Sides && !before.empty(); ++side)
    {
      const int next = (side + 1) % Sides;
      solid.AddPolygon({ before[side], before[next], ring[next], ring[side] });
    }
    if (i == 0)
    {
      solid.AddPolygon({ ring.rbegin(), ring.rend() });
    }
  }
  solid.AddPolygon(ring);
}

void AddTubes(vtkPolyData* mesh, double diagonal, Solid& solid)
{
  vtkNew<vtkIdList> line;
  for (vtkIdType i = 0; i < mesh->GetNumberOfLines(); ++i)
  {
    mesh->GetLines()->GetCellAtId(i, line);
    const std::vector<vtkIdType> points = GetMovingPoints(mesh, line);
    if (points.size() > 1)
    {
      AddTube(mesh, points, TubeRadius * diagonal, solid);
    }
  }
}

std::vector<vtkIdType> GetVertices(vtkPolyData* mesh)
{
  std::vector<vtkIdType> vertices;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < mesh->GetNumberOfVerts(); ++i)
  {
    mesh->GetVerts()->GetCellAtId(i, cell);
    vertices.insert(vertices.end(), cell->begin(), cell->end());
  }
  for (vtkIdType i = 0; mesh->GetNumberOfCells() == 0 && i < mesh->GetNumberOfPoints(); ++i)
  {
    vertices.push_back(i);
  }
  return vertices;
}

// VTK 9.1's icosahedron is.
bool IsInsideOut(vtkPolyData* bead)
{
  vtkNew<vtkIdList> face;
  bead->GetPolys()->GetCellAtId(0, face);
  std::array<Vector3, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = GetPoint(bead, face->GetId(i));
  }
  return vtkMath::Determinant3x3(corners[0].data(), corners[1].data(), corners[2].data()) < 0.0;
}

void AddBeads(vtkPolyData* mesh, double diagonal, Solid& solid)
{
  const std::vector<vtkIdType> vertices = GetVertices(mesh);
  const auto count = static_cast<vtkIdType>(vertices.size());
  vtkNew<vtkPlatonicSolidSource> source;
  source->SetSolidType(count > Round ? VTK_SOLID_OCTAHEDRON : VTK_SOLID_ICOSAHEDRON); // of radius 1
  source->Update();
  vtkPolyData* bead = source->GetOutput();
  const bool turn = IsInsideOut(bead);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  const double apart = 1.0 / std::sqrt(static_cast<double>(count));
  const double radius = diagonal * std::clamp(0.5 * apart, SmallestBead, LargestBead);
  vtkNew<vtkIdList> face;
  std::vector<vtkIdType> corners;
  for (const vtkIdType id : vertices)
  {
    const Vector3 middle = GetPoint(mesh, id);
    Vector3 own{ 0.0, 0.0, 0.0 };
    if (normals)
    {
      normals->GetTuple(id, own.data());
    }
    const double length = vtkMath::Normalize(own.data());
    const bool usable = std::isfinite(length) && length > 0.0;
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < bead->GetNumberOfPoints(); ++i)
    {
      Vector3 out = GetPoint(bead, i);
      vtkMath::Normalize(out.data());
      ids.push_back(solid.AddPoint(middle, radius, out, usable ? own : out, id));
    }
    for (vtkIdType i = 0; i < bead->GetNumberOfPolys(); ++i)
    {
      bead->GetPolys()->GetCellAtId(i, face);
      corners.clear();
      std::transform(face->begin(), face->end(), std::back_inserter(corners),
        [&ids](vtkIdType corner) { return ids[corner]; });
      if (turn)
      {
        std::reverse(corners.begin(), corners.end());
      }
      solid.AddPolygon(corners);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSolid(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() > 0 || mesh->GetNumberOfStrips() > 0)
  {
    return mesh;
  }
  Solid solid(mesh);
  const double diagonal = mesh->GetLength();
  AddTubes(mesh, diagonal, solid);
  AddBeads(mesh, diagonal, solid);
  return solid.GetMesh();
}

}
