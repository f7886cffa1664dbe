// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Density images with arrays of albedos and of factors of the emission in vtkAirlightPass, alone,
// in fog, in a sphere and beside another image, with lamps, a sun and ambient light, against
// vtkAirlightReference; an array of one albedo against the medium's own; an extinction for each
// colour, from three media, against the reference and against each alone.

#include "AirlightTestDensity.h"
#include "AirlightTestTools.h"

#include "vtkFloatArray.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// As of clouds in TestDensityPassMedia.
constexpr double Median = 1e-3;
constexpr double P99 = 1e-2;

vtkSmartPointer<vtkImageData> MakeColouredCloud(int points, std::uint64_t seed)
{
  vtkSmartPointer<vtkImageData> image =
    MakeDensity(glm::ivec3(points, points + 2, points + 1), glm::dvec3(-3, -2, -3), glm::dvec3(3));
  Rotate(image, 0.5, -0.3);
  FillCloud(image, seed);
  Random random(seed);
  AddColours(image, "Albedo", 1.0, random);
  AddColours(image, "Glow", 2.0, random);
  return image;
}

class ColouredScene : public DensityScene
{
public:
  explicit ColouredScene(std::uint64_t seed)
    : DensityScene(MakeColouredCloud(14, seed))
  {
    this->Medium->SetScattering(0.0, 0.0, 0.0);
    this->Medium->SetAbsorption(0.8, 0.9, 1.0);
    this->Medium->SetAlbedoArrayName("Albedo");
    this->AddBodies();
  }

  void AddMedium(vtkParticipatingMedium* medium)
  {
    this->Pass->AddMedium(medium);
    this->Reference->AddMedium(medium);
  }
};

//------------------------------------------------------------------------------
void TestAlone()
{
  ColouredScene scene(31);
  vtkLight* lamp = scene.AddPointLight({ 0.5, 2.2, -1.5 });
  scene.Compare("albedos, lamp inside", Median, P99);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.5);
  lamp->SetPosition(-4.5, 4.0, 1.0);
  scene.Compare("albedos, scattered forward, lamp outside", Median, P99);
  scene.Medium->SetAmbientRadiance(0.3, 0.5, 0.4);
  scene.Compare("albedos, ambient radiance", Median, P99);
  scene.Medium->SetEmission(0.2, 0.1, 0.05);
  scene.Medium->SetEmissionArrayName("Glow");
  scene.Compare("albedos and emission", Median, P99);
  scene.Medium->SetAlbedoArrayName("");
  scene.Compare("emission alone", Median, P99);
  lamp->SwitchOff();
  scene.AddDirectionalLight({ 1, 2, -0.5 });
  scene.Medium->SetAlbedoArrayName("Albedo");
  scene.Compare("albedos, sun", Median, P99);
}

void TestBesideOthers()
{
  ColouredScene scene(32);
  scene.AddPointLight({ 0.5, 2.2, -1.5 });
  scene.Medium->SetEmission(0.2, 0.1, 0.05);
  scene.Medium->SetEmissionArrayName("Glow");
  vtkNew<vtkParticipatingMedium> fog;
  fog->SetScattering(0.04, 0.05, 0.06);
  fog->SetAmbientRadiance(0.2, 0.2, 0.2);
  scene.AddMedium(fog);
  scene.Compare("colours in fog", Median, P99);
  vtkNew<vtkParticipatingMedium> ball;
  ball->SetDensityImage(MakeColouredCloud(11, 33));
  ball->SetDensityToImage();
  ball->SetScattering(0.4, 0.4, 0.4);
  ball->SetEmission(0.1, 0.3, 0.2);
  ball->SetEmissionArrayName("Glow");
  ball->SetRegionToSphere();
  ball->SetRadius(2.5);
  scene.AddMedium(ball);
  scene.Compare("colours in fog and in another image", Median, P99);
}

