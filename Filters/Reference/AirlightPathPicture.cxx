// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathPicture.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace airlight
{
namespace
{
constexpr const char* Names[3] = { "Radiance", "Airlight", "Surface" };
constexpr int FirstRound = 2;      // samples: fewer have no standard error
constexpr int LeastForTarget = 16; // and of these few it may be far too small
}

//------------------------------------------------------------------------------
PathPicture::PathPicture(
  vtkImageData* image, const ReferenceTracer& tracer, const PathSettings& settings)
  : Image(image)
  , Tracer(tracer)
  , Settings(settings)
  , Paths(tracer, settings.Orders)
  , Width(image->GetDimensions()[0])
  , Height(image->GetDimensions()[1])
  , Pixels(image->GetNumberOfPoints())
{
  vtkNew<vtkDoubleArray> error;
  error->SetName("StandardError");
  error->SetNumberOfComponents(3);
  error->SetNumberOfTuples(image->GetNumberOfPoints());
  error->Fill(0.0);
  image->GetPointData()->AddArray(error);
  this->Error = error->GetPointer(0);
  for (int k = 0; k < 3; ++k)
  {
    this->Arrays[k] =
      vtkDoubleArray::SafeDownCast(image->GetPointData()->GetArray(Names[k]))->GetPointer(0);
    for (size_t i = 0; i < this->Pixels.size(); ++i)
    {
      std::copy_n(this->Arrays[k] + 3 * i, 3, &this->Pixels[i].First[k].x);
      this->Pixels[i].Means[k] = glm::dvec3(0.0);
    }
  }
}

//------------------------------------------------------------------------------
// Means and squares by Welford's updates, in the order of the samples.
void PathPicture::Add(vtkIdType index, int samples)
{
  const double x = static_cast<double>(index % this->Width) + 0.5;
  const double y = static_cast<double>(index / this->Width) + 0.5;
  const ReferenceTracer::EyeRay eye = this->Tracer.FindEyeRay(x, y);
  Pixel& pixel = this->Pixels[index];
  for (int k = 0; k < samples; ++k)
  {
    RandomNumbers random(static_cast<std::uint64_t>(this->Settings.Seed),
      static_cast<std::uint64_t>(index), static_cast<std::uint64_t>(pixel.Count));
    const PathRadiance path = this->Paths.Trace(eye, random);
    const double share = 1.0 / ++pixel.Count;
    const glm::dvec3 change = path.Radiance - pixel.Means[0];
    pixel.Means[0] += share * change;
    pixel.Means[1] += share * (path.Airlight - pixel.Means[1]);
    pixel.Means[2] += share * (path.Surface - pixel.Means[2]);
    pixel.Squares += change * (path.Radiance - pixel.Means[0]);
  }
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec3 value = pixel.First[k] + pixel.Means[k];
    std::copy_n(&value.x, 3, this->Arrays[k] + 3 * index);
  }
  const double count = pixel.Count;
  const glm::dvec3 error = glm::sqrt(pixel.Squares / (count * (count - 1.0)));
  std::copy_n(&error.x, 3, this->Error + 3 * index);
}

//------------------------------------------------------------------------------
void PathPicture::AddRows(int row, int rows, int samples)
{
  const vtkIdType width = this->Width;
  vtkSMPTools::For(row * width, (row + rows) * width, 4, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      this->Add(i, samples);
    }
  });
}

//------------------------------------------------------------------------------
// The arrays are written through pointers, of which their ranges know nothing.
void PathPicture::MarkModified()
{
  for (int k = 0; k < this->Image->GetPointData()->GetNumberOfArrays(); ++k)
  {
    this->Image->GetPointData()->GetArray(k)->Modified();
  }
  this->Image->Modified();
}

//------------------------------------------------------------------------------
double PathPicture::GetRelativeError() const
{
  double squares = 0.0;
  double sum = 0.0;
  const size_t count = 3 * this->Pixels.size();
  for (size_t i = 0; i < count; ++i)
  {
    squares += this->Error[i] * this->Error[i];
    sum += std::abs(this->Arrays[0][i]);
  }
  const auto n = static_cast<double>(count);
  return squares > 0.0 && sum > 0.0 ? std::sqrt(squares / n) / (sum / n) : 0.0;
}

//------------------------------------------------------------------------------
void PathPicture::Compute(const std::function<bool(double)>& proceed)
{
  const auto start = std::chrono::steady_clock::now();
  const auto getTimeShare = [&]() {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return this->Settings.TimeLimit > 0.0 ? elapsed.count() / this->Settings.TimeLimit : 0.0;
  };
  const int step = std::max(1, this->Height / 50);
  double byError = 0.0;
  for (int done = 0; done < this->Settings.Samples;)
  {
    // A quarter more each time: the target is not overshot by much.
    const int round = done == 0 ? FirstRound : std::max(1, done / 4);
    const int samples = std::min(round, this->Settings.Samples - done);
    for (int row = 0; row < this->Height; row += step)
    {
      const int rows = std::min(step, this->Height - row);
      this->AddRows(row, rows, samples);
      const double now = done + samples * static_cast<double>(row + rows) / this->Height;
      const double byTime = getTimeShare();
      const double share = std::max({ now / this->Settings.Samples, byTime, byError });
      this->MarkModified();
      if (!proceed(std::min(share, 1.0)) || (done > 0 && byTime >= 1.0))
      {
        return;
      }
    }
    done += samples;
    const double error = this->GetRelativeError();
    const double target = this->Settings.TargetError;
    if (getTimeShare() >= 1.0 || (target > 0.0 && error <= target && done >= LeastForTarget))
    {
      break;
    }
    byError = error > 0.0 ? std::min(target * target / (error * error), 1.0) : 0.0;
  }
}
}
