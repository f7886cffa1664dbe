// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What a volume takes away of light: against sums over many small steps that look up the volume's
// scalars and opacity function themselves. And the volumes that cannot cast shadows.

#include "AirlightTestCheck.h"
#include "AirlightTestCloudVolume.h"
#include "AirlightTestTools.h"

#include "Scene/AirlightVolumeExtinction.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkMultiVolume.h"
#include "vtkPlane.h"
#include "vtkSmartVolumeMapper.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;
using namespace airlight;

namespace
{
double SumSteps(vtkVolume* volume, const glm::dvec3& a, const glm::dvec3& b, double scale)
{
  const int steps = 2000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    sum += GetExtinctionAt(volume, glm::mix(a, b, (i + 0.5) / steps), scale);
  }
  return sum * glm::length(b - a) / steps;
}

vtkSmartPointer<vtkImageData> MakeCloudImage(int points, std::uint64_t seed)
{
  const auto image =
    MakeDensity(glm::ivec3(points, points + 2, points - 3), glm::dvec3(-2), glm::dvec3(2, 1, 3));
  FillCloud(image, seed);
  return image;
}

std::shared_ptr<const VolumeExtinction> Build(vtkVolume* volume)
{
  std::string error;
  const auto values = VolumeExtinction::Build(volume, volume->GetMatrix(), error);
  Check(error.empty(), "no error: " + error);
  return values;
}

// Depths of lines that begin or end in it are wrong by no more than this.
void CheckDepths(const std::string& name, vtkVolume* volume, double scale, std::uint64_t seed,
  double median, double largest)
{
  const auto values = Build(volume);
  if (!Check(values != nullptr, name + ": has extinction"))
  {
    return;
  }
  Random random(seed);
  std::vector<double> depths;
  std::vector<double> errors;
  for (int i = 0; i < 300; ++i)
  {
    const double* box = volume->GetBounds();
    const auto between = [&](double low, double high) {
      return glm::mix(glm::dvec3(box[0], box[2], box[4]), glm::dvec3(box[1], box[3], box[5]),
        glm::dvec3(
          random.Uniform(low, high), random.Uniform(low, high), random.Uniform(low, high)));
    };
    const glm::dvec3 a = between(-0.5, 1.5);
    const glm::dvec3 b = between(0.2, 0.8);
    const double length = glm::length(b - a);
    const double expected = SumSteps(volume, a, b, scale);
    const double error = std::abs(
      values->SigmaT * values->Grid->Integrate(a, (b - a) / length, 0.0, length) - expected);
    Check(expected > 0.0 || error < 1e-2, name + ": nothing beside it");
    if (expected > 0.0)
    {
      depths.push_back(expected);
      errors.push_back(error);
    }
  }
  Check(depths.size() > 50, name + ": lines through it");
  const double most = Quantile(depths, 1.0);
  std::cout << name << ": refined " << values->Refinement << ", depths up to " << most
            << ", errors: median " << Quantile(errors, 0.5) << ", largest " << Quantile(errors, 1.0)
            << "\n";
  Check(most > 0.5, name + ": takes light away");
  Check(Quantile(errors, 0.5) <= median, name + ": median error");
  Check(Quantile(errors, 1.0) <= largest, name + ": largest error");
}

// VTK does not notice that elements of an image's direction matrix changed.
void UpdateTransforms(vtkImageData* image)
{
  const glm::dvec3 origin(image->GetOrigin()[0], image->GetOrigin()[1], image->GetOrigin()[2]);
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetOrigin(origin.x, origin.y, origin.z);
}

//------------------------------------------------------------------------------
void TestDepths()
{
  const auto image = MakeCloudImage(18, 73021);
  const auto volume = MakeCloudVolume(image, 0.7, 0.8);
  CheckDepths("in its place", volume, 1.0, 73022, 1e-3, 1e-2);
  volume->SetScale(2.5);
  volume->RotateWXYZ(40, 1, 2, -1);
  volume->SetPosition(0.5, -1.0, 0.3);
  CheckDepths("scaled and rotated", volume, 2.5, 73023, 1e-3, 1e-2);
  volume->SetScale(1.0);
  Rotate(image, 0.4, 0.9);
  UpdateTransforms(image);
  CheckDepths("image of its own directions", volume, 1.0, 73024, 1e-3, 1e-2);
}

// A large volume has fewer samples than points, and as much depth.
void TestLarge()
{
  const auto image = MakeDensity(glm::ivec3(190, 140, 130), glm::dvec3(-2), glm::dvec3(2, 1, 3));
  FillCloud(image, 73025);
  const auto volume = MakeCloudVolume(image, 0.7, 0.8);
  const auto values = Build(volume);
  const glm::dvec3 last = values->Grid->GetLast();
  Check((last.x + 1) * (last.y + 1) * (last.z + 1) <= 2097152.0, "at most 128^3 samples");
  CheckDepths("more than 128^3 points", volume, 1.0, 73026, 1e-3, 1e-2);
}

