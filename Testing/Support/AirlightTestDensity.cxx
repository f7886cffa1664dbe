// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestDensity.h"

#include "vtkFloatArray.h"
#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeDensity(
  const glm::ivec3& size, const glm::dvec3& low, const glm::dvec3& high)
{
  const glm::dvec3 spacing = (high - low) / glm::dvec3(size - 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.x, size.y, size.z);
  image->SetOrigin(&low.x);
  image->SetSpacing(&spacing.x);
  image->AllocateScalars(VTK_DOUBLE, 1);
  image->GetPointData()->GetScalars()->Fill(1.0);
  return image;
}

//------------------------------------------------------------------------------
void Rotate(vtkImageData* image, double aboutY, double aboutX)
{
  const double c = std::cos(aboutY);
  const double s = std::sin(aboutY);
  const double d = std::cos(aboutX);
  const double e = std::sin(aboutX);
  const double rows[3][3] = { { c, 0.0, s }, { e * s, d, -e * c }, { -d * s, e, d * c } };
  double middle[3];
  double moved[3];
  image->GetCenter(middle);
  for (int i = 0; i < 9; ++i)
  {
    image->GetDirectionMatrix()->SetElement(i / 3, i % 3, rows[i / 3][i % 3]);
  }
  double origin[3];
  image->GetOrigin(origin);
  image->GetCenter(moved);
  for (int i = 0; i < 3; ++i)
  {
    origin[i] += middle[i] - moved[i];
  }
  image->SetOrigin(origin);
}

//------------------------------------------------------------------------------
void FillCloud(vtkImageData* image, std::uint64_t seed)
{
  Random random(seed);
  struct Puff
  {
    glm::dvec3 Place; // as a share of the sides
    double Width;
    double Height;
  };
  std::vector<Puff> puffs;
  for (int i = 0; i < 12; ++i)
  {
    puffs.push_back(
      { { random.Uniform(0.25, 0.75), random.Uniform(0.3, 0.7), random.Uniform(0.25, 0.75) },
        random.Uniform(0.06, 0.14), random.Uniform(0.4, 1.6) });
  }
  int size[3];
  image->GetDimensions(size);
  auto* value = static_cast<double*>(image->GetScalarPointer());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const glm::dvec3 share =
          glm::dvec3(i, j, k) / glm::dvec3(size[0] - 1, size[1] - 1, size[2] - 1);
        double sum = 0.0;
        for (const Puff& puff : puffs)
        {
          const double r = glm::length(share - puff.Place) / puff.Width;
          sum += puff.Height * std::exp(-0.5 * r * r);
        }
        const glm::dvec3 off = 2.0 * share - 1.0; // from the middle
        const glm::dvec3 rim = 1.0 - off * off * off * off * off * off;
        *value++ = std::max(rim.x * rim.y * rim.z * sum - 0.01, 0.0);
      }
    }
  }
  image->Modified();
}

//------------------------------------------------------------------------------
void AddColours(vtkImageData* image, const char* name, double most, Random& random)
{
  vtkNew<vtkFloatArray> colours;
  colours->SetName(name);
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    colours->InsertNextTuple3(
      random.Uniform(0.0, most), random.Uniform(0.0, most), random.Uniform(0.0, most));
  }
  image->GetPointData()->AddArray(colours);
}

//------------------------------------------------------------------------------
// Relative errors of a buffer's pixels, those of less than a thousandth of the brightest against
// that. Where nothing is expected there must be nothing, and that does not count.
static Quantiles GetErrors(vtkImageData* drawn, vtkDataArray* expected)
{
  Quantiles result{ Infinity, Infinity };
  if (!Check(drawn && expected && drawn->GetNumberOfPoints() == expected->GetNumberOfTuples(),
        "both pictures are there"))
  {
    return result;
  }
  vtkDataArray* values = drawn->GetPointData()->GetScalars();
  const int components = expected->GetNumberOfComponents();
  double brightest = 0.0;
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    brightest = std::max(brightest, expected->GetComponent(i, 0));
  }
  std::vector<double> errors;
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    double error = 0.0;
    bool any = false;
    for (int c = 0; c < components; ++c)
    {
      any = any || expected->GetComponent(i, c) > 0.0 || !(values->GetComponent(i, c) < 1e-9);
      const double right = expected->GetComponent(i, c);
      const double off = std::abs(values->GetComponent(i, c) - right);
      error = std::max(error, off / std::max(right, 1e-3 * brightest));
      error = std::isnan(off) ? Infinity : error;
    }
    if (any)
    {
      errors.push_back(error);
    }
  }
  if (!Check(errors.size() > 100, "something is seen"))
  {
    return result;
  }
  std::sort(errors.begin(), errors.end());
  result.Median = errors[errors.size() / 2];
  result.P99 = errors[errors.size() * 99 / 100];
  return result;
}

//------------------------------------------------------------------------------
void CheckErrors(
  const std::string& name, vtkImageData* drawn, vtkDataArray* expected, double median, double p99)
{
  const Quantiles errors = GetErrors(drawn, expected);
  std::cout << "  " << name << ": median " << errors.Median << ", 99 % below " << errors.P99
            << std::endl;
  Check(errors.Median <= median, name + ": median error");
  Check(errors.P99 <= p99, name + ": 99 % of the errors");
}

//------------------------------------------------------------------------------
// The largest channel of a value, or of its difference from another one.
static double GetLargest(vtkDataArray* values, vtkIdType i, vtkDataArray* other = nullptr)
{
  double largest = 0.0;
  for (int c = 0; c < values->GetNumberOfComponents(); ++c)
  {
    const double value = values->GetComponent(i, c) - (other ? other->GetComponent(i, c) : 0.0);
    largest = std::isnan(value) ? Infinity : std::max(largest, std::abs(value));
  }
  return largest;
}

//------------------------------------------------------------------------------
void CheckErrorsOfMean(
  const std::string& name, vtkImageData* drawn, vtkDataArray* expected, double p99)
{
  vtkDataArray* values = drawn->GetPointData()->GetScalars();
  std::vector<double> errors;
  double sum = 0.0;
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    const double light = GetLargest(expected, i);
    const double error = GetLargest(values, i, expected);
    sum += light;
    if (light > 0.0 || error > 0.0)
    {
      errors.push_back(error);
    }
  }
  std::sort(errors.begin(), errors.end());
  const double count = static_cast<double>(errors.size());
  const double found = errors.empty() ? Infinity : errors[errors.size() * 99 / 100] * count / sum;
  std::cout << "  " << name << ": 99 % of the errors are below " << found << " of the mean"
            << std::endl;
  Check(found <= p99, name + ": 99 % of the errors beside the mean");
}

//------------------------------------------------------------------------------
void CheckBound(
  const std::string& name, vtkImageData* drawn, vtkImageData* bound, vtkDataArray* expected)
{
  vtkDataArray* values = drawn->GetPointData()->GetScalars();
  std::vector<double> shares;
  for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
  {
    const double off = GetLargest(expected, i, values);
    const double limit = bound->GetPointData()->GetScalars()->GetComponent(i, 0);
    if (off > 0.0)
    {
      shares.push_back(off / limit);
    }
  }
  std::sort(shares.begin(), shares.end());
  const double p99 = shares.empty() ? Infinity : shares[shares.size() * 99 / 100];
  std::cout << "  " << name << ": 99 % of the errors are below " << p99 << " of their bound"
            << std::endl;
  Check(p99 <= 1.0, name + ": errors are within their bound");
  Check(p99 > 1e-3, name + ": the bound is not idly large");
}
}
