// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Twelve mixtures of media of random numbers, with a lamp, a spot and a sun, by shadow planes and
// by shadow maps: vtkAirlightPass against vtkAirlightReference, 72 pictures. And as many media as
// there can be, of all kinds, in one more. An argument chooses: 0 or 1, every other one; or a name.

#include "AirlightTestCloudVolume.h"
#include "AirlightTestDensity.h"
#include "AirlightTestTools.h"

#include "vtkSphereSource.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
constexpr double Median = 1e-3;
constexpr double P99 = 1e-2;
// A map has no exact edges, and errors are of a pixel's own light, down to a thousandth of the
// brightest.
constexpr double MapP99 = 5e-2;
// Of the picture's mean airlight.
constexpr double MapP99OfMean = 2e-2;

class MixtureScene : public DensityScene
{
public:
  explicit MixtureScene(std::uint64_t seed)
    : DensityScene(MakeDensity(glm::ivec3(2), glm::dvec3(-9), glm::dvec3(9)), 64, 48)
    , Numbers(seed)
    , Seed(seed)
  {
    this->Pass->RemoveAllMedia();
    this->Reference->RemoveAllMedia();
    this->AddBodies();
  }

  vtkParticipatingMedium* AddMedium(double thickness)
  {
    auto medium = vtkSmartPointer<vtkParticipatingMedium>::New();
    glm::dvec3 scattering;
    glm::dvec3 absorption;
    for (int c = 0; c < 3; ++c)
    {
      scattering[c] = thickness * this->Numbers.LogUniform(0.5, 2.0);
      absorption[c] = thickness * this->Numbers.Uniform(0.0, 0.5);
    }
    medium->SetScattering(&scattering.x);
    medium->SetAbsorption(&absorption.x);
    medium->SetPhaseFunctionToHenyeyGreenstein();
    medium->SetAnisotropy(this->Numbers.Uniform(-0.3, 0.7));
    this->Pass->AddMedium(medium);
    this->Reference->AddMedium(medium);
    this->Media.push_back(medium);
    return medium;
  }

  void AddFog() { this->AddMedium(0.04); }

  void AddHeightFog()
  {
    vtkParticipatingMedium* fog = this->AddMedium(0.12);
    fog->SetDensityToExponentialHeight();
    fog->SetScaleHeight(this->Numbers.Uniform(0.8, 2.0));
    fog->SetReferenceHeight(-2.5);
  }

  vtkParticipatingMedium* AddCloud()
  {
    const glm::dvec3 centre = RandomPoint(this->Numbers, 0.8);
    const vtkSmartPointer<vtkImageData> image =
      MakeDensity(glm::ivec3(14, 16, 15), centre - 2.2, centre + 2.2);
    Rotate(image, this->Numbers.Uniform(-0.6, 0.6), this->Numbers.Uniform(-0.6, 0.6));
    FillCloud(image, ++this->Seed);
    vtkParticipatingMedium* cloud = this->AddMedium(0.6);
    cloud->SetDensityImage(image);
    cloud->SetDensityToImage();
    return cloud;
  }

  vtkParticipatingMedium* AddColouredFlames()
  {
    vtkParticipatingMedium* flames = this->AddCloud();
    AddColours(flames->GetDensityImage(), "Albedo", 1.0, this->Numbers);
    AddColours(flames->GetDensityImage(), "Glow", 1.0, this->Numbers);
    flames->SetAlbedoArrayName("Albedo");
    flames->SetEmissionArrayName("Glow");
    flames->SetEmission(0.3, 0.2, 0.1);
    return flames;
  }

  void PutInto(vtkParticipatingMedium* medium, int region)
  {
    const glm::dvec3 centre = RandomPoint(this->Numbers, 1.0);
    medium->SetRegion(region);
    medium->SetCenter(centre.x, centre.y, centre.z);
    medium->SetRadius(2.0);
    medium->SetHeight(3.0);
    medium->SetBounds(centre.x - 2.5, centre.x + 2.0, centre.y - 1.5, centre.y + 2.0,
      centre.z - 2.0, centre.z + 1.5);
    if (region == vtkParticipatingMedium::SURFACE)
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetCenter(centre.x, centre.y, centre.z);
      ball->SetRadius(1.8);
      ball->Update();
      medium->SetSurface(ball->GetOutput());
    }
  }

  // A volume that is a medium.
  void AddVolume()
  {
    const auto image = MakeDensity(glm::ivec3(16), glm::dvec3(-1.5), glm::dvec3(1.5));
    FillCloud(image, ++this->Seed);
    this->Volume = MakeCloudVolume(image, 0.6, 0.7);
    this->Volume->SetPosition(0.4, 0.6, -0.5);
    this->Renderer->AddVolume(this->Volume);
    vtkAirlightPass::SetVolumeScatters(this->Volume, true);
  }

  // Two clouds, all kinds of regions, fog and height fog.
  void AddEight()
  {
    this->AddFog();
    this->AddHeightFog();
    this->AddCloud();
    this->AddCloud();
    for (const int region : { vtkParticipatingMedium::BOX, vtkParticipatingMedium::SPHERE,
           vtkParticipatingMedium::CYLINDER, vtkParticipatingMedium::SURFACE })
    {
      this->PutInto(this->AddMedium(0.1), region);
    }
  }

  void ComparePlanes(const std::string& name)
  {
    this->Pass->SetShadowTechniqueToShadowPlanes();
    // The bound of closed forms is far above their rounding.
    this->Compare(name + ", planes", Median, P99, this->HasQuadrature);
  }

  void CompareAll(const std::string& name)
  {
    vtkLight* lamp = this->AddLamp();
    this->CompareTechniques(name + ", lamp");
    lamp->SetPosition(-4.5, 4.0, 1.0);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetConeAngle(30);
    this->CompareTechniques(name + ", spot");
    lamp->SwitchOff();
    this->AddDirectionalLight({ 1, 2, -0.5 });
    this->CompareTechniques(name + ", sun");
  }

  vtkLight* AddLamp() { return this->AddPointLight({ 0.5, 2.2, -1.5 }); }

  bool HasQuadrature = true;

