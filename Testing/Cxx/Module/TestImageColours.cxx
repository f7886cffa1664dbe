// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Density images with arrays of albedos and of factors of the emission, in double precision: a
// lamp's airlight, ambient light and emission against quadrature of the trilinear functions in
// their eight-term form; arrays of one colour against the medium's own; bad arrays.

#include "AirlightTestErrors.h"
#include "AirlightTestExpect.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Points = 4;
constexpr double Spacing = 0.7;
const glm::dvec3 Origin(1.0, -2.0, 3.0);
const glm::dvec3 Extinction(0.9, 0.6, 1.4);
const glm::dvec3 Ambient(0.5, 1.0, 2.0);
const glm::dvec3 Emission(0.3, 0.2, 0.1);

// Densities, albedos and factors at the points, x fastest.
struct Cloud
{
  explicit Cloud(Random& random)
  {
    this->Image->SetDimensions(Points, Points, Points);
    this->Image->SetOrigin(&Origin.x);
    this->Image->SetSpacing(Spacing, Spacing, Spacing);
    vtkNew<vtkDoubleArray> densities;
    for (int array = 0; array < 2; ++array)
    {
      this->Colours[array]->SetName(array == 0 ? "Albedo" : "Glow");
      this->Colours[array]->SetNumberOfComponents(3);
    }
    for (int i = 0; i < Points * Points * Points; ++i)
    {
      densities->InsertNextValue(std::max(random.Uniform(-0.4, 1.5), 0.0));
      for (int array = 0; array < 2; ++array)
      {
        const double most = array == 0 ? 1.0 : 3.0;
        this->Colours[array]->InsertNextTuple3(
          random.Uniform(0.0, most), random.Uniform(0.0, most), random.Uniform(0.0, most));
      }
    }
    this->Image->GetPointData()->SetScalars(densities);
    this->Image->GetPointData()->AddArray(this->Colours[0]);
    this->Image->GetPointData()->AddArray(this->Colours[1]);
    this->Medium->SetScattering(0.1, 0.1, 0.1);
    this->Medium->SetAbsorption(Extinction.x - 0.1, Extinction.y - 0.1, Extinction.z - 0.1);
    this->Medium->SetDensityImage(this->Image);
    this->Medium->SetDensityToImage();
  }

  // A component of an array at a place: the sum over all points of their value times three hats.
  static double Get(vtkDataArray* array, int component, const glm::dvec3& place)
  {
    const glm::dvec3 at = (place - Origin) / Spacing;
    double sum = 0.0;
    for (int i = 0; i < Points * Points * Points; ++i)
    {
      const glm::dvec3 point(i % Points, i / Points % Points, i / (Points * Points));
      const glm::dvec3 hat = glm::max(1.0 - glm::abs(at - point), glm::dvec3(0.0));
      sum += array->GetComponent(i, component) * hat.x * hat.y * hat.z;
    }
    return sum;
  }

  double GetDensity(const glm::dvec3& place) const
  {
    const glm::dvec3 at = (place - Origin) / Spacing;
    const bool inside = glm::all(glm::greaterThanEqual(at, glm::dvec3(0.0))) &&
      glm::all(glm::lessThanEqual(at, glm::dvec3(Points - 1)));
    return !inside ? 0.0 : Get(this->Image->GetPointData()->GetScalars(), 0, place);
  }

  // Where the way between two points meets planes of points, as shares of it; with 0 and 1.
  static std::vector<long double> FindKinks(const glm::dvec3& a, const glm::dvec3& b)
  {
    std::vector<long double> kinks = { 0.0L, 1.0L };
    for (int n = 0; n < 3 * Points; ++n)
    {
      const int axis = n % 3;
      const double share = (Origin[axis] + n / 3 * Spacing - a[axis]) / (b[axis] - a[axis]);
      if (share > 0.0 && share < 1.0)
      {
        kinks.push_back(share);
      }
    }
    std::sort(kinks.begin(), kinks.end());
    return kinks;
  }

  double GetDepth(const glm::dvec3& a, const glm::dvec3& b) const
  {
    const auto density = [&](double share) { return this->GetDensity(a + share * (b - a)); };
    return glm::length(b - a) * Integrate(density, FindKinks(a, b), 1e-9);
  }

