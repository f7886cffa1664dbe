// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightWritePieces.h"

#include "Silhouette/AirlightParallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace airlight
{
namespace
{
// What value(cell, component) returns, as an array of the output's cell data.
template <typename Array, typename Function>
void AddCellArray(
  vtkPolyData* output, const char* name, size_t count, int components, const Function& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  auto* values = array->GetPointer(0);
  for (size_t i = 0; i < count; ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      values[components * i + k] = value(i, k);
    }
  }
  output->GetCellData()->AddArray(array);
}

vtkIdType GetSource(const CasterMesh& mesh, int vertex)
{
  return vertex >= 0 ? mesh.SourcePoints[vertex] : -1;
}

void AllocatePointData(vtkPolyData* input, vtkPolyData* output, vtkIdType count)
{
  vtkPointData* data = output->GetPointData();
  data->CopyGlobalIdsOff(); // a point may come several times
  data->InterpolateAllocate(input->GetPointData(), count);
}
}

//------------------------------------------------------------------------------
void WriteLines(const CasterMesh& mesh, const std::vector<SilhouetteEdge>& edges,
  vtkPolyData* input, vtkPolyData* output)
{
  std::vector<char> marks(mesh.Points.size());
  for (const SilhouetteEdge& edge : edges)
  {
    marks[edge.A] = marks[edge.B] = 1;
  }
  const Numbering vertices(marks);
  const auto count = static_cast<vtkIdType>(vertices.Marked.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdList> sources;
  sources->SetNumberOfIds(count);
  vtkNew<vtkIdList> targets;
  targets->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, &mesh.Points[vertices.Marked[i]].x);
    sources->SetId(i, mesh.SourcePoints[vertices.Marked[i]]);
    targets->SetId(i, i);
  }
  output->SetPoints(points);
  output->GetPointData()->CopyAllocate(input->GetPointData(), count);
  output->GetPointData()->CopyData(input->GetPointData(), sources, targets);
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(
    static_cast<vtkIdType>(edges.size()), 2 * static_cast<vtkIdType>(edges.size()));
  for (const SilhouetteEdge& edge : edges)
  {
    const vtkIdType ends[2] = { vertices.Number[edge.A], vertices.Number[edge.B] };
    lines->InsertNextCell(2, ends);
  }
  output->SetLines(lines);
  AddCellArray<vtkIntArray>(
    output, "Weight", edges.size(), 1, [&](size_t i, int) { return edges[i].Weight; });
  AddCellArray<vtkIdTypeArray>(output, "EdgePoints", edges.size(), 2,
    [&](size_t i, int k) { return mesh.SourcePoints[k == 0 ? edges[i].A : edges[i].B]; });
}

//------------------------------------------------------------------------------
void WritePieces(
  const CasterMesh& mesh, const ShadowPieces& pieces, vtkPolyData* input, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(pieces.Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble(); // four corners rounded to single precision are no plane
  points->SetNumberOfPoints(count);
  AllocatePointData(input, output, count);
  vtkPointData* data = output->GetPointData();
  vtkNew<vtkIdList> sources;
  sources->SetNumberOfIds(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const PiecePoint& point = pieces.Points[i];
    points->SetPoint(i, &point.Position.x);
    for (int k = 0; k < 3; ++k)
    {
      sources->SetId(k, mesh.SourcePoints[point.Vertices[k]]);
    }
    if (data->GetNumberOfArrays() > 0)
    {
      double weights[3] = { point.Weights.x, point.Weights.y, point.Weights.z };
      data->InterpolatePoint(input->GetPointData(), i, sources, weights);
    }
  }
  output->SetPoints(points);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(static_cast<vtkIdType>(pieces.Ids.size()));
  std::copy(pieces.Ids.begin(), pieces.Ids.end(), ids->GetPointer(0));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(pieces.Sizes.size()) + 1);
  vtkIdType offset = 0;
  for (size_t i = 0; i < pieces.Sizes.size(); ++i)
  {
    offsets->SetValue(static_cast<vtkIdType>(i), offset);
    offset += pieces.Sizes[i];
  }
  offsets->SetValue(offsets->GetNumberOfValues() - 1, offset);
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, ids);
  output->SetPolys(polygons);
  const std::vector<PieceLabel>& labels = pieces.Labels;
  AddCellArray<vtkIntArray>(
    output, "Weight", labels.size(), 1, [&](size_t i, int) { return labels[i].Weight; });
  AddCellArray<vtkIdTypeArray>(output, "EdgePoints", labels.size(), 2,
    [&](size_t i, int k) { return GetSource(mesh, k == 0 ? labels[i].A : labels[i].B); });
  AddCellArray<vtkIntArray>(
    output, "Part", labels.size(), 1, [&](size_t i, int) { return labels[i].Part; });
}
}
