// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageMetrics.h"

#include "UserError.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace airlight
{

namespace
{
constexpr double Tiny = 1e-30; // keeps divisions by a black reference finite

// The p-th percentile with linear interpolation between the two nearest values.
double Percentile(std::vector<double> values, double p)
{
  std::sort(values.begin(), values.end());
  const double place = p / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (values[above] - values[below]) * (place - static_cast<double>(below));
}

double Mean(const std::vector<double>& values, std::size_t count)
{
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
  return std::accumulate(values.begin(), end, 0.0) / static_cast<double>(count);
}

std::string DescribeSize(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  return std::to_string(size[0]) + "x" + std::to_string(size[1]) + " pixels of " +
    std::to_string(image->GetNumberOfScalarComponents()) + " channels";
}

bool HaveSameSize(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetDimensions(), a->GetDimensions() + 2, b->GetDimensions());
}

struct Samples
{
  int Channels = 1;
  std::vector<double> A;
  std::vector<double> B;
  long long NonFinite = 0;
};

// The samples that count, in the order of the pixels.
Samples GatherSamples(vtkImageData* picture, vtkImageData* reference, vtkImageData* mask)
{
  Samples samples;
  samples.Channels = picture->GetNumberOfScalarComponents();
  const auto channels = static_cast<std::size_t>(samples.Channels);
  const auto maskChannels =
    static_cast<std::size_t>(mask ? mask->GetNumberOfScalarComponents() : 0);
  const auto* a = static_cast<const float*>(picture->GetScalarPointer());
  const auto* b = static_cast<const float*>(reference->GetScalarPointer());
  const auto* m = mask ? static_cast<const float*>(mask->GetScalarPointer()) : nullptr;
  const auto pixels = static_cast<std::size_t>(picture->GetNumberOfPoints());
  for (std::size_t i = 0; i < pixels; ++i, a += channels, b += channels)
  {
    const auto bad = channels -
      static_cast<std::size_t>(
        std::count_if(a, a + channels, [](float value) { return std::isfinite(value); }));
    samples.NonFinite += static_cast<long long>(bad);
    if (bad > 0 || (m && !(m[i * maskChannels] > 0.5f)))
    {
      continue;
    }
    if (!std::all_of(b, b + channels, [](float value) { return std::isfinite(value); }))
    {
      throw UserError("the reference holds values that are not finite");
    }
    samples.A.insert(samples.A.end(), a, a + channels);
    samples.B.insert(samples.B.end(), b, b + channels);
  }
  if (samples.A.empty())
  {
    throw UserError("no pixels to compare: all are masked or not finite");
  }
  return samples;
}

void CompareAll(const Samples& samples, ImageMetrics& metrics)
{
  const auto channels = static_cast<std::size_t>(samples.Channels);
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
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::variant<double, long long>>> ImageMetrics::GetNamed() const
{
  return { { "relMSE", this->RelMSE }, { "relMSE_trim", this->RelMSETrim },
    { "median", this->Median }, { "p95", this->P95 }, { "p99", this->P99 }, { "max", this->Max },
    { "dark_max_abs", this->DarkMaxAbs }, { "bias", this->Bias },
    { "median_signed", this->MedianSigned }, { "fit", this->Fit },
    { "lit_frac", this->LitFraction }, { "pixels", this->Pixels },
    { "nonfinite", this->NonFinite } };
}

//------------------------------------------------------------------------------
ImageMetrics CompareImages(vtkImageData* picture, vtkImageData* reference, vtkImageData* mask)
{
  if (!HaveSameSize(picture, reference) ||
    picture->GetNumberOfScalarComponents() != reference->GetNumberOfScalarComponents())
  {
    throw UserError(
      "the images differ in size: " + DescribeSize(picture) + " and " + DescribeSize(reference));
  }
  if (mask && !HaveSameSize(picture, mask))
  {
    throw UserError(
      "the mask differs in size: " + DescribeSize(picture) + " and " + DescribeSize(mask));
  }
  const Samples samples = GatherSamples(picture, reference, mask);
  ImageMetrics metrics;
  CompareAll(samples, metrics);
  CompareLit(samples, metrics);
  return metrics;
}

}