  vtkNew<vtkImageData> Image;
  vtkNew<vtkFloatArray> Colours[2];
  vtkNew<vtkParticipatingMedium> Medium;
};

glm::dvec3 RandomPlace(Random& random)
{
  return Origin + (Points - 1) * Spacing * (0.5 + RandomPoint(random, 0.8));
}

//------------------------------------------------------------------------------
bool CompareRays()
{
  Random random(21);
  const Cloud cloud(random);
  Comparison airlight("airlight of a lamp where albedos vary");
  Comparison source("ambient light and emission where colours vary");
  for (int i = 0; i < 24; ++i)
  {
    // Without arrays, with either, with both.
    const bool albedos = i % 4 != 1;
    const bool glows = i % 4 != 2;
    cloud.Medium->SetAlbedoArrayName(albedos ? "Albedo" : "");
    cloud.Medium->SetEmissionArrayName(glows ? "Glow" : "");
    cloud.Medium->SetAmbientRadiance(&Ambient.x);
    cloud.Medium->SetEmission(&Emission.x);
    const glm::dvec3 a = RandomPlace(random);
    const glm::dvec3 b = RandomPlace(random);
    const glm::dvec3 lamp = RandomPlace(random);
    const double length = glm::length(b - a);
    const glm::dvec3 direction = (b - a) / length;
    const int c = i % 3;
    const auto scattering = [&](const glm::dvec3& x) {
      return albedos ? Extinction[c] * Cloud::Get(cloud.Colours[0], c, x) : 0.1;
    };
    const auto describe = [&] { return Text("ray ", i, " of length ", length); };
    const auto kinks = Cloud::FindKinks(a, b);

    double found[3];
    vtkAirlight::Ambient(cloud.Medium, &a.x, &direction.x, length, found);
    const double expected = length *
      Integrate(
        [&](double share) {
          const glm::dvec3 x = a + share * (b - a);
          const double density = cloud.GetDensity(x);
          const double depth = density > 0.0 ? cloud.GetDepth(a, x) : 0.0;
          const double glow = glows ? Cloud::Get(cloud.Colours[1], c, x) : 1.0;
          return density * (scattering(x) * Ambient[c] + Emission[c] * glow) *
            std::exp(-Extinction[c] * depth);
        },
        kinks, 1e-8);
    source.Add(std::abs(found[c] - expected), 1e-6 * expected + 1e-12, describe);

    if (i < 6)
    {
      const double intensity[3] = { 2.0, 2.0, 2.0 };
      vtkAirlight::Inscatter(
        cloud.Medium, &lamp.x, intensity, &a.x, &direction.x, 0.0, length, found);
      const double scattered = 2.0 / (4.0 * Pi) * length *
        Integrate(
          [&](double share) {
            const glm::dvec3 x = a + share * (b - a);
            const double density = cloud.GetDensity(x);
            const double depths =
              density > 0.0 ? cloud.GetDepth(a, x) + cloud.GetDepth(x, lamp) : 0.0;
            return density * scattering(x) * std::exp(-Extinction[c] * depths) /
              glm::dot(x - lamp, x - lamp);
          },
          kinks, 1e-6);
      airlight.Add(std::abs(found[c] - scattered), 1e-5 * scattered + 1e-12, describe);
    }
  }
  return AllOk({ &airlight, &source });
}

