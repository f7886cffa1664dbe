// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/LambertActor.h"

#include "formats/ModelColours.h"
#include "formats/SmoothNormals.h"
#include "scene/CurvedMesh.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolygon.h>
#include <vtkProperty.h>

#include <cmath>

namespace airlight
{

namespace
{
// Polygons keep their order and their winding, which alone decides on the normal's side; the mapper
// turns it to the viewer. Points are not split: shadows need the edges that polygons share.
vtkSmartPointer<vtkPolyData> MakeFlat(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(mesh);
  bare->GetPointData()->SetNormals(nullptr); // the mapper would prefer them
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(bare);
  normals->ComputePointNormalsOff();
  normals->ComputeCellNormalsOn();
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->AutoOrientNormalsOff();
  normals->Update();
  return normals->GetOutput();
}

// Whether points have normals that shading can use: finite, not 0, and on the side that the
// polygons' points turn around, to which VTK's mappers turn them.
bool HasNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (!normals)
  {
    return false;
  }
  vtkIdType agreeing = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    Vector3 flat;
    vtkPolygon::ComputeNormal(
      mesh->GetPoints(), static_cast<int>(ids->GetNumberOfIds()), ids->GetPointer(0), flat.data());
    double sum = 0.0;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const double* normal = normals->GetTuple3(ids->GetId(i));
      const double length = vtkMath::Norm(normal);
      if (!(length > 0.0) || !std::isfinite(length))
      {
        return false;
      }
      sum += vtkMath::Dot(normal, flat.data());
    }
    agreeing += sum >= 0.0 ? 1 : 0;
  }
  return 2 * agreeing >= mesh->GetNumberOfPolys();
}

// Triangles of files that know no shared points (STL) share them here; but points that differ in
// colour stay apart.
vtkSmartPointer<vtkPolyData> MakeSmooth(vtkPolyData* mesh)
{
  if (HasNormals(mesh))
  {
    return mesh;
  }
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(mesh);
  bare->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(bare);
  merged->SetPointMerging(!HasColours(mesh));
  merged->ConvertPolysToLinesOff();
  merged->ConvertLinesToPointsOff();
  merged->ConvertStripsToPolysOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(merged->GetOutputPort());
  normals->SetFeatureAngle(SmoothAngle);
  normals->ConsistencyOff();
  normals->AutoOrientNormalsOff();
  normals->Update();
  // Of a mesh in one point nothing is left.
  return normals->GetOutput()->GetNumberOfCells() > 0 ? normals->GetOutput() : mesh;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeLambertActor(
  vtkPolyData* mesh, const Vector3& albedo, Shading shading)
{
  vtkSmartPointer<vtkPolyData> shaded =
    shading == Shading::Flat ? MakeFlat(mesh) : MakeSmooth(mesh);
  if (shading == Shading::Curved)
  {
    shaded = MakeCurved(shaded);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shaded);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  property->SetDiffuseColor(albedo.data());
  return actor;
}

}
