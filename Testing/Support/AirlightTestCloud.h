// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Density from an image, by its definition.
 */

#ifndef AirlightTestCloud_h
#define AirlightTestCloud_h

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight_test
{
// A turned image of random samples, and its density by the definition.
class Cloud
{
public:
  explicit Cloud(Random& random)
  {
    this->Image->SetExtent(this->Extent);
    this->Image->SetOrigin(&this->Origin.x);
    this->Image->SetSpacing(&this->Spacing.x);
    // Turned about z, then about x.
    const double a = 0.4;
    const double b = -0.7;
    this->Turn = glm::transpose(glm::dmat3(std::cos(a), -std::sin(a), 0.0, //
      std::cos(b) * std::sin(a), std::cos(b) * std::cos(a), -std::sin(b),  //
      std::sin(b) * std::sin(a), std::sin(b) * std::cos(a), std::cos(b)));
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        this->Image->GetDirectionMatrix()->SetElement(row, column, this->Turn[column][row]);
      }
    }
    this->Image->AllocateScalars(VTK_DOUBLE, 1);
    auto* samples = static_cast<double*>(this->Image->GetScalarPointer());
    for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
    {
      samples[i] = std::max(random.Uniform(-0.5, 1.5), 0.0);
    }
  }

  // Position in samples, counted from the extent's first one.
  glm::dvec3 ToSamples(const glm::dvec3& p) const
  {
    return glm::transpose(this->Turn) * (p - this->Origin) / this->Spacing -
      glm::dvec3(this->Extent[0], this->Extent[2], this->Extent[4]);
  }

  glm::dvec3 ToWorld(const glm::dvec3& samples) const
  {
    return this->Origin +
      this->Turn *
      (this->Spacing * (samples + glm::dvec3(this->Extent[0], this->Extent[2], this->Extent[4])));
  }

  // The sum over all samples of their value times the product of three hats.
  double GetDensity(const glm::dvec3& p) const
  {
    const glm::dvec3 at = this->ToSamples(p);
    double sum = 0.0;
    int size[3];
    this->Image->GetDimensions(size);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (at[axis] < 0.0 || at[axis] > size[axis] - 1.0)
      {
        return 0.0;
      }
    }
    const auto* samples = static_cast<double*>(this->Image->GetScalarPointer());
    for (int k = 0; k < size[2]; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const glm::dvec3 hat =
            glm::max(1.0 - glm::abs(at - glm::dvec3(i, j, k)), glm::dvec3(0.0));
          sum += samples[(k * size[1] + j) * size[0] + i] * hat.x * hat.y * hat.z;
        }
      }
    }
    return sum;
  }

  // Where the way from a to b meets planes of samples, as shares of it; with 0 and 1.
  std::vector<long double> FindKinks(const glm::dvec3& a, const glm::dvec3& b) const
  {
    const glm::dvec3 from = this->ToSamples(a);
    const glm::dvec3 to = this->ToSamples(b);
    std::vector<long double> kinks = { 0.0L, 1.0L };
    int size[3];
    this->Image->GetDimensions(size);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < size[axis]; ++i)
      {
        const double share = (i - from[axis]) / (to[axis] - from[axis]);
        if (share > 0.0 && share < 1.0)
        {
          kinks.push_back(share);
        }
      }
    }
    std::sort(kinks.begin(), kinks.end());
    return kinks;
  }

  // Integral of the density from a to b.
  double GetDepth(const glm::dvec3& a, const glm::dvec3& b) const
  {
    const auto density = [&](double share) { return this->GetDensity(a + share * (b - a)); };
    return glm::length(b - a) * Integrate(density, this->FindKinks(a, b), 1e-9);
  }

  // A point in or around the image.
  glm::dvec3 GetPoint(Random& random) const
  {
    int size[3];
    this->Image->GetDimensions(size);
    glm::dvec3 samples;
    for (int axis = 0; axis < 3; ++axis)
    {
      samples[axis] = random.Uniform(-0.5, 1.5) * (size[axis] - 1);
    }
    return this->ToWorld(samples);
  }

  vtkNew<vtkImageData> Image;

private:
  int Extent[6] = { 2, 6, -1, 2, 0, 3 };
  glm::dvec3 Origin{ 10.0, -3.0, 0.5 };
  glm::dvec3 Spacing{ 0.5, 0.8, 0.6 };
  glm::dmat3 Turn{ 1.0 };
};
}

#endif
