// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightOpacityMesh.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight
{
namespace
{
// Into so many triangles a mesh is divided at most, as long as it has fewer.
constexpr double MostTriangles = 400000.0;

// Opacities are multiples of 2^-24, so that those at the points of an edge of constant opacity are
// the same in spite of rounding, and either all above where a mesh is cut or all below.
constexpr double Steps = 16777216.0;

const char* const AlphaName = "AirlightAlpha";

// The alpha of the colours that a mapper shows; null if all are opaque. MapScalars() of the mapper
// would leave it with colours of another opacity, to be made again.
vtkSmartPointer<vtkDataArray> FindAlphas(vtkMapper* mapper, vtkAbstractArray* scalars)
{
  vtkScalarsToColors* table = mapper->GetLookupTable();
  if (!mapper->GetUseLookupTableScalarRange())
  {
    table->SetRange(mapper->GetScalarRange()); // as the mapper does
  }
  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(scalars, mapper->GetColorMode(), -1));
  if (!colours || colours->GetNumberOfComponents() != 4)
  {
    return nullptr;
  }
  auto alphas = vtkSmartPointer<vtkDoubleArray>::New();
  alphas->SetName(AlphaName);
  alphas->SetNumberOfTuples(colours->GetNumberOfTuples());
  bool translucent = false;
  for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
  {
    const int alpha = colours->GetValue(4 * i + 3);
    translucent = translucent || alpha < 255;
    alphas->SetValue(i, alpha / 255.0);
  }
  if (!translucent)
  {
    return nullptr;
  }
  return alphas;
}
}

//------------------------------------------------------------------------------
vtkAbstractArray* FindMappedScalars(vtkMapper* mapper, vtkPolyData* data, int& kind)
{
  kind = 0;
  return mapper->GetScalarVisibility()
    ? vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), kind)
    : nullptr;
}

//------------------------------------------------------------------------------
OpacityMesh::OpacityMesh(vtkActor* actor, vtkPolyData* data)
  : Opacity(1.0)
  , Texture(GetColourTexture(actor))
{
  vtkNew<vtkPolyData> input;
  input->ShallowCopy(data);
  if (!actor->HasOpaqueGeometry())
  {
    this->Opacity = actor->GetProperty()->GetOpacity();
    this->FindScalars(actor->GetMapper(), input);
  }
  vtkDataArray* coordinates = data->GetPointData()->GetTCoords();
  const bool textured =
    coordinates && coordinates->GetNumberOfComponents() >= 2 && this->Texture.HasAlpha();
  if (!textured && !this->Alphas)
  {
    return;
  }
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(input);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  this->Triangles->ShallowCopy(triangulate->GetOutput());
  this->Coordinates = textured ? this->Triangles->GetPointData()->GetTCoords() : nullptr;
  if (this->Alphas)
  {
    vtkDataSetAttributes* attributes = this->AlphasOfCells
      ? static_cast<vtkDataSetAttributes*>(this->Triangles->GetCellData())
      : this->Triangles->GetPointData();
    this->Alphas = attributes->GetArray(AlphaName);
  }
}

//------------------------------------------------------------------------------
void OpacityMesh::FindScalars(vtkMapper* mapper, vtkPolyData* data)
{
  int kind = 0;
  vtkAbstractArray* scalars = FindMappedScalars(mapper, data, kind);
  const vtkIdType count = kind == 1 ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  if (!scalars || kind > 1 || scalars->GetNumberOfTuples() != count)
  {
    return;
  }
  this->Alphas = FindAlphas(mapper, scalars);
  this->AlphasOfCells = kind == 1;
  if (this->Alphas)
  {
    vtkDataSetAttributes* attributes = this->AlphasOfCells
      ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
      : data->GetPointData();
    attributes->AddArray(this->Alphas);
  }
}

