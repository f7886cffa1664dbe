// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Images of density in vtkAirlightPass: an image of ones against the uniform box by its closed form
// and against vtkAirlightReference, clouds against vtkAirlightReference.

#include "AirlightTestDensity.h"

#include <chrono>
#include <cstdlib>

using namespace airlight_test;

namespace
{
// Of clouds. What the light's grid is in doubt by at most, 5e-3, is on few rays.
constexpr double Median = 5e-4;
constexpr double P99 = 5e-3;

double GetSeconds(Scene& scene)
{
  const auto start = std::chrono::steady_clock::now();
  scene.Window->Render();
  scene.GetBuffer("Airlight");
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
// The same scene in an image of ones and in the box that it fills.
void CompareOnes(const std::string& name, DensityScene& scene)
{
  std::cout << name << "\n";
  scene.Window->Render();
  const double cloud = GetSeconds(scene);
  const Buffers ones = scene.CopyBuffers();
  scene.Reference->SetSize(scene.Width, scene.Height);
  scene.Reference->Modified();
  scene.Reference->Update();
  CheckErrors(name + ", Airlight by the reference", ones.at("Airlight"),
    scene.Reference->GetOutput()->GetPointData()->GetArray("Airlight"), 1e-5, 1e-3);
  scene.Medium->SetDensityToUniform();
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(scene.Image->GetBounds());
  scene.Window->Render();
  const double uniform = GetSeconds(scene);
  for (const char* buffer : { "Airlight", "Transmittance", "Radiance" })
  {
    CheckErrors(name + ", " + buffer, ones.at(buffer),
      scene.GetBuffer(buffer)->GetPointData()->GetScalars(), 1e-5, 1e-4);
  }
  std::cout << "  a frame took " << cloud / uniform << " times that of the box, " << uniform
            << " s\n";
  scene.Medium->SetDensityToImage();
  scene.Medium->SetRegionToUnbounded();
}

void TestOnes()
{
  DensityScene scene(MakeDensity({ 9, 7, 12 }, { -4, -3, -4 }, { 4, 3, 12 }));
  vtkLight* lamp = scene.AddPointLight({ 0.5, 2.2, -1.5 });
  CompareOnes("ones, lamp inside, no shadows", scene);
  scene.AddBodies();
  CompareOnes("ones, lamp inside, shadows", scene);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.6);
  CompareOnes("ones, scattered forward", scene);
  lamp->SetPosition(2.0, 6.0, -2.0);
  scene.Look({ 0, 1, 18 }, { 0, 0, 0 });
  CompareOnes("ones, lamp and camera outside", scene);
  scene.Medium->SetPhaseFunctionToRayleigh();
  lamp->SwitchOff();
  scene.AddDirectionalLight({ 1, 2, -0.5 });
  CompareOnes("ones, sun", scene);
}

//------------------------------------------------------------------------------
void TestClouds()
{
  const vtkSmartPointer<vtkImageData> image =
    MakeDensity({ 24, 24, 24 }, glm::dvec3(-4), glm::dvec3(4));
  Rotate(image, 0.4, 0.7);
  FillCloud(image, 3);
  DensityScene scene(image);
  scene.Medium->SetScattering(0.3, 0.4, 0.5);
  vtkLight* lamp = scene.AddPointLight({ 0.5, 2.2, -1.5 });
  scene.AddBodies();
  scene.Compare("cloud, lamp inside", Median, P99);
  // Rays go on in one channel behind where another is dark.
  scene.Medium->SetScattering(0.3, 3.0, 40.0);
  scene.Compare(
    "cloud, blue light gone soon", 5e-3, 5e-2); // the grid is coarse there, by its bound
  scene.Medium->SetScattering(0.3, 0.4, 0.5);
  scene.Pass->SetShadowTechniqueToShadowMap();
  // What maps of shadows miss is not in the bound: airlight only.
  scene.Compare("cloud, shadow map", 1e-3, 5e-2, false);
  scene.Pass->SetShadowTechniqueToShadowPlanes();
  scene.Look({ 0.3, 0.5, 1.5 }, { 0, 0, -4 });
  scene.Compare("cloud, camera inside", Median, P99);
  scene.Look({ 0, 1, 10 }, { 0, 0, 0 });
  lamp->SetPosition(3.0, 7.0, -2.0);
  scene.Compare("cloud, lamp outside", Median, P99);
  lamp->SetPositional(1);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->SetConeAngle(20);
  lamp->SetExponent(3);
  scene.Compare("cloud, spot", Median, P99);
  lamp->SwitchOff();
  scene.AddDirectionalLight({ 1, 2, -0.5 });
  scene.Compare("cloud, sun", Median, P99);
}
}

//------------------------------------------------------------------------------
int TestDensityPass(int, char*[])
{
  TestOnes();
  TestClouds();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