// alpha 1 is opaque, alpha 0 clear.
void TestLimits()
{
  const auto image = MakeCloudImage(12, 73027);
  const auto volume = MakeCloudVolume(image, 1.0, 1.0);
  volume->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 1.0);
  const auto opaque = Build(volume);
  const double depth =
    opaque->SigmaT * opaque->Grid->Integrate(glm::dvec3(-2.0, 0, 0), glm::dvec3(1, 0, 0), 0, 0.4);
  Check(depth > 10.0 && std::isfinite(depth), Text("opaque: depth ", depth));
  volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.0);
  Check(Build(volume) == nullptr, "all transparent: none");
}

// Made again if what it depends on has changed, and not otherwise.
void TestCache()
{
  const auto image = MakeCloudImage(10, 73028);
  const auto volume = MakeCloudVolume(image, 0.5, 1.0);
  VolumeExtinctions cache;
  std::string error;
  const auto get = [&] { return cache.Get(volume, volume->GetMatrix(), error); };
  auto last = get();
  const auto expect = [&](bool changed, const std::string& what) {
    cache.Forget();
    const auto next = get();
    Check((next != last) == changed, what);
    last = next;
  };
  expect(false, "nothing changed");
  volume->GetProperty()->GetScalarOpacity()->AddPoint(1e-3, 0.2);
  expect(true, "opacity function");
  volume->GetProperty()->SetScalarOpacityUnitDistance(2.0);
  expect(true, "unit distance");
  volume->SetPosition(1, 2, 3);
  expect(true, "position");
  image->GetPointData()->GetScalars()->SetComponent(300, 0, 0.5);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  expect(true, "scalars");
  volume->GetProperty()->SetAmbient(0.3);
  expect(true, "property");
  for (int frame = 0; frame < 5; ++frame)
  {
    cache.Forget();
  }
  expect(true, "forgotten");
}

//------------------------------------------------------------------------------
// One reason with these words in it, and no extinction.
void CheckReason(vtkVolume* volume, const std::string& word)
{
  std::string error;
  Check(VolumeExtinction::Build(volume, volume->GetMatrix(), error) == nullptr, word + ": none");
  Check(error.find(word) != std::string::npos, "\"" + error + "\" names \"" + word + "\"");
}

void TestReasons()
{
  const auto image = MakeCloudImage(8, 73029);
  const auto make = [&] { return MakeCloudVolume(image, 0.5, 1.0); };
  const auto getMapper = [](vtkVolume* volume) {
    return vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  };
  auto volume = make();
  getMapper(volume)->SetBlendModeToMaximumIntensity();
  CheckReason(volume, "SetBlendModeToComposite()");
  volume = make();
  getMapper(volume)->CroppingOn();
  CheckReason(volume, "CroppingOff()");
  volume = make();
  vtkNew<vtkPlane> plane;
  volume->GetMapper()->AddClippingPlane(plane);
  CheckReason(volume, "RemoveAllClippingPlanes()");
  volume = make();
  vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper())->SetMaskInput(image);
  CheckReason(volume, "SetMaskInput(nullptr)");
  volume = make();
  volume->GetProperty()->GetGradientOpacity(); // makes one that is 1
  Check(Build(volume) != nullptr, "VTK's own gradient opacity");
  vtkNew<vtkPiecewiseFunction> gradients;
  gradients->AddPoint(0.0, 1.0);
  gradients->AddPoint(10.0, 0.5);
  volume->GetProperty()->SetGradientOpacity(gradients);
  CheckReason(volume, "DisableGradientOpacityOn()");
  volume->GetProperty()->DisableGradientOpacityOn();
  Check(Build(volume) != nullptr, "gradient opacity switched off");
  volume->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  CheckReason(volume, "SetTransferFunctionModeTo1D()");
  volume = make();
  vtkNew<vtkFixedPointVolumeRayCastMapper> fixedPoint;
  fixedPoint->SetInputData(image);
  volume->SetMapper(fixedPoint);
  CheckReason(volume, "vtkSmartVolumeMapper");
  volume->SetMapper(nullptr);
  CheckReason(volume, "no mapper");
  vtkNew<vtkSmartVolumeMapper> smart;
  volume->SetMapper(smart);
  CheckReason(volume, "vtkImageData");
  smart->SetInputData(image);
  Check(Build(volume) != nullptr, "a vtkSmartVolumeMapper");
  vtkNew<vtkMultiVolume> several;
  several->SetMapper(smart);
  CheckReason(several, "vtkSmartVolumeMapper");
}

void TestScalarReasons()
{
  const auto image = MakeCloudImage(8, 73030);
  const auto volume = MakeCloudVolume(image, 0.5, 1.0);
  image->GetPointData()->GetScalars()->SetComponent(
    70, 0, std::numeric_limits<double>::quiet_NaN());
  CheckReason(volume, "scalar 70 is nan");
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(5, 1, 5);
  flat->AllocateScalars(VTK_FLOAT, 1);
  vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper())->SetInputData(flat);
  CheckReason(volume, "5 x 1 x 5");
  vtkNew<vtkImageData> colours;
  colours->SetDimensions(3, 3, 3);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper())->SetInputData(colours);
  CheckReason(volume, "4 components");
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(3, 3, 3);
  vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper())->SetInputData(empty);
  CheckReason(volume, "no scalars");
}
}

//------------------------------------------------------------------------------
int TestVolumeExtinction(int, char*[])
{
  TestDepths();
  TestLarge();
  TestLimits();
  TestCache();
  TestReasons();
  TestScalarReasons();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
