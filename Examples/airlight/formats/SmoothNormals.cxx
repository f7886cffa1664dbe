// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/SmoothNormals.h"

#include "formats/Vector3.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleStrip.h>

#include <map>
#include <set>
#include <utility>

namespace airlight
{

namespace
{
vtkSmartPointer<vtkPolyData> CutStrips(vtkPolyData* mesh)
{
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(mesh->GetPolys());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfStrips(); ++cell)
  {
    mesh->GetStrips()->GetCellAtId(cell, corners);
    vtkTriangleStrip::DecomposeStrip(
      static_cast<int>(corners->GetNumberOfIds()), corners->GetPointer(0), polygons);
  }
  auto cut = vtkSmartPointer<vtkPolyData>::New();
  cut->ShallowCopy(mesh);
  cut->SetStrips(nullptr);
  cut->SetPolys(polygons);
  return cut;
}

// The polygons alone, corner by corner, with one point at each place.
vtkSmartPointer<vtkPolyData> MergePoints(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<Vector3, vtkIdType> places;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      Vector3 place;
      mesh->GetPoint(corners->GetId(i), place.data());
      const auto [entry, isNew] = places.emplace(place, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(place.data());
      }
      corners->SetId(i, entry->second);
    }
    polygons->InsertNextCell(corners);
  }
  auto merged = vtkSmartPointer<vtkPolyData>::New();
  merged->SetPoints(points);
  merged->SetPolys(polygons);
  return merged;
}

// Polygons and corners in the same order.
vtkSmartPointer<vtkPolyData> FindNormals(vtkPolyData* merged)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(merged);
  normals->SetFeatureAngle(SmoothAngle);
  normals->ConsistencyOff();
  normals->AutoOrientNormalsOff();
  normals->Update();
  return normals->GetOutput();
}

// A mesh whose corners have the normals of another one's.
class Taker
{
public:
  Taker(vtkPolyData* mesh, vtkPolyData* shaded)
    : Mesh(mesh)
    , Shaded(shaded)
  {
    this->Taken->ShallowCopy(mesh);
    this->Points->DeepCopy(mesh->GetPoints());
    this->Taken->GetPointData()->DeepCopy(mesh->GetPointData());
    this->Taken->SetPoints(this->Points);
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
    this->Normals->Fill(0.0);
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    vtkNew<vtkCellArray> polygons;
    vtkNew<vtkIdList> corners;
    vtkNew<vtkIdList> others;
    for (vtkIdType cell = 0; cell < this->Mesh->GetNumberOfPolys(); ++cell)
    {
      this->Mesh->GetPolys()->GetCellAtId(cell, corners);
      this->Shaded->GetPolys()->GetCellAtId(cell, others);
      for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      {
        corners->SetId(i, this->GetPoint(corners->GetId(i), others->GetId(i)));
      }
      polygons->InsertNextCell(corners);
    }
    this->Taken->SetPolys(polygons);
    this->Taken->GetPointData()->SetNormals(this->Normals);
    return this->Taken;
  }

private:
  // The point of a corner: its own for the first normal that it has, a copy for each other one.
  vtkIdType GetPoint(vtkIdType own, vtkIdType shaded)
  {
    const auto [entry, isNew] = this->Known.emplace(std::make_pair(own, shaded), own);
    if (isNew)
    {
      if (!this->Used.insert(own).second)
      {
        entry->second = this->Points->InsertNextPoint(this->Mesh->GetPoint(own));
        vtkPointData* data = this->Taken->GetPointData();
        for (int i = 0; i < data->GetNumberOfArrays(); ++i)
        {
          data->GetAbstractArray(i)->InsertNextTuple(
            own, this->Mesh->GetPointData()->GetAbstractArray(i));
        }
      }
      this->Normals->InsertTuple(
        entry->second, this->Shaded->GetPointData()->GetNormals()->GetTuple(shaded));
    }
    return entry->second;
  }

  vtkPolyData* Mesh;
  vtkPolyData* Shaded;
  vtkNew<vtkPolyData> Taken;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Known;
  std::set<vtkIdType> Used;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> AddSmoothNormals(vtkPolyData* mesh)
{
  const bool strips = mesh->GetNumberOfStrips() > 0;
  if (mesh->GetPointData()->GetNormals() ||
    (strips && mesh->GetCellData()->GetNumberOfArrays() > 0))
  {
    return mesh;
  }
  const vtkSmartPointer<vtkPolyData> polygons =
    strips ? CutStrips(mesh) : vtkSmartPointer<vtkPolyData>(mesh);
  const vtkSmartPointer<vtkPolyData> shaded = FindNormals(MergePoints(polygons));
  return shaded->GetNumberOfPolys() == polygons->GetNumberOfPolys()
    ? Taker(polygons, shaded).Make()
    : vtkSmartPointer<vtkPolyData>(mesh);
}

}
