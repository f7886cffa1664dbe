// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/AirlightImageMetrics.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace airlight
{

namespace
{
constexpr double Tiny = 1e-30; // keeps divisions by a black reference finite

// The p-th percentile with linear interpolation between the two nearest values.
double Percentile(std::vector<double> values, double p)
{
  std::sort(values.begin(), values.end());
  const double rank = p / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (values[above] - values[below]) * (rank - static_cast<double>(below));
}

double Mean(const std::vector<double>& values, std::size_t count)
{
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
  return std::accumulate(values.begin(), end, 0.0) / static_cast<double>(count);
}

int CountChannels(vtkImageData* image)
{
  return image->GetPointData()->GetScalars()->GetNumberOfComponents();
}

std::string DescribeSize(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  return std::to_string(size[0]) + "x" + std::to_string(size[1]) +
    (size[2] > 1 ? "x" + std::to_string(size[2]) : "") + " pixels of " +
    std::to_string(CountChannels(image)) + " channels";
}

bool HaveSameSize(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetDimensions(), a->GetDimensions() + 3, b->GetDimensions());
}

void CheckScalars(vtkImageData* image, const char* name)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    throw std::runtime_error(std::string(name) + " has no point scalars");
  }
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::runtime_error(std::string(name) + " has " +
      std::to_string(scalars->GetNumberOfTuples()) + " scalars for " +
      std::to_string(image->GetNumberOfPoints()) + " points");
  }
}

void CheckImages(vtkImageData* image, vtkImageData* reference, vtkImageData* mask)
{
  CheckScalars(image, "the image");
  CheckScalars(reference, "the reference");
  if (!HaveSameSize(image, reference) || CountChannels(image) != CountChannels(reference))
  {
    throw std::runtime_error(
      "the images differ in size: " + DescribeSize(image) + " and " + DescribeSize(reference));
  }
  if (mask)
  {
    CheckScalars(mask, "the mask");
    if (!HaveSameSize(image, mask))
    {
      throw std::runtime_error(
        "the mask differs in size: " + DescribeSize(image) + " and " + DescribeSize(mask));
    }
  }
}

std::size_t CountNonFinite(const std::vector<double>& pixel)
{
  return static_cast<std::size_t>(
    std::count_if(pixel.begin(), pixel.end(), [](double value) { return !std::isfinite(value); }));
}

struct Samples
{
  std::size_t Channels = 1;
  std::vector<double> A;
  std::vector<double> B;
  long long NonFinite = 0;
};

[[noreturn]] void FailNonFinite(vtkImageData* image, vtkIdType pixel, const std::string& name)
{
  const int* size = image->GetDimensions();
  throw std::runtime_error(name + " is not finite at pixel (" + std::to_string(pixel % size[0]) +
    ", " + std::to_string(pixel / size[0] % size[1]) +
    (size[2] > 1 ? ", " + std::to_string(pixel / size[0] / size[1]) : "") + ")");
}

// The samples that count, in the order of the pixels.
Samples GatherSamples(vtkImageData* image, vtkImageData* reference, vtkImageData* mask,
  bool skipNonFinite, std::vector<bool>& counts)
{
  Samples samples;
  vtkDataArray* a = image->GetPointData()->GetScalars();
  vtkDataArray* b = reference->GetPointData()->GetScalars();
  samples.Channels = static_cast<std::size_t>(a->GetNumberOfComponents());
  std::vector<double> pixelA(samples.Channels);
  std::vector<double> pixelB(samples.Channels);
  counts.assign(static_cast<std::size_t>(a->GetNumberOfTuples()), false);
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    a->GetTuple(i, pixelA.data());
    b->GetTuple(i, pixelB.data());
    const std::size_t bad = CountNonFinite(pixelA);
    samples.NonFinite += static_cast<long long>(bad);
    if ((bad > 0 && skipNonFinite) ||
      (mask && !(mask->GetPointData()->GetScalars()->GetComponent(i, 0) > 0.5)))
    {
      continue;
    }
    if (bad > 0)
    {
      FailNonFinite(image, i, "the image");
    }
    if (CountNonFinite(pixelB) > 0)
    {
      FailNonFinite(reference, i, "the reference");
    }
    counts[static_cast<std::size_t>(i)] = true;
    samples.A.insert(samples.A.end(), pixelA.begin(), pixelA.end());
    samples.B.insert(samples.B.end(), pixelB.begin(), pixelB.end());
  }
  if (samples.A.empty())
  {
    throw std::runtime_error("no pixels to compare: all are masked or not finite");
  }
  return samples;
}

