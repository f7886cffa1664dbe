// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes that dim lights in vtkAirlightPass, in the air and on surfaces: against
// vtkAirlightReference, which sums small steps through the volumes' scalars.

#include "AirlightTestCloudVolume.h"
#include "AirlightTestErrors.h"

#include "vtkFixedPointVolumeRayCastMapper.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Median = 1e-3;
constexpr double P99 = 1e-2;

// A cloud above the ground, rotated and scaled, in air that the caller chooses.
class VolumeScene : public DensityScene
{
public:
  explicit VolumeScene(std::uint64_t seed)
    : DensityScene(MakeDensity(glm::ivec3(2), glm::dvec3(-4), glm::dvec3(4)), 48, 36)
  {
    const auto image =
      MakeDensity(glm::ivec3(22, 18, 20), glm::dvec3(-1.2, -0.8, -1.0), glm::dvec3(1.2, 0.8, 1.1));
    FillCloud(image, seed);
    this->Volume = MakeCloudVolume(image, 0.8, 0.7);
    this->Volume->SetScale(1.5);
    this->Volume->RotateWXYZ(30, 1, 2, 0.5);
    this->Volume->SetPosition(0.3, 1.4, 0.2);
    this->Renderer->AddVolume(this->Volume);
    this->Medium->SetDensityToUniform();
    this->Medium->SetScattering(0.05, 0.06, 0.07);
    this->Medium->SetAbsorption(0.01, 0.01, 0.01);
    this->Medium->SetPhaseFunctionToHenyeyGreenstein();
    this->Medium->SetAnisotropy(0.3);
    this->AddBodies();
    this->Pass->VolumeShadowsOn();
    this->Reference->VolumeShadowsOn();
  }

  void CompareShadows(const std::string& name)
  {
    this->Compare(name, Median, P99, false);
    this->CompareSurface(name);
  }

  void CompareSurface(const std::string& name)
  {
    CheckErrors(name + ", Surface", this->GetBuffer("Surface"),
      this->Reference->GetOutput()->GetPointData()->GetArray("Surface"), Median, P99);
  }

  // Lamps behind and in the cloud, a spot through it, a sun: one at a time.
  void CompareLights(const std::string& name)
  {
    vtkLight* lamp = this->AddPointLight({ 0.8, 4.2, -0.5 });
    this->CompareShadows(name + ", lamp behind the cloud");
    lamp->SetPosition(0.3, 1.5, 0.0);
    this->CompareShadows(name + ", lamp in the cloud");
    lamp->SetPosition(1.5, 5.0, -1.0);
    lamp->SetPositional(1);
    lamp->SetFocalPoint(0.2, 0, 0);
    lamp->SetConeAngle(25);
    this->CompareShadows(name + ", spot");
    lamp->SwitchOff();
    vtkLight* sun = this->AddDirectionalLight({ 0.4, 2, -0.3 });
    this->CompareShadows(name + ", sun");
    sun->SwitchOff();
  }

  vtkSmartPointer<vtkVolume> Volume;
  // It does not draw volumes, and says so.
  ErrorListener NotDrawn{ this->Reference, vtkCommand::WarningEvent };
};

//------------------------------------------------------------------------------
void TestFog()
{
  VolumeScene scene(73041);
  scene.CompareLights("fog");
}

void TestBox()
{
  VolumeScene scene(73042);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-5, 5, -2.4, 1.0, -5, 5);
  scene.CompareLights("a layer");
}

void TestHeightFog()
{
  VolumeScene scene(73043);
  scene.Medium->SetDensityToExponentialHeight();
  scene.Medium->SetScaleHeight(1.5);
  scene.Medium->SetReferenceHeight(-2.5);
  scene.CompareLights("height fog");
}

// A second volume, and a medium whose density is an image.
void TestSmoke()
{
  VolumeScene scene(73044);
  const auto smoke = MakeDensity(glm::ivec3(12), glm::dvec3(-3, -2.4, -3), glm::dvec3(3, 0, 3));
  FillCloud(smoke, 73045);
  scene.Medium->SetDensityImage(smoke);
  scene.Medium->SetDensityToImage();
  scene.Medium->SetScattering(0.4, 0.5, 0.6);
  const auto image = MakeDensity(glm::ivec3(14), glm::dvec3(-3, 0, -1), glm::dvec3(-1, 2, 1));
  FillCloud(image, 73046);
  scene.Renderer->AddVolume(MakeCloudVolume(image, 0.6, 0.7));
  scene.CompareLights("smoke, two volumes");
}

