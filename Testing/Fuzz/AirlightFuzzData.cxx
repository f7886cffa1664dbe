// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightFuzzData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace airlight_fuzz
{
namespace
{
vtkSmartPointer<vtkPoints> MakePoints(Input& input)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(input.Flag() ? VTK_DOUBLE : VTK_FLOAT);
  for (int count = input.Integer(0, 12); count > 0; --count)
  {
    points->InsertNextPoint(input.Point().data());
  }
  return points;
}

vtkSmartPointer<vtkCellArray> MakeCells(Input& input, int points, int shortest, int longest)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int count = points > 0 ? input.Integer(0, 8) : 0; count > 0; --count)
  {
    const int size = input.Integer(shortest, longest);
    cells->InsertNextCell(size);
    for (int i = 0; i < size; ++i)
    {
      cells->InsertCellPoint(input.Integer(0, points - 1));
    }
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> MakeBox(Input& input)
{
  vtkNew<vtkCubeSource> box;
  box->SetOutputPointsPrecision(input.Flag() ? 1 : 0);
  box->SetCenter(input.ModestVector().data());
  box->SetXLength(0.5 * input.Integer(0, 8));
  box->SetYLength(0.5 * input.Integer(0, 8));
  box->SetZLength(0.5 * input.Integer(0, 8));
  box->Update();
  return box->GetOutput();
}

void RequireFiniteArrays(vtkFieldData* data, const char* name)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    for (vtkIdType k = 0; array && k < array->GetNumberOfTuples(); ++k)
    {
      RequireFinite(array->GetTuple(k), array->GetNumberOfComponents(), name);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMesh(Input& input)
{
  if (input.Integer(0, 3) == 3)
  {
    return MakeBox(input);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  const auto points = MakePoints(input);
  const int count = static_cast<int>(points->GetNumberOfPoints());
  mesh->SetPoints(points);
  mesh->SetPolys(MakeCells(input, count, input.Flag() ? 3 : 0, 5));
  if (input.Integer(0, 3) == 3)
  {
    mesh->SetStrips(MakeCells(input, count, 0, 6));
    mesh->SetLines(MakeCells(input, count, 0, 4));
    mesh->SetVerts(MakeCells(input, count, 0, 2));
  }
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeLines(Input& input)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  const auto points = MakePoints(input);
  lines->SetPoints(points);
  lines->SetLines(MakeCells(input, static_cast<int>(points->GetNumberOfPoints()), 0, 4));
  return lines;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeTable(Input& input)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const int rows = input.Integer(0, 6);
  const bool good = input.Flag();
  for (int column = 0; column < (good ? 2 : input.Integer(0, 3)); ++column)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(column == 0 ? "angle" : "value");
    for (int row = 0; row < rows; ++row)
    {
      const double angle = 180.0 * row / (rows > 1 ? rows - 1 : 1);
      const double value = column == 0 ? angle : input.Integer(1, 255);
      values->InsertNextValue(good ? value : input.Number());
    }
    table->AddColumn(values);
  }
  return table;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeImage(Input& input)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int low = input.Integer(-1, 1);
  const bool good = input.Flag();
  image->SetExtent(low, low + input.Integer(0, 3), 0, input.Integer(-1, 3), 0, input.Integer(0, 3));
  image->SetOrigin(good ? input.ModestVector().data() : input.Numbers().data());
  image->SetSpacing(good ? Vector{ 1.0, 0.5, 2.0 }.data() : input.Numbers().data());
  if (input.Flag())
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName("density");
    values->SetNumberOfComponents(good ? 1 : input.Integer(1, 3));
    values->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      values->SetValue(i, good ? input.Integer(0, 4) : input.Number());
    }
    image->GetPointData()->SetScalars(values);
  }
  return image;
}

//------------------------------------------------------------------------------
void RequireFinite(vtkDataSet* data, const char* name)
{
  RequireFiniteArrays(data->GetPointData(), name);
  RequireFiniteArrays(data->GetCellData(), name);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    RequireFinite(data->GetPoint(i), 3, name);
  }
}
}
