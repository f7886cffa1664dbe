// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Media whose density comes from an image, in double precision: transmittance, airlight and ambient
// light against quadrature of the trilinear function in its own eight-term form, and an image of
// ones against the uniform box.

#include "AirlightTestCheck.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// A rotated image of random samples, and its density by the definition.
class Cloud
{
public:
  explicit Cloud(Random& random)
  {
    this->Image->SetExtent(this->Extent);
    this->Image->SetOrigin(&this->Origin.x);
    this->Image->SetSpacing(&this->Spacing.x);
    // Rotated about z, then about x.
    const double a = 0.4;
    const double b = -0.7;
    this->Rotation = glm::transpose(glm::dmat3(std::cos(a), -std::sin(a), 0.0, //
      std::cos(b) * std::sin(a), std::cos(b) * std::cos(a), -std::sin(b),      //
      std::sin(b) * std::sin(a), std::sin(b) * std::cos(a), std::cos(b)));
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        this->Image->GetDirectionMatrix()->SetElement(row, column, this->Rotation[column][row]);
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
    return glm::transpose(this->Rotation) * (p - this->Origin) / this->Spacing -
      glm::dvec3(this->Extent[0], this->Extent[2], this->Extent[4]);
  }

  glm::dvec3 ToWorld(const glm::dvec3& samples) const
  {
    return this->Origin +
      this->Rotation *
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
  glm::dmat3 Rotation{ 1.0 };
};

//------------------------------------------------------------------------------
constexpr double Scattering[3] = { 0.3, 0.6, 0.2 };
constexpr double Absorption[3] = { 0.1, 0.0, 0.3 };

void SetCoefficients(vtkParticipatingMedium* medium)
{
  medium->SetScattering(Scattering);
  medium->SetAbsorption(Absorption);
  medium->SetPhaseFunctionToRayleigh();
}

double Rayleigh(double cosine) { return 3.0 / (16.0 * Pi) * (1.0 + cosine * cosine); }

//------------------------------------------------------------------------------
// Depth, what a lamp scatters, and ambient light, along rays through the cloud.
bool CompareCloud()
{
  Random random(5);
  const Cloud cloud(random);
  vtkNew<vtkParticipatingMedium> medium;
  SetCoefficients(medium);
  medium->SetAmbientRadiance(0.5, 1.0, 2.0);
  medium->SetDensityImage(cloud.Image);
  medium->SetDensityToImage();
  Comparison depth("optical depth through an image");
  Comparison airlight("airlight of a lamp in an image");
  Comparison ambient("ambient light in an image");
  for (int i = 0; i < 25; ++i)
  {
    const glm::dvec3 a = cloud.GetPoint(random);
    const glm::dvec3 b = cloud.GetPoint(random);
    const glm::dvec3 lamp = cloud.GetPoint(random);
    const double length = glm::length(b - a);
    const glm::dvec3 direction = (b - a) / length;
    const auto describe = [&] { return Text("ray ", i, " of length ", length); };

    const double whole = cloud.GetDepth(a, b);
    double passes[3];
    vtkAirlight::Transmittance(medium, &a.x, &b.x, passes);
    const int c = i % 3;
    const double sigmaT = Scattering[c] + Absorption[c];
    depth.Add(std::abs(-std::log(passes[c]) / sigmaT - whole), 1e-9 * whole + 1e-12, describe);

    double found[3];
    vtkAirlight::Ambient(medium, &a.x, &direction.x, length, found);
    const double expected =
      Scattering[c] / sigmaT * medium->GetAmbientRadiance()[c] * (1.0 - std::exp(-sigmaT * whole));
    ambient.Add(std::abs(found[c] - expected), 1e-9 * expected + 1e-12, describe);

    const auto integrand = [&](double share) {
      const glm::dvec3 x = a + share * (b - a);
      const double density = cloud.GetDensity(x);
      const glm::dvec3 way = x - lamp;
      const double r = glm::length(way);
      const double depths = density > 0.0 ? cloud.GetDepth(a, x) + cloud.GetDepth(x, lamp) : 0.0;
      return density * Rayleigh(-glm::dot(way, direction) / r) * std::exp(-sigmaT * depths) /
        (r * r);
    };
    if (i < 6)
    {
      const double intensity[3] = { 2.0, 2.0, 2.0 };
      vtkAirlight::Inscatter(medium, &lamp.x, intensity, &a.x, &direction.x, 0.0, length, found);
      const double scattered =
        2.0 * Scattering[c] * length * Integrate(integrand, cloud.FindKinks(a, b), 1e-6);
      airlight.Add(std::abs(found[c] - scattered), 1e-5 * scattered + 1e-12, describe);
    }
  }
  return AllOk({ &depth, &airlight, &ambient });
}

//------------------------------------------------------------------------------
// An image of ones is a uniform box, for lamps of all kinds, inside and outside.
bool CompareOnes()
{
  vtkNew<vtkImageData> ones;
  ones->SetDimensions(4, 9, 6);
  ones->SetOrigin(-1.0, -2.0, 0.0);
  ones->SetSpacing(1.0, 0.5, 0.6);
  ones->AllocateScalars(VTK_FLOAT, 1);
  ones->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkParticipatingMedium> cloud;
  SetCoefficients(cloud);
  cloud->SetDensityImage(ones);
  cloud->SetDensityToImage();
  vtkNew<vtkParticipatingMedium> box;
  SetCoefficients(box);
  box->SetRegionToBox();
  box->SetBounds(ones->GetBounds());

  Random random(9);
  Comparison comparison("an image of ones and a box");
  for (int i = 0; i < 400; ++i)
  {
    const auto point = [&] {
      return glm::dvec3(random.Uniform(-3, 4), random.Uniform(-4, 4), random.Uniform(-2, 5));
    };
    const glm::dvec3 a = point();
    const glm::dvec3 b = point();
    const glm::dvec3 position = i % 2 == 0 ? glm::dvec3(0.3, 0.4, 1.1) : point();
    vtkNew<vtkLight> light;
    const double power[3] = { 3.0, 2.0, 1.0 };
    vtkAirlight::SetRadiantIntensity(light, power);
    light->SetPositional(i % 4 != 3);
    light->SetConeAngle(i % 4 == 2 ? 35.0 : 90.0);
    light->SetExponent(i % 8 == 2 ? 3.0 : 0.0);
    light->SetPosition(position.x, position.y, position.z);
    light->SetFocalPoint(0.5, 0.1, 1.5);
    const glm::dvec3 direction = b - a;
    double found[3];
    double expected[3];
    const double end = i % 5 == 0 ? HUGE_VAL : glm::length(direction);
    vtkAirlight::Inscatter(cloud, light, &a.x, &direction.x, 0.0, end, found);
    vtkAirlight::Inscatter(box, light, &a.x, &direction.x, 0.0, end, expected);
    comparison.Add(std::abs(found[i % 3] - expected[i % 3]), 2e-6 * expected[i % 3] + 1e-15,
      [&] { return Text("setting ", i, ": ", found[i % 3], " and ", expected[i % 3]); });
  }
  return comparison.Report();
}

//------------------------------------------------------------------------------
// Changes of the image, and the boxes of region and image together.
void CheckUpdates()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->SetSpacing(4.0, 4.0, 4.0);
  image->AllocateScalars(VTK_DOUBLE, 1);
  image->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetAbsorption(0.25, 0.25, 0.25);
  medium->SetDensityImage(image);
  Check(medium->GetDensityImage() == image, "the image is kept");
  const double a[3] = { -10.0, 1.0, 1.0 };
  const double b[3] = { 10.0, 1.0, 1.0 };
  const auto depth = [&] {
    double rgb[3];
    vtkAirlight::Transmittance(medium, a, b, rgb);
    return -std::log(rgb[1]);
  };
  const auto isNear = [](double x, double y) { return std::abs(x - y) < 1e-12; };
  Check(isNear(depth(), 1.0), "an image is in use where no density has been chosen");
  medium->SetDensityImage(nullptr);
  Check(isNear(depth(), 5.0), "without an image the density is uniform again");
  medium->SetDensityToUniform();
  medium->SetDensityImage(image);
  Check(isNear(depth(), 5.0), "an image that is not in use has no effect");
  medium->SetDensityToImage();
  Check(medium->GetDensity() == vtkParticipatingMedium::IMAGE, "the density is the image's");
  Check(isNear(depth(), 1.0), "20 % of the way are in the image");
  medium->SetRegionToBox();
  medium->SetBounds(3.0, 9.0, 0.0, 4.0, 0.0, 4.0);
  Check(isNear(depth(), 0.25), "box and image together");
  medium->SetBounds(5.0, 9.0, 0.0, 4.0, 0.0, 4.0);
  Check(depth() == 0.0, "box and image apart");
  medium->SetRegionToSphere();
  medium->SetCenter(0.0, 1.0, 1.0);
  medium->SetRadius(2.0);
  Check(isNear(depth(), 0.5), "half a sphere is in the image");
  medium->SetRegionToUnbounded();
  const vtkMTimeType before = medium->GetMTime();
  image->GetPointData()->GetScalars()->Fill(2.0);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  Check(medium->GetMTime() > before, "the medium changes with its image");
  Check(isNear(depth(), 2.0), "twice the density");
}
}

int TestDensityImage(int, char*[])
{
  const bool cloud = CompareCloud();
  const bool ones = CompareOnes();
  CheckUpdates();
  return cloud && ones && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