private:
  void CompareTechniques(const std::string& name)
  {
    this->ComparePlanes(name);
    this->Pass->SetShadowTechniqueToShadowMap();
    this->Compare(name + ", map", Median, MapP99);
    CheckErrorsOfMean(name + ", map", this->GetBuffer("Airlight"),
      this->Reference->GetOutput()->GetPointData()->GetArray("Airlight"), MapP99OfMean);
  }

  Random Numbers;
  std::uint64_t Seed;
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
  vtkSmartPointer<vtkVolume> Volume;
};

const std::pair<const char*, std::function<void(MixtureScene&)>> Mixtures[] = {
  { "fog and height fog",
    [](MixtureScene& scene) {
      scene.AddFog();
      scene.AddHeightFog();
      scene.HasQuadrature = false;
    } },
  { "a box and a sphere of fog",
    [](MixtureScene& scene) {
      scene.PutInto(scene.AddMedium(0.2), vtkParticipatingMedium::BOX);
      scene.PutInto(scene.AddMedium(0.2), vtkParticipatingMedium::SPHERE);
    } },
  { "a cylinder and a closed surface of fog",
    [](MixtureScene& scene) {
      scene.PutInto(scene.AddMedium(0.2), vtkParticipatingMedium::CYLINDER);
      scene.PutInto(scene.AddMedium(0.2), vtkParticipatingMedium::SURFACE);
    } },
  { "a cloud in fog",
    [](MixtureScene& scene) {
      scene.AddCloud();
      scene.AddFog();
    } },
  { "two clouds",
    [](MixtureScene& scene) {
      scene.AddCloud();
      scene.AddCloud();
    } },
  { "a cloud in a sphere, in height fog",
    [](MixtureScene& scene) {
      scene.PutInto(scene.AddCloud(), vtkParticipatingMedium::SPHERE);
      scene.AddHeightFog();
    } },
  { "coloured flames in fog",
    [](MixtureScene& scene) {
      scene.AddColouredFlames();
      scene.AddFog();
    } },
  { "a cloud in a cylinder and one in a box of fog",
    [](MixtureScene& scene) {
      scene.PutInto(scene.AddCloud(), vtkParticipatingMedium::CYLINDER);
      scene.PutInto(scene.AddMedium(0.2), vtkParticipatingMedium::BOX);
      scene.AddCloud();
    } },
  { "a volume in fog",
    [](MixtureScene& scene) {
      scene.AddVolume();
      scene.AddFog();
    } },
  { "a cloud in fog, in height fog and in a box of fog",
    [](MixtureScene& scene) {
      scene.AddFog();
      scene.AddHeightFog();
      scene.AddCloud();
      scene.PutInto(scene.AddMedium(0.1), vtkParticipatingMedium::BOX);
    } },
  { "a cloud in a closed surface",
    [](MixtureScene& scene) { scene.PutInto(scene.AddCloud(), vtkParticipatingMedium::SURFACE); } },
  { "coloured flames in a closed surface, and a cloud, in fog",
    [](MixtureScene& scene) {
      scene.PutInto(scene.AddColouredFlames(), vtkParticipatingMedium::SURFACE);
      scene.AddCloud();
      scene.AddFog();
    } },
};
}

//------------------------------------------------------------------------------
int TestMediaCombinations(int argc, char* argv[])
{
  const std::string only = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
  int number = 0;
  for (const auto& [name, add] : Mixtures)
  {
    ++number;
    if (only.empty() || only == name || only == std::to_string(number % 2))
    {
      MixtureScene scene(71000 + 10 * number);
      add(scene);
      scene.CompareAll(name);
    }
  }
  if (only.empty() || only == "eight media" || only == "1")
  {
    MixtureScene scene(71200);
    scene.AddEight();
    scene.AddLamp();
    scene.ComparePlanes("eight media");
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
