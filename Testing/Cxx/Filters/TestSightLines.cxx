// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightProbeFilter::SetSightLines(): visibility against K over the mean of the extinction
// along the line, by the midpoint rule over densities written out here; contrasts against their
// definition; several media against one.

#include "AirlightTestProbe.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Spacing = 0.25;
constexpr int Side = 9;
const glm::dvec3 Corner(-1.0, -0.8, -1.1); // of the image

// The samples of the image.
double GetSample(int i, int j, int k)
{
  return 1.0 + std::sin(1.7 * i + 0.9 * j) * std::cos(1.1 * k - 0.4 * i);
}

vtkSmartPointer<vtkImageData> MakeImage(int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->SetSpacing(Spacing, Spacing, Spacing);
  image->SetOrigin(Corner.x, Corner.y, Corner.z);
  image->AllocateScalars(type, 1);
  for (int n = 0; n < Side * Side * Side; ++n)
  {
    const double sample = GetSample(n % Side, n / Side % Side, n / Side / Side);
    image->GetPointData()->GetScalars()->SetComponent(n, 0, type == VTK_DOUBLE ? sample : 7.0);
  }
  return image;
}

// Trilinear between the samples, as the sum of hats; 0 outside.
double GetImageDensity(const glm::dvec3& p)
{
  const glm::dvec3 at = (p - Corner) / Spacing;
  if (glm::any(glm::lessThan(at, glm::dvec3(0.0))) ||
    glm::any(glm::greaterThan(at, glm::dvec3(Side - 1.0))))
  {
    return 0.0;
  }
  const glm::ivec3 cell = glm::min(glm::ivec3(at), Side - 2);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 sample = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 hat = 1.0 - glm::abs(at - glm::dvec3(sample));
    sum += hat.x * hat.y * hat.z * GetSample(sample.x, sample.y, sample.z);
  }
  return sum;
}

// Fog everywhere, thinner with height, a box, and an image, in all of which the eye sees.
struct Mixture
{
  Mixture()
  {
    this->Fog->SetScattering(0.05, 0.07, 0.03);
    this->Fog->SetDensityToExponentialHeight();
    this->Fog->SetScaleHeight(1.3);
    this->Box->SetScattering(0.2, 0.0, 0.1);
    this->Box->SetAbsorption(0.1, 0.3, 0.0);
    this->Box->SetRegionToBox();
    this->Box->SetBounds(-0.7, 1.2, -0.5, 1.5, -1.0, 0.6);
    this->Smoke->SetAbsorption(0.4, 0.5, 0.6);
    this->Smoke->SetDensityImage(MakeImage(VTK_DOUBLE));
    this->Smoke->SetDensityToImage();
  }

  // The mean of the channels' extinctions at a point.
  static double GetExtinction(const glm::dvec3& p)
  {
    const bool inBox =
      p.x > -0.7 && p.x < 1.2 && p.y > -0.5 && p.y < 1.5 && p.z > -1.0 && p.z < 0.6;
    return 0.05 * std::exp(-p.y / 1.3) + (inBox ? 0.7 / 3.0 : 0.0) + 0.5 * GetImageDensity(p);
  }

  vtkNew<vtkParticipatingMedium> Fog;
  vtkNew<vtkParticipatingMedium> Box;
  vtkNew<vtkParticipatingMedium> Smoke;
};

double GetMean(const glm::dvec3& a, const glm::dvec3& b)
{
  constexpr int Steps = 200000;
  double sum = 0.0;
  for (int i = 0; i < Steps; ++i)
  {
    sum += Mixture::GetExtinction(glm::mix(a, b, (i + 0.5) / Steps));
  }
  return sum / Steps;
}

//------------------------------------------------------------------------------
void TestVisibility()
{
  Random random(32);
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 60, false);
  cloud->GetPoints()->InsertNextPoint(&Eye.x);
  const Mixture mixture;
  vtkNew<vtkAirlightProbeFilter> filter;
  filter->SetInputData(cloud);
  filter->SetViewpoint(&Eye.x);
  filter->AddMedium(mixture.Fog);
  filter->AddMedium(mixture.Box);
  filter->AddMedium(mixture.Smoke);
  filter->AddMedium(mixture.Box); // each once
  Check(filter->GetNumberOfMedia() == 3 && filter->GetMedium(2) == mixture.Smoke.Get(), "media");
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  Check(!data->GetArray("MeanExtinction"), "no lines of sight by default");
  filter->SightLinesOn();
  filter->SetReflectingSignConstant(2.5);
  filter->Update();
  data = filter->GetOutput()->GetPointData();
  Comparison extinction("mean extinction, relative");
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    cloud->GetPoint(i, &p.x);
    const double expected = p == Eye ? Mixture::GetExtinction(Eye) : GetMean(Eye, p);
    const double found = data->GetArray("MeanExtinction")->GetComponent(i, 0);
    extinction.Add(std::abs(found / expected - 1.0), 1e-4,
      [&] { return Text("point ", i, ": ", found, ", expected ", expected); });
    const double reflecting = data->GetArray("ReflectingSignVisibility")->GetComponent(i, 0);
    const double emitting = data->GetArray("EmittingSignVisibility")->GetComponent(i, 0);
    Check(std::abs(reflecting * found / 2.5 - 1.0) < 1e-12 &&
        std::abs(emitting * found / 8.0 - 1.0) < 1e-12,
      Text("point ", i, ": visibilities are the constants over the mean extinction"));
    double transmittance = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      transmittance += std::log(data->GetArray("Transmittance")->GetComponent(i, c)) / -3.0;
    }
    Check(std::abs(transmittance - found * glm::distance(Eye, p)) < 1e-10,
      Text("point ", i, ": the transmittance is of all media"));
  }
  Check(extinction.Report(), "visibility by its definition");
}