//------------------------------------------------------------------------------
// The same image, of any direction, in a larger one that is empty but for it, whose extent does not
// begin at 0. Colours of its other points do not matter.
vtkSmartPointer<vtkImageData> AddMargin(vtkImageData* image, Random& random)
{
  const glm::ivec3 low(2, 3, 1);
  const glm::ivec3 high(1, 0, 4);
  const glm::ivec3 first(5, -3, 7);
  const glm::dvec3 before = Spacing * glm::dvec3(first + low);
  double way[3];
  image->GetDirectionMatrix()->MultiplyPoint(&before.x, way);
  const glm::dvec3 origin = Origin - glm::dvec3(way[0], way[1], way[2]);
  auto result = vtkSmartPointer<vtkImageData>::New();
  const glm::ivec3 last = first + low + Points - 1 + high;
  result->SetExtent(first.x, last.x, first.y, last.y, first.z, last.z);
  result->SetOrigin(&origin.x);
  result->SetSpacing(Spacing, Spacing, Spacing);
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  vtkPointData* points = image->GetPointData();
  for (int array = 0; array < points->GetNumberOfArrays(); ++array)
  {
    vtkDataArray* from = points->GetArray(array);
    auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(from->GetNumberOfComponents());
    to->SetNumberOfTuples(result->GetNumberOfPoints());
    to->Fill(0.0);
    const bool isDensity = from == points->GetScalars();
    for (vtkIdType i = 0; i < to->GetNumberOfTuples() && !isDensity; ++i)
    {
      for (int c = 0; c < to->GetNumberOfComponents(); ++c)
      {
        to->SetComponent(i, c, random.Uniform(0.0, 1.0));
      }
    }
    for (int i = 0; i < Points * Points * Points; ++i)
    {
      int ijk[3] = { i % Points + first.x + low.x, i / Points % Points + first.y + low.y,
        i / (Points * Points) + first.z + low.z };
      to->SetTuple(result->ComputePointId(ijk), i, from);
    }
    result->GetPointData()->AddArray(to);
    if (isDensity)
    {
      result->GetPointData()->SetActiveAttribute(array, vtkDataSetAttributes::SCALARS);
    }
  }
  return result;
}

bool CompareMargin()
{
  Random random(24);
  const Cloud cloud(random);
  vtkDataArray* densities = cloud.Image->GetPointData()->GetScalars();
  // Where there is a margin, the density is continuous only without any at the image's faces.
  for (int i = 0; i < Points * Points * Points; ++i)
  {
    const glm::ivec3 at(i % Points, i / Points % Points, i / (Points * Points));
    const bool inside = glm::all(glm::greaterThan(at, glm::ivec3(0))) &&
      glm::all(glm::lessThan(at, glm::ivec3(Points - 1)));
    densities->SetComponent(i, 0, inside ? random.Uniform(0.5, 1.5) : 0.0);
  }
  cloud.Medium->SetAmbientRadiance(&Ambient.x);
  cloud.Medium->SetEmission(&Emission.x);
  cloud.Medium->SetAlbedoArrayName("Albedo");
  cloud.Medium->SetEmissionArrayName("Glow");
  cloud.Image->SetDirectionMatrix(0.8, 0.6, 0.0, 0.0, 0.0, 1.0, 0.6, -0.8, 0.0); // rotated
  const auto padded = AddMargin(cloud.Image, random);
  Comparison comparison("an empty margin changes nothing");
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 middle(
      cloud.Image->GetCenter()[0], cloud.Image->GetCenter()[1], cloud.Image->GetCenter()[2]);
    const glm::dvec3 a = middle + RandomPoint(random, 1.0);
    const glm::dvec3 direction = RandomUnit(random);
    const glm::dvec3 lamp = middle + RandomPoint(random, 1.0);
    const double intensity[3] = { 2.0, 3.0, 4.0 };
    const auto get = [&](vtkImageData* image) {
      std::array<double, 6> result{};
      cloud.Medium->SetDensityImage(image);
      vtkAirlight::Ambient(cloud.Medium, &a.x, &direction.x, 3.0, result.data());
      vtkAirlight::Inscatter(
        cloud.Medium, &lamp.x, intensity, &a.x, &direction.x, 0.0, 3.0, result.data() + 3);
      return result;
    };
    const std::array<double, 6> expected = get(cloud.Image);
    const std::array<double, 6> found = get(padded);
    for (int n = 0; n < 6; ++n)
    {
      comparison.Add(std::abs(found[n] - expected[n]), 1e-7 * expected[n],
        [&] { return Text("ray ", i, ", number ", n, ": ", found[n], " for ", expected[n]); });
    }
  }
  return comparison.Report();
}

