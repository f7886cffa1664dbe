// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/LambertActor.h"

#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

namespace airlight
{

namespace
{
constexpr double SmoothAngle = 40.0; // degrees: sharper edges stay sharp

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

// Triangles of files that know no shared points (STL) share them here.
vtkSmartPointer<vtkPolyData> MakeSmooth(vtkPolyData* mesh)
{
  if (mesh->GetPointData()->GetNormals())
  {
    return mesh;
  }
  vtkNew<vtkCleanPolyData> merged;
  merged->SetInputData(mesh);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(merged->GetOutputPort());
  normals->SetFeatureAngle(SmoothAngle);
  normals->ConsistencyOff();
  normals->AutoOrientNormalsOff();
  normals->Update();
  return normals->GetOutput();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeLambertActor(
  vtkPolyData* mesh, const Vector3& albedo, Shading shading)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shading == Shading::Smooth ? MakeSmooth(mesh) : MakeFlat(mesh));
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