//------------------------------------------------------------------------------
void TestConstant()
{
  ColouredScene scene(34);
  scene.AddPointLight({ 0.5, 2.2, -1.5 });
  scene.Medium->SetAmbientRadiance(0.3, 0.5, 0.4);
  vtkNew<vtkFloatArray> colours;
  colours->SetName("Same");
  colours->SetNumberOfTuples(scene.Image->GetNumberOfPoints());
  colours->FillValue(0.25f);
  scene.Image->GetPointData()->AddArray(colours);
  scene.Medium->SetAlbedoArrayName("Same");
  scene.Reference->SetSize(48, 36);
  scene.Reference->SetScatteringOrders(3);
  scene.Reference->SetSamplesPerPixel(4);
  const auto trace = [&] {
    scene.Reference->Modified();
    scene.Reference->Update();
    vtkNew<vtkImageData> traced;
    traced->DeepCopy(scene.Reference->GetOutput());
    return vtkSmartPointer<vtkImageData>(traced);
  };
  scene.Window->Render();
  const vtkSmartPointer<vtkImageData> traced = trace();
  const Buffers buffers = scene.CopyBuffers();
  scene.Medium->SetAlbedoArrayName("");
  scene.Medium->SetScattering(0.2, 0.225, 0.25);
  scene.Medium->SetAbsorption(0.6, 0.675, 0.75);
  // The same random numbers give the same paths.
  traced->GetPointData()->SetActiveScalars("Airlight");
  CheckErrors(
    "one albedo, paths", traced, trace()->GetPointData()->GetArray("Airlight"), 1e-9, 1e-6);
  scene.Window->Render();
  for (const char* buffer : { "Airlight", "Transmittance", "Radiance" })
  {
    CheckErrors(std::string("one albedo, ") + buffer, buffers.at(buffer),
      scene.GetBuffer(buffer)->GetPointData()->GetScalars(), 1e-5, 1e-4);
  }
}

//------------------------------------------------------------------------------
// The image with one component of its scalars alone, three times: lights have colours.
vtkSmartPointer<vtkImageData> SpreadComponent(vtkImageData* image, int component)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> spread;
  spread->SetNumberOfComponents(3);
  spread->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (int c = 0; c < 3; ++c)
  {
    spread->CopyComponent(c, scalars, component);
  }
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  result->GetPointData()->SetScalars(spread);
  return result;
}

// Each medium has the densities of one colour, and is clear in the other two.
void TestExtinctions()
{
  DensityScene scene(MakeColouredCloud(12, 35));
  scene.AddBodies();
  scene.AddPointLight({ 0.5, 2.2, -1.5 });
  scene.AddDirectionalLight({ 1, 2, -0.5 });
  vtkNew<vtkParticipatingMedium> others[2];
  vtkParticipatingMedium* media[3] = { scene.Medium, others[0], others[1] };
  for (int c = 0; c < 3; ++c)
  {
    double coefficient[3] = { 0.0, 0.0, 0.0 };
    coefficient[c] = 0.6;
    media[c]->SetScattering(coefficient);
    media[c]->SetAbsorption(0.0, 0.0, 0.0);
    media[c]->SetAmbientRadiance(0.2, 0.2, 0.2);
    if (c > 0)
    {
      media[c]->SetDensityImage(MakeColouredCloud(12, 35 + c));
      media[c]->SetDensityToImage();
      scene.Pass->AddMedium(media[c]);
      scene.Reference->AddMedium(media[c]);
    }
  }
  scene.Compare("an extinction of each colour", Median, P99);
  const Buffers together = scene.CopyBuffers();
  for (int c = 0; c < 3; ++c)
  {
    scene.Pass->RemoveAllMedia();
    scene.Pass->AddMedium(media[c]);
    media[c]->SetScattering(0.6, 0.6, 0.6);
    scene.Window->Render();
    for (const char* buffer : { "Airlight", "Transmittance" })
    {
      const auto alone = SpreadComponent(scene.GetBuffer(buffer), c);
      const auto expected = SpreadComponent(together.at(buffer), c);
      CheckErrors(Text("colour ", c, " alone, ", buffer), alone,
        expected->GetPointData()->GetScalars(), 1e-5, 1e-3);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestDensityPassColours(int, char*[])
{
  TestAlone();
  TestBesideOthers();
  TestConstant();
  TestExtinctions();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