//------------------------------------------------------------------------------
// Clear air is infinitely clear, or as far as is asked.
void TestClearAir()
{
  Random random(1);
  Probing probing;
  probing.Medium->SetScattering(0.0, 0.0, 0.0);
  probing.Medium->SetAbsorption(0.0, 0.0, 0.0);
  probing.Filter->SetInputData(MakeCloud(random, 1, false));
  probing.Filter->SightLinesOn();
  probing.Filter->Update();
  Check(std::isinf(probing.Get("EmittingSignVisibility", 0).x), "clear air");
  probing.Filter->SetMaximumVisibility(30.0);
  probing.Filter->Update();
  Check(probing.Get("EmittingSignVisibility", 0).x == 30.0, "clear air, cut off");
  Check(probing.Get("SignContrast", 0).x == 0.0, "no light, no contrast");
}

//------------------------------------------------------------------------------
void TestContrast()
{
  Random random(4);
  const auto lights = MakeLights();
  Probing probing;
  probing.Medium->SetAmbientRadiance(0.02, 0.03, 0.01);
  probing.Filter->SetInputData(MakeCloud(random, 40, false));
  probing.Filter->AddLight(lights[0].second);
  probing.Filter->SightLinesOn();
  probing.Filter->SetSignRadiance(1.5);
  probing.Filter->SetSignReflectance(0.6);
  probing.Filter->SetSignGroundReflectance(0.2);
  probing.Filter->Update();
  for (vtkIdType i = 0; i < 40; ++i)
  {
    const glm::dvec3 through = probing.Get("Transmittance", i);
    const glm::dvec3 lit = probing.Get("DirectIrradiance", i) / std::acos(-1.0);
    const glm::dvec3 veil = probing.Get("Radiance", i);
    const auto sum = [](const glm::dvec3& v) { return v.x + v.y + v.z; };
    const double letters = sum((1.5 + 0.6 * lit) * through + veil);
    const double ground = sum(0.2 * lit * through + veil);
    const double expected = (letters - ground) / (letters + ground);
    const double found = probing.Get("SignContrast", i).x;
    Check(std::abs(found - expected) < 1e-12, Text("contrast ", found, ", not ", expected));
    const double bare = sum(1.5 + 0.4 * lit) / sum(1.5 + 0.8 * lit);
    const double without = probing.Get("SignContrastWithoutAirlight", i).x;
    Check(std::abs(without - bare) < 1e-12, Text("without airlight ", without, ", not ", bare));
    Check(found < without, "airlight takes contrast");
  }
}

//------------------------------------------------------------------------------
// Two media of half the coefficients are one medium.
void TestHalves()
{
  Random random(9);
  const auto lights = MakeLights();
  for (bool image : { false, true })
  {
    Probing one;
    Probing two;
    vtkNew<vtkParticipatingMedium> other;
    for (vtkParticipatingMedium* medium : { one.Medium.Get(), two.Medium.Get(), other.Get() })
    {
      const double share = medium == one.Medium.Get() ? 1.0 : 0.5;
      medium->SetScattering(0.3 * share, 0.2 * share, 0.1 * share);
      medium->SetAbsorption(0.1 * share, 0.0, 0.05 * share);
      medium->SetDensityImage(MakeImage(VTK_DOUBLE));
      medium->SetDensity(image ? vtkParticipatingMedium::IMAGE : vtkParticipatingMedium::UNIFORM);
    }
    two.Filter->AddMedium(other);
    const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 8, false);
    for (Probing* probing : { &one, &two })
    {
      probing->Filter->SetInputData(cloud);
      probing->Filter->AddLight(lights[0].second);
      probing->Filter->AddLight(lights[3].second);
      probing->Filter->SightLinesOn();
      probing->Filter->Update();
    }
    for (const char* name : { "Radiance", "Transmittance", "DirectIrradiance", "MeanExtinction" })
    {
      for (vtkIdType i = 0; i < 8; ++i)
      {
        const double difference = glm::length(one.Get(name, i) - two.Get(name, i));
        Check(difference <= 2e-5 * glm::length(one.Get(name, i)),
          Text(name, i, image ? ", images" : ", uniform", ": two halves are one, but for ",
            difference));
      }
    }
  }
}

//------------------------------------------------------------------------------
// A density of 7 is the same of any type of sample.
void TestTypes()
{
  Random random(5);
  const vtkSmartPointer<vtkPolyData> cloud = MakeCloud(random, 5, false);
  for (int type : { VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_LONG_LONG, VTK_FLOAT })
  {
    Probing probing;
    probing.Medium->SetDensityImage(MakeImage(type));
    probing.Medium->SetDensityToImage();
    Probing same;
    same.Medium->SetScattering(2.1, 1.4, 0.7);
    same.Medium->SetAbsorption(0.7, 0.0, 0.35);
    same.Medium->SetRegionToBox();
    const glm::dvec3 high = Corner + 2.0;
    same.Medium->SetBounds(Corner.x, high.x, Corner.y, high.y, Corner.z, high.z);
    probing.Filter->SetInputData(cloud);
    same.Filter->SetInputData(cloud);
    probing.Filter->Update();
    same.Filter->Update();
    for (vtkIdType i = 0; i < 5; ++i)
    {
      const glm::dvec3 found = probing.Get("Transmittance", i);
      Check(glm::length(found - same.Get("Transmittance", i)) < 1e-12, Text("type ", type));
    }
  }
}
}

//------------------------------------------------------------------------------
int TestSightLines(int, char*[])
{
  TestVisibility();
  TestClearAir();
  TestContrast();
  TestHalves();
  TestTypes();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
