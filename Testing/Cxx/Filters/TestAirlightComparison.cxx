// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics of images small enough to compute by hand, the difference image, and inputs that
// cannot be compared.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"

#include "vtkAirlightComparison.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace airlight_test;

namespace
{
using Image = vtkSmartPointer<vtkImageData>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A row of pixels.
Image MakeRow(const std::vector<double>& values, int channels = 1, int type = VTK_FLOAT)
{
  auto image = Image::New();
  image->SetDimensions(static_cast<int>(values.size()) / channels, 1, 1);
  image->AllocateScalars(type, channels);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i) / channels;
    const int channel = static_cast<int>(i) % channels;
    image->GetPointData()->GetScalars()->SetComponent(tuple, channel, values[i]);
  }
  return image;
}

double GetMetric(vtkAirlightComparison* comparison, const char* name)
{
  vtkDataArray* column =
    vtkDataArray::SafeDownCast(comparison->GetMetrics()->GetColumnByName(name));
  return column && column->GetNumberOfTuples() == 1 ? column->GetTuple1(0) : nan;
}

void CheckMetric(vtkAirlightComparison* comparison, const char* name, double expected)
{
  const double value = GetMetric(comparison, name);
  Check(value == expected || std::abs(value - expected) <= 1e-12 * std::abs(expected),
    Text(name, " is ", value, ", expected ", expected));
}

// a = 0.25 1.1 1.6 4.2, b = 0 1 2 4, in double precision. The 99th percentile of b is 2.97 steps up
// its order: 2 + 0.97 * 2 = 3.94, so floor = 0.00394 and the first pixel is dark. The mean of b is
// 1.75, so eps = 0.0175.
const std::vector<double> A = { 0.25, 1.1, 1.6, 4.2 };
const std::vector<double> B = { 0.0, 1.0, 2.0, 4.0 };

void TestMetrics()
{
  vtkNew<vtkAirlightComparison> comparison;
  comparison->SetImageData(MakeRow(A, 1, VTK_DOUBLE));
  comparison->SetReferenceData(MakeRow(B, 1, VTK_DOUBLE));
  comparison->Update();
  const double e2 = 0.0175 * 0.0175;
  const double squares[4] = { 0.0625 / e2, 0.1 * 0.1 / (1.0 + e2), 0.4 * 0.4 / (4.0 + e2),
    0.2 * 0.2 / (16.0 + e2) };
  const double kept =
    (1.1 - 1.0) * (1.1 - 1.0) / (1.0 + e2) + squares[2] + (4.2 - 4.0) * (4.2 - 4.0) / (16.0 + e2);
  CheckMetric(comparison, "relMSE", (squares[0] + kept) / 4.0);
  CheckMetric(comparison, "relMSE_trim", kept / 3.0); // 0.999 of 4 pixels are 3 whole ones
  // Relative errors of lit pixels in their order: 0.05 0.1 0.2; with signs -0.2 0.05 0.1.
  CheckMetric(comparison, "median", 1.1 - 1.0);
  CheckMetric(comparison, "p95", 0.1 + 0.9 * 0.1);
  CheckMetric(comparison, "p99", 0.1 + 0.98 * 0.1);
  CheckMetric(comparison, "max", 0.2);
  CheckMetric(comparison, "median_signed", (4.2 - 4.0) / 4.0);
  CheckMetric(comparison, "dark_max_abs", 0.25);
  CheckMetric(comparison, "bias", (1.1 + 1.6 + 4.2 - 7.0) / 7.0);
  CheckMetric(comparison, "fit", (1.1 + 3.2 + 16.8) / 21.0);
  CheckMetric(comparison, "lit_frac", 0.75);
  CheckMetric(comparison, "pixels", 4.0);
  CheckMetric(comparison, "nonfinite", 0.0);
  CheckMetric(comparison, "PSNR", 10.0 * std::log10(16.0 / ((0.0625 + 0.01 + 0.16 + 0.04) / 4.0)));
  Check(comparison->GetMetrics()->GetNumberOfRows() == 1, "one row");
}

