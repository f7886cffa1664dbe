// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances that programs of their own draw are to the last bit those of the mappers' programs, whatever
// the mapper draws; and where there is no such program, the mapper's own draws them.

#include "AirlightTestDistances.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkTexture.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Vertices, lines, triangles and strips, each drawn on its own.
vtkSmartPointer<vtkPolyData> MakeAllKinds()
{
  const double corners[8][3] = { { -2, -2, 0 }, { 0, -2, 0 }, { -2, 0, 0 }, { 0, 0, 1 },
    { 0.5, 0.5, 0 }, { 2, 2, 1 }, { 2, -2, 0 }, { 2, -1, 0 } };
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  const vtkIdType vertices[2] = { 6, 7 };
  const vtkIdType line[2] = { 4, 5 };
  const vtkIdType triangle[3] = { 0, 1, 2 };
  const vtkIdType strip[4] = { 1, 2, 3, 4 };
  const auto cells = [](vtkIdType count, const vtkIdType* ids) {
    vtkNew<vtkCellArray> array;
    array->InsertNextCell(count, ids);
    return vtkSmartPointer<vtkCellArray>(array);
  };
  data->SetPoints(points);
  data->SetVerts(cells(2, vertices));
  data->SetLines(cells(2, line));
  data->SetPolys(cells(3, triangle));
  data->SetStrips(cells(4, strip));
  return data;
}

void SetTexture(vtkActor* actor)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  image->GetPointData()->GetScalars()->Fill(255.0);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  actor->SetTexture(texture);
}

//------------------------------------------------------------------------------
void TestData()
{
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  vtkSmartPointer<vtkPolyData> bare = MakeSphere(2.0);
  bare->GetPointData()->SetNormals(nullptr);
  vtkNew<vtkFloatArray> heights;
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(static_cast<float>(ball->GetPoint(i)[1]));
  }
  vtkSmartPointer<vtkPolyData> coloured = MakeSphere(2.0);
  coloured->GetPointData()->SetScalars(heights);
  vtkSmartPointer<vtkPolyData> cells = MakeSphere(2.0);
  vtkNew<vtkFloatArray> numbers;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<float>(i));
  }
  cells->GetCellData()->SetScalars(numbers);
  const Change none = [](vtkActor*, vtkPolyDataMapper*) {};
  const Change colours = [](vtkActor* actor, vtkPolyDataMapper* mapper) {
    mapper->ScalarVisibilityOn();
    mapper->SetScalarRange(-2.0, 200.0);
    actor->GetProperty()->SetInterpolationToGouraud();
  };
  CompareDistances("a ball", ball, 1, none);
  CompareDistances("without normals", bare, 1, none);
  CompareDistances("smooth", ball, 1,
    [](vtkActor* actor, vtkPolyDataMapper*) { actor->GetProperty()->SetInterpolationToPhong(); });
  CompareDistances("colours of points", coloured, 1, colours);
  CompareDistances("colours of cells", cells, 1, colours);
  CompareDistances(
    "all kinds of cells", MakeAllKinds(), 4, [](vtkActor* actor, vtkPolyDataMapper*) {
      actor->GetProperty()->SetPointSize(9.0);
      actor->GetProperty()->SetLineWidth(3.0);
    });
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.0, -2.0, 0.0);
  plane->SetPoint1(2.0, -2.0, 0.0);
  plane->SetPoint2(-2.0, 2.0, 0.0);
  // A texel may be transparent, where the mapper's program discards the fragment.
  CompareDistances(
    "a texture", Make(plane), 0, [](vtkActor* actor, vtkPolyDataMapper*) { SetTexture(actor); });
}

//------------------------------------------------------------------------------
void TestProperties()
{
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  CompareDistances("a wireframe", ball, 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetRepresentationToWireframe();
  });
  CompareDistances("wide lines", ball, 0, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetRepresentationToWireframe();
    actor->GetProperty()->SetRenderLinesAsTubes(true);
    actor->GetProperty()->SetLineWidth(4.0);
  });
  CompareDistances("points", ball, 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetRepresentationToPoints();
    actor->GetProperty()->SetPointSize(4.0);
  });
  CompareDistances("gleams", ball, 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->GetProperty()->SetSpecular(0.5);
    actor->GetProperty()->SetInterpolationToPBR();
  });
  CompareDistances("a clipping plane", ball, 0, [](vtkActor*, vtkPolyDataMapper* mapper) {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.2, 0.0);
    mapper->AddClippingPlane(plane);
  });
  // There the mapper keeps corners relative to another place.
  vtkNew<vtkSphereSource> far;
  far->SetCenter(1000.0, 0.0, 0.0);
  far->SetRadius(2.0);
  CompareDistances("far from the origin", Make(far), 1, [](vtkActor* actor, vtkPolyDataMapper*) {
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->SetPosition(-1000.0, 0.0, 0.0);
  });
}
}

//------------------------------------------------------------------------------
int TestDepthPrePass(int, char*[])
{
  TestData();
  TestProperties();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
