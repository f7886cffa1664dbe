// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Images of density beside other media in vtkAirlightPass: smoke in fog, in height fog, in a tank,
// flames, two clouds that overlap; against vtkAirlightReference. Two images of half the density are one.

#include "AirlightTestDensity.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
// What the light's grids are in doubt by at most is on few rays.
constexpr double Median = 1e-3;
constexpr double P99 = 1e-2;

vtkSmartPointer<vtkImageData> MakeCloud(
  int points, const glm::dvec3& low, const glm::dvec3& high, std::uint64_t seed)
{
  const vtkSmartPointer<vtkImageData> image = MakeDensity(glm::ivec3(points), low, high);
  Rotate(image, 0.5, -0.3);
  FillCloud(image, seed);
  return image;
}

// Smoke in the middle of the scene, and what else is in the air.
class SmokeScene : public DensityScene
{
public:
  explicit SmokeScene(std::uint64_t seed)
    : DensityScene(MakeCloud(20, glm::dvec3(-3, -2, -3), glm::dvec3(3, 3, 3), seed))
  {
    this->Medium->SetScattering(0.5, 0.6, 0.7);
    this->Medium->SetAbsorption(0.3, 0.3, 0.3);
    this->Medium->SetPhaseFunctionToHenyeyGreenstein();
    this->Medium->SetAnisotropy(0.4);
    this->AddBodies();
  }

  void AddMedium(vtkParticipatingMedium* medium)
  {
    this->Pass->AddMedium(medium);
    this->Reference->AddMedium(medium);
  }

  // Lamps in the smoke and beside it, a spot, a sun: one at a time.
  void CompareLights(const std::string& name)
  {
    vtkLight* lamp = this->AddPointLight({ 0.5, 2.2, -1.5 });
    this->Compare(name + ", lamp in the smoke", Median, P99);
    lamp->SetPosition(-4.5, 4.0, 1.0);
    this->Compare(name + ", lamp beside the smoke", Median, P99);
    lamp->SetPositional(1);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetConeAngle(25);
    this->Compare(name + ", spot", Median, P99);
    lamp->SwitchOff();
    vtkLight* sun = this->AddDirectionalLight({ 1, 2, -0.5 });
    this->Compare(name + ", sun", Median, P99);
    sun->SwitchOff();
  }
};

//------------------------------------------------------------------------------
void TestBox()
{
  SmokeScene scene(11);
  vtkNew<vtkParticipatingMedium> tank;
  tank->SetRegionToBox();
  tank->SetBounds(-5, 5, -2.4, 1.0, -5, 5);
  tank->SetScattering(0.05, 0.08, 0.12);
  scene.AddMedium(tank);
  scene.CompareLights("smoke and a layer");
}

void TestFog()
{
  SmokeScene scene(12);
  vtkNew<vtkParticipatingMedium> fog;
  fog->SetScattering(0.04, 0.04, 0.04);
  fog->SetAbsorption(0.01, 0.01, 0.01);
  scene.AddMedium(fog);
  scene.CompareLights("smoke in fog");
}

void TestHeightFog()
{
  SmokeScene scene(13);
  vtkNew<vtkParticipatingMedium> fog;
  fog->SetDensityToExponentialHeight();
  fog->SetScaleHeight(1.5);
  fog->SetReferenceHeight(-2.5);
  fog->SetScattering(0.1, 0.1, 0.1);
  scene.AddMedium(fog);
  scene.CompareLights("smoke in height fog");
  fog->SetAmbientRadiance(0.2, 0.3, 0.4);
  scene.Look({ 0, -2, 10 }, { 0, 0, 0 });
  scene.Compare("smoke in height fog, ambient radiance", Median, P99);
}

void TestClouds()
{
  SmokeScene scene(14);
  vtkNew<vtkParticipatingMedium> cloud;
  const vtkSmartPointer<vtkImageData> image =
    MakeCloud(17, glm::dvec3(-1, -2, -2), glm::dvec3(5, 2, 4), 15);
  cloud->SetDensityImage(image);
  cloud->SetDensityToImage();
  cloud->SetScattering(0.7, 0.3, 0.2);
  cloud->SetRegionToSphere();
  cloud->SetCenter(2.0, 0.0, 1.0);
  cloud->SetRadius(2.5);
  scene.AddMedium(cloud);
  scene.CompareLights("two clouds");
  scene.Medium->SetAmbientRadiance(0.4, 0.5, 0.6);
  scene.Compare("two clouds, ambient radiance", Median, P99);
}

//------------------------------------------------------------------------------
// Flames, which emit but take no light away, behind and in smoke.
void TestFlames()
{
  SmokeScene scene(17);
  vtkNew<vtkParticipatingMedium> flames;
  const vtkSmartPointer<vtkImageData> image =
    MakeCloud(14, glm::dvec3(-1, -2.5, -1), glm::dvec3(1, 1, 1), 18);
  flames->SetDensityImage(image);
  flames->SetDensityToImage();
  flames->SetEmission(6.0, 2.0, 0.5);
  scene.AddMedium(flames);
  vtkNew<vtkParticipatingMedium> glow;
  glow->SetRegionToSphere();
  glow->SetCenter(-2, 1, 0);
  glow->SetRadius(1.5);
  glow->SetAbsorption(0.2, 0.0, 0.1);
  glow->SetEmission(0.0, 0.2, 0.1);
  scene.AddMedium(glow);
  // At the rim, where they are a millionth as bright, rounding of places is more than the bound.
  scene.Compare("flames in smoke", 1e-4, 1e-3, false);
}

//------------------------------------------------------------------------------
// Optical depths add: two images of half the density are one.
void TestHalves()
{
  DensityScene scene(MakeCloud(20, glm::dvec3(-3), glm::dvec3(3), 16));
  scene.Medium->SetScattering(0.8, 0.8, 0.8);
  scene.Medium->SetAmbientRadiance(0.1, 0.1, 0.1);
  scene.AddBodies();
  scene.AddPointLight({ 3.5, 3.0, 1.0 });
  scene.Window->Render();
  const Buffers whole = scene.CopyBuffers();
  scene.Medium->SetScattering(0.4, 0.4, 0.4);
  vtkNew<vtkParticipatingMedium> other;
  other->SetDensityImage(scene.Image);
  other->SetDensityToImage();
  other->SetScattering(0.4, 0.4, 0.4);
  other->SetAmbientRadiance(0.1, 0.1, 0.1);
  scene.Pass->AddMedium(other);
  scene.Window->Render();
  for (const char* buffer : { "Airlight", "Transmittance", "Radiance" })
  {
    CheckErrors(std::string("halves, ") + buffer, scene.GetBuffer(buffer),
      whole.at(buffer)->GetPointData()->GetScalars(), 1e-4, 1e-3);
  }
}
}

//------------------------------------------------------------------------------
int TestDensityPassMedia(int argc, char* argv[])
{
  const std::string only = argc > 1 ? argv[1] : "";
  const std::pair<const char*, std::function<void()>> tests[] = { { "box", TestBox },
    { "fog", TestFog }, { "height", TestHeightFog }, { "clouds", TestClouds },
    { "flames", TestFlames }, { "halves", TestHalves } };
  for (const auto& test : tests)
  {
    if (only.empty() || only[0] == '-' || only == test.first)
    {
      test.second();
    }
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
