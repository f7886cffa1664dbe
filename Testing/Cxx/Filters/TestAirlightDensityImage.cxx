// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightDensityImage: fields that are linear in space, which interpolation keeps, on every
// kind of data set, of points and of cells; components; levels of AMR; no copy of an image.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"

#include "vtkAMRBox.h"
#include "vtkAirlightDensityImage.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUniformGrid.h"
#include "vtkUnstructuredGrid.h"

#include <glm/glm.hpp>

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
double Linear(const glm::dvec3& p) { return 2.0 + 0.5 * p.x + 0.25 * p.y - 0.125 * p.z; }

// An array of the function at the data's points, or in the middles of its cells.
vtkSmartPointer<vtkDoubleArray> Sample(
  vtkDataSet* data, bool cells, const std::function<double(const glm::dvec3&)>& function)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("soot");
  const vtkIdType count = cells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    glm::dvec3 p;
    if (cells)
    {
      double b[6];
      data->GetCellBounds(i, b);
      p = 0.5 * glm::dvec3(b[0] + b[1], b[2] + b[3], b[4] + b[5]);
    }
    else
    {
      data->GetPoint(i, &p.x);
    }
    array->InsertNextValue(function(p));
  }
  return array;
}

void AddLinear(vtkDataSet* data, bool cells)
{
  vtkDataSetAttributes* attributes = data->GetPointData();
  if (cells)
  {
    attributes = data->GetCellData();
  }
  attributes->AddArray(Sample(data, cells, Linear));
}

// Points from end to end of the box from 0 to (4, 3, 2), with the function's values but for `edge`
// from the faces; 1e-6 is the rounding of float.
void CheckOutput(vtkAirlightDensityImage* filter, const std::string& what, const glm::ivec3& size,
  double edge, const std::function<double(const glm::dvec3&)>& expected)
{
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  const int* found = image->GetDimensions();
  if (!Check(
        glm::ivec3(found[0], found[1], found[2]) == size && image->GetPointData()->GetScalars(),
        what + ": so many points"))
  {
    return;
  }
  Comparison comparison(what);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    image->GetPoint(i, &p.x);
    const glm::dvec3 inside = glm::min(p, glm::dvec3(4.0, 3.0, 2.0) - p);
    if (std::min({ inside.x, inside.y, inside.z }) >= edge)
    {
      const double value = image->GetPointData()->GetScalars()->GetComponent(i, 0);
      comparison.Add(std::abs(value - expected(p)), 2e-6,
        [&] { return Text("point ", i, ": ", value, ", expected ", expected(p)); });
    }
  }
  Check(comparison.Report(), what);
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 7, 5);
  image->SetSpacing(0.5, 0.5, 0.5);
  return image;
}

//------------------------------------------------------------------------------
void TestImages()
{
  const vtkSmartPointer<vtkImageData> image = MakeImage();
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(3.0);
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetInputData(image);
  filter->Update();
  Check(filter->GetOutput()->GetPointData()->GetScalars() == image->GetPointData()->GetScalars(),
    "bytes pass without a copy");
  filter->SetFactor(0.5);
  CheckOutput(filter, "factor", { 9, 7, 5 }, 0.0, [](const glm::dvec3&) { return 1.5; });
  for (bool cells : { false, true })
  {
    const vtkSmartPointer<vtkImageData> linear = MakeImage();
    AddLinear(linear, cells);
    vtkNew<vtkAirlightDensityImage> from;
    from->SetInputData(linear);
    from->SetArrayName("soot");
    // Averages of cells are off at the faces, where there are cells on one side only.
    CheckOutput(from, Text("image, cells ", cells), { 9, 7, 5 }, cells ? 0.4 : 0.0, Linear);
    from->SetDimensions(17, 13, 9);
    CheckOutput(
      from, Text("image resampled, cells ", cells), { 17, 13, 9 }, cells ? 0.6 : 0.01, Linear);
  }
}

//------------------------------------------------------------------------------
void TestComponents()
{
  const vtkSmartPointer<vtkImageData> image = MakeImage();
  image->AllocateScalars(VTK_FLOAT, 3);
  vtkDataArray* array = image->GetPointData()->GetScalars();
  array->SetName("gas");
  const char* names[] = { "fuel", "soot", "air" };
  for (int c = 0; c < 3; ++c)
  {
    array->SetComponentName(c, names[c]);
    array->FillComponent(c, c + 1.0);
  }
  array->FillComponent(0, -1.0); // one that is not chosen may be anything
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetInputData(image);
  filter->SetComponentName("soot");
  CheckOutput(filter, "component by name", { 9, 7, 5 }, 0.0, [](const glm::dvec3&) { return 2.0; });
  filter->SetComponentName("");
  filter->SetComponent(2);
  CheckOutput(
    filter, "component by number", { 9, 7, 5 }, 0.0, [](const glm::dvec3&) { return 3.0; });
}

