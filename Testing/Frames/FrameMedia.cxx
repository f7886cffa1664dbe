// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The media of a random scene.

#include "FrameScene.h"

#include "RandomParts.h"

#include "AirlightTestPhaseTable.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <algorithm>

namespace airlight_test
{
namespace
{
using Medium = vtkParticipatingMedium;

// Every third value is missing: 0 is what formulas divide by.
double Coefficient(Random& random, double base)
{
  return random.Index(4) ? base * random.LogUniform(0.05, 5.0) : 0.0;
}

vtkSmartPointer<vtkPolyData> MakeClosedSurface(
  const double centre[3], double radius, Random& random)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre[0], centre[1], centre[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(3 + random.Index(4));
  sphere->SetPhiResolution(3 + random.Index(3));
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(sphere->GetOutput());
  return data;
}
}

//------------------------------------------------------------------------------
// From clear to opaque; each channel may be without scattering, absorption, or both.
void FrameScene::SetCoefficients(vtkParticipatingMedium* medium, Random& random)
{
  const double base = random.LogUniform(1e-5, 10.0) / this->Unit;
  double s[3];
  double a[3];
  const bool clear = random.Index(15) == 0;
  for (int i = 0; i < 3; ++i)
  {
    s[i] = clear ? 0.0 : Coefficient(random, base);
    a[i] = clear || random.Index(2) ? 0.0 : Coefficient(random, base);
  }
  if (this->Group.Grey)
  {
    s[1] = s[2] = s[0];
    a[1] = a[2] = a[0];
  }
  medium->SetScattering(s);
  medium->SetAbsorption(a);
  if (random.Index(4) == 0)
  {
    const double red = random.Uniform(0.0, 1.0);
    medium->SetAmbientRadiance(red, random.Uniform(0.0, 1.0), 0.0);
  }
  this->Note(
    "sigmaS ", Text3(s), " sigmaA ", Text3(a), " ambient ", Text3(medium->GetAmbientRadiance()));
}

//------------------------------------------------------------------------------
void FrameScene::SetHeight(vtkParticipatingMedium* medium, Random& random)
{
  const double scale =
    random.Index(2) ? random.LogUniform(0.3, 10.0) : random.LogUniform(1e-3, 1e5);
  const double reference =
    random.Index(2) ? random.Uniform(-2.0, 2.0) : scale * random.Uniform(-3.0, 3.0);
  medium->SetScaleHeight(this->Unit * scale);
  medium->SetReferenceHeight(this->Unit * reference);
  const glm::dvec3 up = random.Index(2) ? RandomUnit(random) : glm::dvec3(0.0, 1.0, 0.0);
  medium->SetUp(&up.x);
  this->Note("scale height ", scale, " reference ", reference, " up ", Text3(&up.x));
}

//------------------------------------------------------------------------------
void FrameScene::SetRegion(vtkParticipatingMedium* medium, int region, Random& random)
{
  const glm::dvec3 centre = this->Unit * RandomPoint(random, 1.0);
  const double size = random.Index(6) ? random.LogUniform(0.3, 6.0) : random.LogUniform(1e-3, 1e4);
  const double half = this->Unit * size;
  medium->SetRegion(region);
  const double height = random.Index(10) ? half : 0.0; // of no volume
  medium->SetBounds(centre.x - half, centre.x + half, centre.y - height, centre.y + height,
    centre.z - 0.7 * half, centre.z + half);
  medium->SetCenter(&centre.x);
  medium->SetRadius(random.Index(15) ? half : 0.0);
  if (region == Medium::SURFACE)
  {
    medium->SetSurface(MakeClosedSurface(&centre.x, half, random));
  }
  this->Note("region ", region, " at ", Text3(&centre.x), " size ", size);
}

//------------------------------------------------------------------------------
void FrameScene::SetImage(vtkParticipatingMedium* medium, Random& random)
{
  vtkNew<vtkImageData> image;
  const int n = 2 + random.Index(4);
  image->SetDimensions(n, 3, n);
  const double spacing = this->Unit * random.Uniform(1.0, 4.0) / (n - 1);
  image->SetSpacing(spacing, spacing, spacing);
  const glm::dvec3 origin = this->Unit * (RandomPoint(random, 1.0) - glm::dvec3(1.5));
  image->SetOrigin(&origin.x);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    samples[i] = static_cast<float>(std::max(random.Uniform(-1.0, 1.5), 0.0));
  }
  medium->SetDensityImage(image);
}

//------------------------------------------------------------------------------
void FrameScene::AddMedium(size_t index, Random& random)
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetPhaseFunction(this->Group.Phase);
  switch (this->Group.Phase)
  {
    case Medium::HENYEY_GREENSTEIN:
    case Medium::SCHLICK:
    case Medium::CORNETTE_SHANKS:
      medium->SetAnisotropy(random.Index(3) ? this->Group.Anisotropy : -this->Group.Anisotropy);
      break;
    case Medium::TABULATED:
      medium->SetPhaseTable(MakeTable(this->Group.Number % 2 ? TABLE_RAINBOW : TABLE_SMOOTH));
      break;
    default:
      break;
  }
  this->SetCoefficients(medium, random);
  this->SetRegion(medium, this->Group.Regions[index], random);
  this->SetHeight(medium, random);
  const bool images = this->Group.Density == Medium::IMAGE;
  const int density = index == 0 ? this->Group.Density : static_cast<int>(index % (images ? 3 : 2));
  medium->SetDensity(density);
  if (density == Medium::IMAGE)
  {
    this->SetImage(medium, random);
  }
  if (this->Group.Number % 5 == 2 && medium->GetRegion() != Medium::UNBOUNDED)
  {
    const double emission = 0.1 / this->Unit;
    medium->SetEmission(emission, 0.0, 2.0 * emission);
  }
  this->Pass->AddMedium(medium);
  this->Media.emplace_back(medium);
}

//------------------------------------------------------------------------------
void FrameScene::ChangeMedium(Random& random)
{
  const size_t index = static_cast<size_t>(random.Index(static_cast<int>(this->Media.size())));
  vtkParticipatingMedium* medium = this->Media[index];
  const int change = random.Index(6);
  this->Note("medium ", index, " change ", change);
  switch (change)
  {
    case 0:
      this->SetHeight(medium, random);
      break;
    case 1:
      this->SetRegion(medium, medium->GetRegion(), random);
      break;
    case 2:
      if (vtkImageData* image = medium->GetDensityImage()) // in place
      {
        static_cast<float*>(image->GetScalarPointer())[0] = 0.7f;
        image->GetPointData()->GetScalars()->Modified();
        image->Modified();
      }
      break;
    case 3:
      if (vtkPolyData* surface = medium->GetSurface()) // in place
      {
        double p[3];
        surface->GetPoint(0, p);
        surface->GetPoints()->SetPoint(0, p[0] + 0.1 * this->Unit, p[1], p[2]);
        surface->GetPoints()->Modified();
      }
      break;
    default:
      this->SetCoefficients(medium, random);
  }
}
}