//------------------------------------------------------------------------------
// Of each edge: two for each texel that the longest edge passes, since interpolated colours bend in
// the middle of texels, as far as the number of triangles allows. All edges have the same number,
// so that neighbours meet at the same points.
int OpacityMesh::GetDivisions() const
{
  if (!this->Coordinates)
  {
    return 1;
  }
  const glm::dvec2 texels(this->Texture.GetSize());
  double longest = 1.0;
  vtkNew<vtkIdList> points;
  const vtkIdType count = this->Triangles->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    this->Triangles->GetCellPoints(cell, points);
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec2 edge = this->GetCorner(points->GetId(i), cell).Coordinates -
        this->GetCorner(points->GetId((i + 1) % 3), cell).Coordinates;
      const glm::dvec2 passed = 2.0 * glm::abs(edge) * texels;
      longest = std::max({ longest, passed.x, passed.y });
    }
  }
  const double most = std::sqrt(MostTriangles / static_cast<double>(std::max<vtkIdType>(count, 1)));
  return static_cast<int>(std::max(std::min(std::ceil(longest), std::floor(most)), 1.0));
}

//------------------------------------------------------------------------------
OpacityMesh::Corner OpacityMesh::GetCorner(vtkIdType point, vtkIdType cell) const
{
  Corner corner;
  corner.Point = point;
  this->Triangles->GetPoint(point, &corner.Position.x);
  if (this->Coordinates)
  {
    corner.Coordinates = glm::dvec2(
      this->Coordinates->GetComponent(point, 0), this->Coordinates->GetComponent(point, 1));
  }
  if (this->Alphas)
  {
    corner.Alpha = this->Alphas->GetComponent(this->AlphasOfCells ? cell : point, 0);
  }
  return corner;
}

//------------------------------------------------------------------------------
// In the same order for both triangles at an edge.
std::array<OpacityMesh::Corner, 3> OpacityMesh::GetCorners(vtkIdList* points, vtkIdType cell) const
{
  std::array<Corner, 3> corners;
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = this->GetCorner(points->GetId(i), cell);
  }
  std::sort(corners.begin(), corners.end(),
    [](const Corner& a, const Corner& b) { return a.Point < b.Point; });
  return corners;
}

//------------------------------------------------------------------------------
OpacityCorner OpacityMesh::Interpolate(
  const std::array<Corner, 3>& corners, const glm::dvec3& weights) const
{
  OpacityCorner result;
  double alpha = 0.0;
  glm::dvec2 coordinates(0.0);
  for (int i = 0; i < 3; ++i)
  {
    result.Position += weights[i] * corners[i].Position;
    coordinates += weights[i] * corners[i].Coordinates;
    alpha += weights[i] * corners[i].Alpha;
  }
  const double texel = this->Coordinates ? this->Texture.Get(coordinates).w : 1.0;
  const double product = this->Opacity * alpha * texel;
  const double opacity = product > 0.0 ? std::min(product, 1.0) : 0.0; // not a number: a hole
  result.Opacity = std::round(opacity * Steps) / Steps;
  return result;
}

//------------------------------------------------------------------------------
void OpacityMesh::VisitTriangles(const std::function<void(const OpacityTriangle&)>& visit) const
{
  const int divisions = this->GetDivisions();
  vtkNew<vtkIdList> points;
  std::vector<OpacityCorner> before;
  std::vector<OpacityCorner> row;
  for (vtkIdType cell = 0; cell < this->Triangles->GetNumberOfCells(); ++cell)
  {
    this->Triangles->GetCellPoints(cell, points);
    const std::array<Corner, 3> corners = this->GetCorners(points, cell);
    for (int i = 0; i <= divisions; ++i)
    {
      row.clear();
      for (int k = 0; k <= i; ++k)
      {
        row.push_back(this->Interpolate(
          corners, glm::dvec3(divisions - i, i - k, k) / static_cast<double>(divisions)));
      }
      for (int k = 0; k < i; ++k)
      {
        visit({ before[k], row[k], row[k + 1] });
        if (k + 1 < i)
        {
          visit({ before[k], row[k + 1], before[k + 1] });
        }
      }
      before.swap(row);
    }
  }
}
}
