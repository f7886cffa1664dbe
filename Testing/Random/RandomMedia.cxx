// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The media of a random scene.

#include "RandomParts.h"
#include "RandomScene.h"

#include "AirlightTestPhaseTable.h"

#include "vtkCubeSource.h"
#include "vtkMatrix3x3.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

namespace airlight_test
{
namespace
{
// A closed body, convex or not, in [-1, 1]^3.
vtkSmartPointer<vtkPolyData> MakeClosedBody(Random& random)
{
  if (random.Index(2))
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(random.Uniform(0.5, 2.0));
    box->SetYLength(2.0);
    box->SetZLength(1.6);
    return airlight_test::Make(box);
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(3 + random.Index(8));
  sphere->SetPhiResolution(3 + random.Index(8));
  vtkSmartPointer<vtkPolyData> body = airlight_test::Make(sphere);
  const double dent = random.Index(2) ? random.Uniform(0.2, 0.9) : 1.0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); i += 3)
  {
    double p[3];
    body->GetPoint(i, p);
    body->GetPoints()->SetPoint(i, dent * p[0], dent * p[1], dent * p[2]);
  }
  return body;
}
}

//------------------------------------------------------------------------------
void RandomScene::ChoosePhase(vtkParticipatingMedium* medium)
{
  const double sign = this->Numbers.Index(3) ? 1.0 : -1.0; // of as many poles
  medium->SetPhaseFunction(this->Group.Phase);
  switch (this->Group.Phase)
  {
    case vtkParticipatingMedium::HENYEY_GREENSTEIN:
    case vtkParticipatingMedium::SCHLICK:
    case vtkParticipatingMedium::CORNETTE_SHANKS:
      medium->SetAnisotropy(sign * this->Group.Anisotropy);
      break;
    case vtkParticipatingMedium::TABULATED:
      medium->SetPhaseTable(MakeTable(this->Group.Number % 2 ? TABLE_RAINBOW : TABLE_SMOOTH));
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
void RandomScene::ChooseRegion(vtkParticipatingMedium* medium, int region)
{
  Random& random = this->Numbers;
  const glm::dvec3 centre = RandomPoint(random, 1.0);
  double size = random.LogUniform(0.3, 6.0);
  size = random.Index(10) == 0 ? random.LogUniform(1e-4, 1e4) : size;
  double bounds[6];
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] = this->Unit * (centre[i / 2] + (i % 2 ? size : -size) * random.Uniform(0.3, 1.0));
  }
  medium->SetRegion(region);
  medium->SetBounds(bounds);
  medium->SetCenter(this->Unit * centre.x, this->Unit * centre.y, this->Unit * centre.z);
  medium->SetRadius(this->Unit * size);
  if (region == vtkParticipatingMedium::SURFACE)
  {
    vtkNew<vtkTransform> transform;
    transform->Scale(this->Unit, this->Unit, this->Unit);
    transform->Translate(&centre.x);
    const glm::dvec3 axis = RandomUnit(random);
    transform->RotateWXYZ(random.Uniform(0.0, 180.0), &axis.x);
    transform->Scale(size, size, size);
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetInputData(MakeClosedBody(random));
    filter->SetTransform(transform);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->Update();
    medium->SetSurface(filter->GetOutput());
  }
  this->Text += airlight_test::Text("; region ", region, " at ", Text3(&centre.x), " size ", size);
}

//------------------------------------------------------------------------------
void RandomScene::ChooseDensity(vtkParticipatingMedium* medium)
{
  Random& random = this->Numbers;
  medium->SetDensity(this->Group.Density);
  medium->SetScaleHeight(this->Unit * random.LogUniform(0.3, 10.0));
  medium->SetReferenceHeight(this->Unit * random.Uniform(-1.5, 1.5));
  const glm::dvec3 up = random.Index(2) ? RandomUnit(random) : glm::dvec3(0.0, 1.0, 0.0);
  medium->SetUp(&up.x);
  if (this->Group.Density != vtkParticipatingMedium::IMAGE)
  {
    return;
  }
  vtkNew<vtkImageData> image;
  int size[3];
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = 2 + random.Index(6);
    spacing[axis] = this->Unit * random.Uniform(1.0, 4.0) / (size[axis] - 1);
  }
  image->SetDimensions(size);
  image->SetSpacing(spacing);
  const glm::dvec3 origin = this->Unit * (RandomPoint(random, 1.0) - glm::dvec3(1.5));
  image->SetOrigin(&origin.x);
  vtkNew<vtkTransform> turn;
  const glm::dvec3 axis = RandomUnit(random);
  turn->RotateWXYZ(random.Index(2) ? 30.0 : 0.0, &axis.x);
  for (int i = 0; i < 9; ++i)
  {
    image->GetDirectionMatrix()->SetElement(
      i / 3, i % 3, turn->GetMatrix()->GetElement(i / 3, i % 3));
  }
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    samples[i] = static_cast<float>(std::max(random.Uniform(-0.5, 1.5), 0.0));
  }
  medium->SetDensityImage(image);
}

//------------------------------------------------------------------------------
void RandomScene::AddMedia()
{
  Random& random = this->Numbers;
  for (int region : this->Group.Regions)
  {
    auto medium = vtkSmartPointer<vtkParticipatingMedium>::New();
    // From air of which little is seen to soup in which one sees the next part hardly; clear at
    // times.
    const double density = (random.Index(20) ? random.LogUniform(1e-3, 3.0) : 0.0) / this->Unit;
    const double other = this->Group.Grey ? 1.0 : random.LogUniform(0.1, 3.0);
    const double last = this->Group.Grey ? 1.0 : random.LogUniform(0.1, 3.0);
    const double albedo = random.Index(3) ? random.Uniform(0.1, 1.0) : 1.0;
    const double blue = this->Group.Grey ? albedo : random.Uniform(0.0, 1.0);
    medium->SetScattering(albedo * density, albedo * other * density, blue * last * density);
    medium->SetAbsorption(
      (1.0 - albedo) * density, (1.0 - albedo) * other * density, (1.0 - blue) * last * density);
    if (random.Index(5) == 0)
    {
      medium->SetAmbientRadiance(0.3, 0.2, 0.1);
    }
    this->Text += airlight_test::Text(
      "; sigmaS ", Text3(medium->GetScattering()), " sigmaA ", Text3(medium->GetAbsorption()));
    this->ChoosePhase(medium);
    this->ChooseRegion(medium, region);
    this->ChooseDensity(medium);
    this->Scene.Pass->AddMedium(medium);
    this->Media.push_back(medium);
  }
}
}