//------------------------------------------------------------------------------
// Planes at uneven distances, from 0 to the length.
vtkSmartPointer<vtkDoubleArray> MakePlanes(int count, double length)
{
  auto planes = vtkSmartPointer<vtkDoubleArray>::New();
  for (int i = 0; i < count; ++i)
  {
    const double share = i / (count - 1.0);
    planes->InsertNextValue(length * share * (0.5 + 0.5 * share));
  }
  return planes;
}

void TestGrids()
{
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(7, 6, 5);
  rectilinear->SetXCoordinates(MakePlanes(7, 4.0));
  rectilinear->SetYCoordinates(MakePlanes(6, 3.0));
  rectilinear->SetZCoordinates(MakePlanes(5, 2.0));
  AddLinear(rectilinear, false);
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetArrayName("soot");
  filter->SetInputData(rectilinear);
  CheckOutput(filter, "rectilinear", { 64, 64, 64 }, 0.01, Linear);

  vtkNew<vtkUnstructuredGrid> unstructured; // one hexahedron
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::ivec3& c : { glm::ivec3(0, 0, 0), { 4, 0, 0 }, { 4, 3, 0 }, { 0, 3, 0 },
         { 0, 0, 2 }, { 4, 0, 2 }, { 4, 3, 2 }, { 0, 3, 2 } })
  {
    points->InsertNextPoint(c.x, c.y, c.z);
  }
  unstructured->SetPoints(points);
  const vtkIdType ids[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  unstructured->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  AddLinear(unstructured, false);
  filter->SetInputData(unstructured);
  filter->SetDimensions(9, 7, 5);
  CheckOutput(filter, "unstructured", { 9, 7, 5 }, 0.01, Linear);
}

//------------------------------------------------------------------------------
// Two halves, each a block.
void TestBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int half = 0; half < 2; ++half)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(5, 7, 5);
    image->SetSpacing(0.5, 0.5, 0.5);
    image->SetOrigin(2.0 * half, 0.0, 0.0);
    AddLinear(image, false);
    blocks->SetBlock(half, image);
  }
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetInputData(blocks);
  filter->SetArrayName("soot");
  filter->SetDimensions(17, 13, 9);
  CheckOutput(filter, "blocks", { 17, 13, 9 }, 0.01, Linear);
}

//------------------------------------------------------------------------------
// An array of three colours at points, or one for each cell, beside the density.
vtkSmartPointer<vtkRectilinearGrid> MakeColouredGrid(bool cells, int type)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(9, 7, 5);
  grid->SetXCoordinates(MakePlanes(9, 4.0));
  grid->SetYCoordinates(MakePlanes(7, 3.0));
  grid->SetZCoordinates(MakePlanes(5, 2.0));
  AddLinear(grid, cells);
  const auto colours = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  colours->SetName("colour");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(cells ? grid->GetNumberOfCells() : grid->GetNumberOfPoints());
  for (int c = 0; c < 3; ++c)
  {
    colours->FillComponent(c, 50.0 * (c + 1));
  }
  (cells ? static_cast<vtkDataSetAttributes*>(grid->GetCellData()) : grid->GetPointData())
    ->AddArray(colours);
  return grid;
}

void TestOtherArrays()
{
  for (bool cells : { false, true })
  {
    const std::string what = Text("other arrays, cells ", cells);
    const vtkSmartPointer<vtkRectilinearGrid> grid = MakeColouredGrid(cells, VTK_UNSIGNED_CHAR);
    const vtkSmartPointer<vtkDoubleArray> slope = Sample(grid, false, Linear);
    slope->SetName("slope");
    grid->GetPointData()->AddArray(slope);
    // Scalars are an array as any other.
    grid->GetPointData()->SetActiveScalars("slope");
    grid->GetCellData()->SetActiveScalars("colour");
    vtkNew<vtkAirlightDensityImage> filter;
    filter->SetInputData(grid);
    filter->SetArrayName("soot");
    filter->SetDimensions(9, 7, 5);
    filter->Update();
    Check(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 1, what + ": not by default");
    filter->PassArraysOn();
    filter->Update();
    if (!cells) // uneven: the mean of a point's cells is not the point's density
    {
      CheckOutput(filter, what, { 9, 7, 5 }, 0.01, Linear);
    }
    vtkPointData* found = filter->GetOutput()->GetPointData();
    vtkDataArray* colour = found->GetArray("colour");
    Check(found->GetNumberOfArrays() == 3 && found->GetScalars() != colour, what + ": three");
    if (!Check(colour && colour->GetDataType() == VTK_UNSIGNED_CHAR &&
            colour->GetNumberOfComponents() == 3 && found->GetArray("slope"),
          what + ": of the same type"))
    {
      continue;
    }
    double tuple[3];
    colour->GetTuple(filter->GetOutput()->FindPoint(2.0, 1.5, 1.0), tuple);
    Check(tuple[0] == 50.0 && tuple[1] == 100.0 && tuple[2] == 150.0, what + ": its values");
    double p[3];
    const vtkIdType inside = filter->GetOutput()->FindPoint(1.0, 1.0, 1.0);
    filter->GetOutput()->GetPoint(inside, p);
    const double difference =
      found->GetArray("slope")->GetTuple1(inside) - Linear({ p[0], p[1], p[2] });
    Check(std::abs(difference) < 1e-12, what + ": interpolated in double");
  }
}

