// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A cloud from an image, lit from behind and above through a row of boards: their shadows run
// through the cloud, and its own falls on the floor, brown where blue has been scattered out. A
// small picture of it is compared with vtkAirlightReference, the large one with its baseline.

#include "AirlightTestDensity.h"

using namespace airlight_test;

//------------------------------------------------------------------------------
int TestCloudShafts(int argc, char* argv[])
{
  const vtkSmartPointer<vtkImageData> image =
    MakeDensity({ 40, 30, 40 }, { -4, -2, -4 }, { 4, 4, 4 });
  Rotate(image, 0.5, 0.1);
  FillCloud(image, 11);
  DensityScene scene(image);
  scene.Medium->SetScattering(0.25, 0.32, 0.42);
  scene.Medium->SetAbsorption(0.01, 0.01, 0.01);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.4);
  scene.AddPointLight({ 1.5, 9.5, -3.0 }, { 1100, 1050, 1000 });
  scene.AddBox({ -14, -3.2, -9 }, { 14, -3, 9 }, glm::dvec3(0.35));
  for (int i = 0; i < 3; ++i)
  {
    const double x = -0.9 + 1.3 * i;
    scene.AddBox({ x, 5.4, -3.4 }, { x + 0.35, 5.45, 0.6 }, glm::dvec3(0.1));
  }
  scene.Look({ 0, 2.5, 15 }, { 0, 0.9, 0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(42.0);
  scene.Compare("cloud with shafts", 5e-4, 5e-3);

  scene.Width = 640;
  scene.Height = 480;
  scene.Window->SetSize(640, 480);
  scene.Window->Render();
  return scene.Finish(argc, argv);
}
