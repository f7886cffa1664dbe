// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightDensityImage with bad input: one error that names the value, and an empty image.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"

#include "vtkAirlightDensityImage.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void CheckTold(ErrorListener& errors, const std::string& word)
{
  const int count = errors.Take();
  Check(count == 1, Text("\"", word, "\" is one message, not ", count));
  Check(errors.GetText().find(word) != std::string::npos,
    Text("\"", errors.GetText(), "\" names \"", word, "\""));
}

vtkSmartPointer<vtkImageData> MakeImage(int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, 3);
  image->AllocateScalars(VTK_DOUBLE, components);
  vtkDataArray* array = image->GetPointData()->GetScalars();
  array->SetName("soot");
  for (int c = 0; c < components; ++c)
  {
    array->FillComponent(c, 1.0);
  }
  return image;
}

// The filter's error on this input has the word in it; none is left with a good image.
void CheckInput(vtkAirlightDensityImage* filter, vtkDataObject* input, const std::string& word)
{
  ErrorListener errors(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  CheckTold(errors, word);
  Check(filter->GetOutput()->GetNumberOfPoints() == 0, word + ": an empty image");
}

//------------------------------------------------------------------------------
void TestValues()
{
  vtkNew<vtkAirlightDensityImage> filter;
  for (double value : { nan, -0.5, infinity })
  {
    const vtkSmartPointer<vtkImageData> image = MakeImage(1);
    image->GetPointData()->GetScalars()->SetComponent(5, 0, value);
    CheckInput(filter, image, Text("the value ", value, " at point 5 of its array 'soot'"));
    filter->SetDimensions(4, 4, 4);
    CheckInput(filter, image, Text("the value ", value, " at point 5"));
    filter->SetDimensions(0, 0, 0);
  }
  filter->SetInputDataObject(MakeImage(1));
  ErrorListener errors(filter);
  filter->Update();
  Check(errors.Take() == 0 && filter->GetOutput()->GetNumberOfPoints() == 27, "well again");
}

//------------------------------------------------------------------------------
void TestArrays()
{
  vtkNew<vtkAirlightDensityImage> filter;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 3);
  CheckInput(filter, bare, "no active scalars");
  const vtkSmartPointer<vtkImageData> image = MakeImage(3);
  CheckInput(filter, image, "3 components in its array 'soot' and one is needed");
  filter->SetComponent(3);
  CheckInput(filter, image, "component 3 was chosen");
  filter->SetComponentName("smoke");
  CheckInput(filter, image, "none of them is named 'smoke'");
  filter->SetArrayName("dust");
  CheckInput(filter, image, "no array 'dust' of points or cells; there are 'soot' (points, 3)");
}

//------------------------------------------------------------------------------
void TestShapes()
{
  vtkNew<vtkAirlightDensityImage> filter;
  CheckInput(filter, vtkSmartPointer<vtkUnstructuredGrid>::New(), "no cells");
  CheckInput(filter, vtkSmartPointer<vtkMultiBlockDataSet>::New(), "no cells");
  vtkNew<vtkUnstructuredGrid> flat;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  flat->SetPoints(points);
  const vtkIdType ids[3] = { 0, 1, 2 };
  flat->InsertNextCell(VTK_TRIANGLE, 3, ids);
  vtkNew<vtkDoubleArray> ones;
  ones->SetNumberOfValues(3);
  ones->Fill(1.0);
  flat->GetPointData()->SetScalars(ones);
  CheckInput(filter, flat, "is 1 x 1 x 0 large");
}

//------------------------------------------------------------------------------
void TestSettings()
{
  vtkNew<vtkAirlightDensityImage> filter;
  ErrorListener errors(filter);
  for (double value : { 0.0, -1.0, nan, infinity })
  {
    filter->SetFactor(value);
    CheckTold(errors, Text("Factor ", value, " must be finite and above 0"));
  }
  filter->SetDimensions(1, 4, 4);
  CheckTold(errors, "Dimensions (1, 4, 4) must all be from 2 to 4096");
  filter->SetDimensions(0, 4, 5000);
  CheckTold(errors, "Dimensions (0, 4, 5000)");
  Check(filter->GetFactor() == 1.0 && filter->GetDimensions()[2] == 0, "defaults stay");
}
}

//------------------------------------------------------------------------------
int TestAirlightDensityImageErrors(int, char*[])
{
  TestValues();
  TestArrays();
  TestShapes();
  TestSettings();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