// An image that is not sampled, whose scalars are its colours; arrays of cells come on demand.
void TestArraysOfImages()
{
  const vtkSmartPointer<vtkImageData> image = MakeImage();
  AddLinear(image, false);
  const vtkSmartPointer<vtkDoubleArray> steam = Sample(image, false, Linear);
  steam->SetName("steam");
  image->GetPointData()->SetScalars(steam);
  const vtkSmartPointer<vtkDoubleArray> heat = Sample(image, true, Linear);
  heat->SetName("heat");
  image->GetCellData()->SetScalars(heat);
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetInputData(image);
  filter->SetArrayName("soot");
  for (bool cells : { false, true })
  {
    filter->SetPassArrays(cells);
    CheckOutput(filter, Text("image with scalars, cells ", cells), { 9, 7, 5 }, 0.0, Linear);
    vtkPointData* found = filter->GetOutput()->GetPointData();
    Check(found->GetArray("steam") == steam, "the scalars of an image pass");
    Check(found->HasArray("heat") == cells && !found->HasArray("Density"),
      Text("arrays of cells, asked for: ", cells));
  }
}

// An array of bytes in one block and of doubles in the other, and one that only one has.
void TestArraysOfBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeColouredGrid(false, VTK_UNSIGNED_CHAR));
  const vtkSmartPointer<vtkRectilinearGrid> second = MakeColouredGrid(false, VTK_UNSIGNED_CHAR);
  second->GetPointData()->GetArray("colour")->SetName("other");
  second->SetXCoordinates(MakePlanes(9, 2.0)); // covers half of the first one
  blocks->SetBlock(1, second);
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetInputData(blocks);
  filter->SetArrayName("soot");
  filter->SetDimensions(9, 7, 5);
  filter->PassArraysOn();
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  const vtkIdType places[] = { image->FindPoint(1.0, 1.0, 1.0), image->FindPoint(3.0, 1.0, 1.0) };
  vtkDataArray* other = image->GetPointData()->GetArray("other");
  Check(image->GetPointData()->GetArray("colour")->GetComponent(places[0], 0) == 0.0,
    "an array that the covering block lacks is 0 there");
  Check(
    other && other->GetComponent(places[0], 0) == 50.0 && other->GetComponent(places[1], 0) == 0.0,
    "an array of one block is 0 in the other");
  blocks->SetBlock(1, MakeColouredGrid(false, VTK_DOUBLE));
  ErrorListener errors(filter);
  filter->Modified();
  filter->Update();
  Check(errors.Take() == 1 &&
      errors.GetText().find("arrays 'colour' of several types") != std::string::npos &&
      filter->GetOutput()->GetNumberOfPoints() == 0,
    "arrays of several types: one error");
}

//------------------------------------------------------------------------------
// A coarse level of density 1 in the box from 0 to (4, 3, 2), and a finer one of density 3 in a
// part of it.
void TestLevels()
{
  const int counts[] = { 1, 1 };
  vtkNew<vtkOverlappingAMR> levels;
  levels->Initialize(2, counts);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  levels->SetOrigin(origin);
  levels->SetGridDescription(VTK_XYZ_GRID);
  for (int level = 0; level < 2; ++level)
  {
    const double h = level == 0 ? 0.5 : 0.25;
    const int dimensions[3] = { 9, level == 0 ? 7 : 9, level == 0 ? 5 : 9 };
    const double corner[3] = { level * 1.0, level * 0.5, 0.0 };
    const double spacing[3] = { h, h, h };
    vtkNew<vtkUniformGrid> grid;
    grid->SetOrigin(corner);
    grid->SetSpacing(spacing);
    grid->SetDimensions(dimensions);
    vtkSmartPointer<vtkDoubleArray> density =
      Sample(grid, true, [level](const glm::dvec3&) { return 1.0 + 2.0 * level; });
    grid->GetCellData()->AddArray(density);
    levels->SetSpacing(level, spacing);
    levels->SetAMRBox(level, 0, vtkAMRBox(corner, dimensions, spacing, origin, VTK_XYZ_GRID));
    levels->SetDataSet(level, 0, grid);
  }
  levels->SetRefinementRatio(0, 2);
  levels->GenerateParentChildInformation();
  vtkNew<vtkAirlightDensityImage> filter;
  filter->SetInputData(levels);
  filter->SetArrayName("soot");
  filter->SetDimensions(21, 16, 11); // none of them on a face of the fine level, but that of z = 0
  CheckOutput(filter, "levels", { 21, 16, 11 }, 0.01, [](const glm::dvec3& p) {
    const bool fine = p.x > 0.99 && p.x < 3.01 && p.y > 0.49 && p.y < 2.51;
    return fine ? 3.0 : 1.0;
  });
}
}

//------------------------------------------------------------------------------
int TestAirlightDensityImage(int, char*[])
{
  TestImages();
  TestComponents();
  TestGrids();
  TestBlocks();
  TestOtherArrays();
  TestArraysOfImages();
  TestArraysOfBlocks();
  TestLevels();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