//------------------------------------------------------------------------------
// Unsigned characters of 51 are an albedo of a fifth; one component is for all channels.
void CheckConstant()
{
  Random random(22);
  const Cloud cloud(random);
  cloud.Medium->SetAmbientRadiance(&Ambient.x);
  const glm::dvec3 scattering = 0.2 * Extinction;
  cloud.Medium->SetScattering(&scattering.x);
  const glm::dvec3 absorption = 0.8 * Extinction;
  cloud.Medium->SetAbsorption(&absorption.x);
  const glm::dvec3 a = Origin - 0.1;
  const glm::dvec3 direction(0.5, 0.6, 0.7);
  const glm::dvec3 lamp = Origin + glm::dvec3(3.0, 0.5, 1.0);
  const double intensity[3] = { 2.0, 3.0, 4.0 };
  const auto get = [&] {
    std::array<double, 6> result{};
    vtkAirlight::Ambient(cloud.Medium, &a.x, &direction.x, 5.0, result.data());
    vtkAirlight::Inscatter(
      cloud.Medium, &lamp.x, intensity, &a.x, &direction.x, 0.0, 5.0, result.data() + 3);
    return result;
  };
  const std::array<double, 6> expected = get();
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("Bytes");
  bytes->SetNumberOfTuples(cloud.Image->GetNumberOfPoints());
  bytes->FillValue(51);
  cloud.Image->GetPointData()->AddArray(bytes);
  cloud.Medium->SetAlbedoArrayName("Bytes");
  const std::array<double, 6> found = get();
  for (int i = 0; i < 6; ++i)
  {
    Expect(expected[i] > 0.0 && std::abs(found[i] / expected[i] - 1.0) < 2e-6,
      "an array of one colour", i, found[i], expected[i]);
  }
}

//------------------------------------------------------------------------------
// Bad arrays give one error each and have no effect.
void CheckErrors()
{
  Random random(23);
  const Cloud cloud(random);
  cloud.Medium->SetAmbientRadiance(&Ambient.x);
  ErrorListener errors(cloud.Medium);
  const glm::dvec3 direction(0.5, 0.6, 0.7);
  const auto get = [&] {
    glm::dvec3 result;
    vtkAirlight::Ambient(cloud.Medium, &Origin.x, &direction.x, 5.0, &result.x);
    return result;
  };
  const glm::dvec3 without = get();
  const auto check = [&](const char* part, const char* what) {
    Expect(get() == without && get() == without, what, get().x, without.x);
    Expect(errors.Take() == 1, what);
    Expect(errors.GetText().find(part) != std::string::npos, what, errors.GetText());
  };
  cloud.Medium->SetAlbedoArrayName("None");
  check("has no point array 'None'", "an array that is not there");
  vtkNew<vtkDoubleArray> two;
  two->SetName("Two");
  two->SetNumberOfComponents(2);
  two->SetNumberOfTuples(cloud.Image->GetNumberOfPoints());
  two->Fill(0.5);
  cloud.Image->GetPointData()->AddArray(two);
  cloud.Medium->SetAlbedoArrayName("Two");
  check("2 components: one or three are needed", "an array of two components");
  vtkNew<vtkDoubleArray> one;
  one->SetName("One");
  one->SetNumberOfTuples(cloud.Image->GetNumberOfPoints());
  one->Fill(0.5);
  cloud.Image->GetPointData()->AddArray(one);
  for (const double bad : { 1.5, -0.1, std::nan("") })
  {
    one->SetValue(7, bad);
    one->Modified();
    cloud.Image->Modified();
    cloud.Medium->SetAlbedoArrayName("One");
    check("at point 7 of its array 'One': its values must be from 0 to 1", "an albedo of no share");
  }
  one->SetValue(7, 0.5);
  one->Modified();
  cloud.Image->Modified();
  Expect(get().x > without.x && errors.Take() == 0, "a corrected array", get().x, without.x);
  cloud.Medium->SetAlbedoArrayName("");
  cloud.Medium->SetEmissionArrayName("Neither");
  check("has no point array 'Neither'", "factors that are not there");
  cloud.Medium->SetDensityToUniform();
  get();
  Expect(errors.Take() == 0, "without image no array is looked for");
}
}

//------------------------------------------------------------------------------
int TestImageColours(int, char*[])
{
  const bool ok = CompareRays() && CompareMargin();
  CheckConstant();
  CheckErrors();
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