//------------------------------------------------------------------------------
// Inputs below 8 are rounded to floats by up to half of 2^-21, which is 2.4e-7.
void CheckDifference(vtkAirlightComparison* comparison, const std::vector<double>& expected)
{
  vtkDataArray* values = comparison->GetDifference()->GetPointData()->GetScalars();
  const auto count = static_cast<std::size_t>(values ? values->GetNumberOfValues() : 0);
  bool same = count == expected.size();
  for (std::size_t i = 0; same && i < count; ++i)
  {
    const int channels = values->GetNumberOfComponents();
    const auto tuple = static_cast<vtkIdType>(i) / channels;
    same = std::abs(values->GetComponent(tuple, static_cast<int>(i) % channels) - expected[i]) <=
      0x1p-22;
  }
  Check(same, "the difference image");
}

void TestDifference()
{
  vtkNew<vtkAirlightComparison> comparison;
  const Image a = MakeRow(A);
  a->SetSpacing(0.5, 2.0, 1.0);
  a->SetOrigin(3.0, 0.0, 0.0);
  comparison->SetImageData(a);
  comparison->SetReferenceData(MakeRow(B));
  comparison->Update();
  CheckDifference(comparison, { 0.25, 0.1, -0.4, 0.2 });
  vtkImageData* difference = comparison->GetDifference();
  Check(difference->GetScalarType() == VTK_FLOAT && difference->GetSpacing()[0] == 0.5 &&
      difference->GetOrigin()[0] == 3.0,
    "the difference has the image's type and place");

  // Without the first and the last pixel: two lit ones.
  const Image mask = MakeRow({ 0.0, 1.0, 0.6, 0.5 });
  comparison->SetMaskData(mask);
  comparison->Update();
  CheckDifference(comparison, { 0.0, 0.1, -0.4, 0.0 });
  CheckMetric(comparison, "pixels", 2.0);
  CheckMetric(comparison, "lit_frac", 1.0);
  CheckMetric(comparison, "dark_max_abs", 0.0);

  // Bytes, and back to no mask.
  comparison->SetMaskData(nullptr);
  comparison->SetImageData(MakeRow({ 10, 20, 255, 0 }, 2, VTK_UNSIGNED_CHAR));
  comparison->SetReferenceData(MakeRow({ 20, 10, 0, 255 }, 2, VTK_UNSIGNED_CHAR));
  comparison->Update();
  CheckDifference(comparison, { -10.0, 10.0, 255.0, -255.0 });
  CheckMetric(comparison, "pixels", 2.0);

  // The same images; a black reference.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  comparison->SetImageData(MakeRow(B));
  comparison->SetReferenceData(MakeRow(B));
  comparison->Update();
  CheckMetric(comparison, "PSNR", infinity);
  CheckMetric(comparison, "relMSE", 0.0);
  comparison->SetReferenceData(MakeRow({ 0, 0, 0, 0 }));
  comparison->Update();
  CheckMetric(comparison, "PSNR", -infinity);
  CheckMetric(comparison, "dark_max_abs", 4.0);
  CheckMetric(comparison, "median", 0.0);
}

// A connection, and an image of other extents behind it.
void TestConnections()
{
  vtkNew<vtkTrivialProducer> a;
  vtkNew<vtkTrivialProducer> b;
  const Image shifted = MakeRow(B);
  shifted->SetExtent(5, 8, 2, 2, 0, 0);
  shifted->AllocateScalars(VTK_FLOAT, 1);
  shifted->GetPointData()->GetScalars()->DeepCopy(MakeRow(B)->GetPointData()->GetScalars());
  a->SetOutput(MakeRow(A));
  b->SetOutput(shifted);
  vtkNew<vtkAirlightComparison> comparison;
  comparison->SetInputConnection(0, a->GetOutputPort());
  comparison->SetInputConnection(1, b->GetOutputPort());
  ErrorListener errors(comparison);
  comparison->Update(1);
  Check(errors.Take() == 0, "extents that differ are compared: " + errors.GetText());
  CheckMetric(comparison, "pixels", 4.0);
}