void CompareAll(const Samples& samples, ImageMetrics& metrics)
{
  const std::size_t channels = samples.Channels;
  const std::size_t count = samples.A.size();
  const double eps = 1e-2 * Mean(samples.B, count) + Tiny;
  std::vector<double> errors(count / channels, 0.0);
  double ab = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double a = samples.A[i];
    const double b = samples.B[i];
    errors[i / channels] += (a - b) * (a - b) / (b * b + eps * eps) / static_cast<double>(channels);
    ab += a * b;
    bb += b * b;
  }
  std::sort(errors.begin(), errors.end());
  const auto kept = static_cast<std::size_t>(static_cast<double>(errors.size()) * 0.999);
  metrics.RelMSE = Mean(errors, errors.size());
  metrics.RelMSETrim = Mean(errors, std::max<std::size_t>(1, kept));
  metrics.Fit = ab / std::max(bb, Tiny);
  metrics.Pixels = static_cast<long long>(errors.size());
  metrics.NonFinite = samples.NonFinite;
}

void CompareLit(const Samples& samples, ImageMetrics& metrics)
{
  const double floor = 1e-3 * Percentile(samples.B, 99.0) + Tiny;
  std::vector<double> errors;
  std::vector<double> signedErrors;
  double difference = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < samples.A.size(); ++i)
  {
    const double a = samples.A[i];
    const double b = samples.B[i];
    if (!(b > floor))
    {
      metrics.DarkMaxAbs = std::max(metrics.DarkMaxAbs, std::abs(a - b));
      continue;
    }
    signedErrors.push_back((a - b) / std::max(std::abs(b), floor));
    errors.push_back(std::abs(signedErrors.back()));
    difference += a - b;
    total += b;
  }
  metrics.LitFraction = static_cast<double>(errors.size()) / static_cast<double>(samples.A.size());
  metrics.Bias = difference / std::max(total, Tiny);
  if (!errors.empty())
  {
    metrics.Median = Percentile(errors, 50.0);
    metrics.P95 = Percentile(errors, 95.0);
    metrics.P99 = Percentile(errors, 99.0);
    metrics.Max = *std::max_element(errors.begin(), errors.end());
    metrics.MedianSigned = Percentile(signedErrors, 50.0);
  }
}

double GetPSNR(const Samples& samples)
{
  double squares = 0.0;
  for (std::size_t i = 0; i < samples.A.size(); ++i)
  {
    squares += (samples.A[i] - samples.B[i]) * (samples.A[i] - samples.B[i]);
  }
  const double peak = *std::max_element(samples.B.begin(), samples.B.end());
  const double mean = squares / static_cast<double>(samples.A.size());
  return squares > 0.0 ? 10.0 * std::log10(peak * peak / mean)
                       : std::numeric_limits<double>::infinity();
}
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::variant<double, long long>>> ImageMetrics::GetNamed() const
{
  return { { "relMSE", this->RelMSE }, { "relMSE_trim", this->RelMSETrim },
    { "median", this->Median }, { "p95", this->P95 }, { "p99", this->P99 }, { "max", this->Max },
    { "dark_max_abs", this->DarkMaxAbs }, { "bias", this->Bias },
    { "median_signed", this->MedianSigned }, { "fit", this->Fit },
    { "lit_frac", this->LitFraction }, { "pixels", this->Pixels }, { "nonfinite", this->NonFinite },
    { "PSNR", this->PSNR } };
}

//------------------------------------------------------------------------------
ImageMetrics CompareImages(vtkImageData* image, vtkImageData* reference, vtkImageData* mask,
  bool skipNonFinite, std::vector<bool>& counts)
{
  CheckImages(image, reference, mask);
  const Samples samples = GatherSamples(image, reference, mask, skipNonFinite, counts);
  ImageMetrics metrics;
  CompareAll(samples, metrics);
  CompareLit(samples, metrics);
  metrics.PSNR = GetPSNR(samples);
  return metrics;
}

}