// Without a medium only surfaces show the shadow.
void TestVacuum()
{
  VolumeScene scene(73047);
  scene.Medium->SetScattering(0, 0, 0);
  scene.Medium->SetAbsorption(0, 0, 0);
  scene.AddPointLight({ 0.8, 4.2, -0.5 });
  for (const bool casts : { true, false })
  {
    scene.Pass->SetVolumeShadows(casts);
    scene.Reference->SetVolumeShadows(casts);
    scene.Reference->SetSize(scene.Width, scene.Height);
    scene.Reference->Update();
    scene.Window->Render();
    scene.CompareSurface(casts ? "vacuum" : "vacuum, no shadows of volumes");
  }
}

//------------------------------------------------------------------------------
double GetMean(Scene& scene, const char* name)
{
  vtkDataArray* values = scene.GetBuffer(name)->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sum += values->GetComponent(i, 0);
  }
  return sum / values->GetNumberOfTuples();
}

// Changes of the volume change the shadow; keys and volumes that cannot cast take it away.
void TestUpdates()
{
  VolumeScene scene(73048);
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.AddPointLight({ 0.8, 4.2, -0.5 });
  const auto draw = [&] {
    scene.Window->Render();
    return GetMean(scene, "Surface");
  };
  const double cast = draw();
  scene.Pass->VolumeShadowsOff();
  const double none = draw();
  Check(cast < 0.98 * none, Text("a shadow: ", cast, " and ", none));
  scene.Pass->VolumeShadowsOn();
  vtkAirlightPass::SetCastsShadow(scene.Volume, false);
  Check(draw() == none, "none by its key");
  vtkAirlightPass::SetCastsShadow(scene.Volume, true);
  Check(draw() == cast, "the same as before");
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(7.0);
  const double thin = draw();
  Check(thin > cast && thin < none, Text("a lighter shadow: ", thin));
  Check(warnings.Take() == 0, "no warning: " + warnings.GetText());
  vtkGPUVolumeRayCastMapper::SafeDownCast(scene.Volume->GetMapper())->CroppingOn();
  Check(draw() == none, "none of a cropped volume");
  draw();
  Check(warnings.Take() == 1 && warnings.GetText().find("CroppingOff()") != std::string::npos,
    "one warning: " + warnings.GetText());
}

// A volume shades itself as without shadows, and dims what is behind it.
void TestOwnShadow()
{
  VolumeScene scene(73049);
  scene.Volume->GetProperty()->ShadeOn();
  scene.Medium->SetScattering(0, 0, 0);
  scene.Medium->SetAbsorption(0, 0, 0);
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->AddVolume(scene.Volume);
  scene.AddPointLight({ 0.8, 4.2, -0.5 });
  const auto draw = [&] {
    scene.Window->Render();
    return GetMean(scene, "Radiance");
  };
  scene.Pass->VolumeShadowsOff();
  const double alone = draw();
  scene.Pass->VolumeShadowsOn();
  const double own = draw();
  Check(alone > 0.0 && std::abs(own - alone) <= 1e-5 * alone, Text(own, " as ", alone));
  const auto image = MakeDensity(glm::ivec3(8), glm::dvec3(-1, 2.8, -2), glm::dvec3(2, 3.8, 1));
  const auto above = MakeCloudVolume(image, 0.9, 0.5);
  above->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  above->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.9);
  above->GetProperty()->GetRGBTransferFunction()->RemoveAllPoints();
  above->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
  scene.Renderer->AddVolume(above);
  scene.Pass->VolumeShadowsOff();
  const double both = draw();
  scene.Pass->VolumeShadowsOn();
  const double dimmed = draw();
  Check(dimmed < 0.8 * both, Text("dimmed by another: ", dimmed, " of ", both));
}
}

//------------------------------------------------------------------------------
int TestVolumeShadows(int, char*[])
{
  TestFog();
  TestBox();
  TestHeightFog();
  TestSmoke();
  TestVacuum();
  TestUpdates();
  TestOwnShadow();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