//------------------------------------------------------------------------------
void CheckRefused(const std::string& name, vtkImageData* a, vtkImageData* b, vtkImageData* mask,
  const std::vector<std::string>& words)
{
  vtkNew<vtkAirlightComparison> comparison;
  comparison->SetImageData(MakeRow(A));
  comparison->SetReferenceData(MakeRow(B));
  comparison->Update();
  ErrorListener errors(comparison);
  comparison->SetImageData(a);
  comparison->SetReferenceData(b);
  comparison->SetMaskData(mask);
  comparison->Update();
  Check(errors.Take() == 1, name + ": one error");
  for (const std::string& word : words)
  {
    Check(errors.GetText().find(word) != std::string::npos,
      name + ": says " + word + ": " + errors.GetText());
  }
  Check(comparison->GetMetrics()->GetNumberOfColumns() == 0, name + ": no table");
  Check(comparison->GetDifference()->GetNumberOfPoints() == 0, name + ": no difference");
}

void TestErrors()
{
  const Image a = MakeRow(A);
  const Image b = MakeRow(B);
  const Image broken = MakeRow({ 0.0, 1.0, nan, 4.0 });
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 1, 1);
  CheckRefused("sizes", a, MakeRow({ 1, 2, 3 }), nullptr,
    { "vtkAirlightComparison (0x", "differ in size", "4x1 pixels of 1 channels", "3x1" });
  CheckRefused("channels", a, MakeRow({ 1, 2, 3, 4, 5, 6, 7, 8 }, 2), nullptr,
    { "4x1 pixels of 1 channels", "4x1 pixels of 2 channels" });
  const auto tooFew = MakeRow({ 1, 2, 3, 4 });
  tooFew->GetPointData()->GetScalars()->SetNumberOfTuples(3);
  CheckRefused("scalars of another number", tooFew, b, nullptr, { "has 3 scalars for 4 points" });
  CheckRefused("no scalars", bare, b, nullptr, { "the image has no point scalars" });
  CheckRefused("no reference scalars", a, bare, nullptr, { "the reference has no point scalars" });
  CheckRefused("no mask scalars", a, b, bare, { "the mask has no point scalars" });
  CheckRefused("mask of another size", a, b, MakeRow({ 1, 2, 3 }), { "mask differs", "3x1" });
  CheckRefused("not a number", broken, b, nullptr, { "the image is not finite at pixel (2, 0)" });
  CheckRefused("reference", a, broken, nullptr, { "the reference is not finite at pixel (2, 0)" });
  CheckRefused("mask of nothing", a, b, MakeRow({ 0, 0, nan, 0.5 }), { "no pixels" });

  vtkNew<vtkAirlightComparison> comparison;
  ErrorListener errors(comparison);
  comparison->SkipNonFiniteOn();
  comparison->SetImageData(broken);
  comparison->SetReferenceData(b);
  comparison->Update();
  CheckMetric(comparison, "nonfinite", 1.0);
  CheckMetric(comparison, "pixels", 3.0);
  CheckDifference(comparison, { 0.0, 0.0, 0.0, 0.0 });
  comparison->SkipNonFiniteOff();
  comparison->SetMaskData(MakeRow({ 1, 1, 0, 1 }));
  comparison->Update();
  CheckMetric(comparison, "pixels", 3.0);
  Check(errors.Take() == 0, "skipped on request or by the mask: " + errors.GetText());
}
}

//------------------------------------------------------------------------------
int TestAirlightComparison(int, char*[])
{
  TestMetrics();
  TestDifference();
  TestConnections();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
