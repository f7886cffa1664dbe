// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Fog beside bounded media: what rays scatter where neither they nor the ways to the lamp meet those
// is taken in closed form. With an attenuation that has none, all of each ray is integrated
// numerically: the same airlight.

#include "AirlightTestDensity.h"
#include "AirlightTestErrors.h"
#include "AirlightTestWindowScene.h"

#include "vtkSphereSource.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

using namespace airlight_test;

namespace
{
struct Kind
{
  const char* Name;
  std::function<void(vtkParticipatingMedium*)> Shape;
};

std::vector<Kind> GetKinds()
{
  return { { "a box",
             [](vtkParticipatingMedium* medium) {
               medium->SetRegionToBox();
               medium->SetBounds(-2.5, -0.5, -1.0, 1.5, -1.0, 1.0);
             } },
    { "a sphere",
      [](vtkParticipatingMedium* medium) {
        medium->SetRegionToSphere();
        medium->SetCenter(1.0, 0.5, -0.5);
        medium->SetRadius(1.2);
      } },
    { "a cylinder",
      [](vtkParticipatingMedium* medium) {
        medium->SetRegionToCylinder();
        medium->SetCenter(-1.0, 0.0, 0.5);
        medium->SetAxis(1.0, 2.0, -1.0);
        medium->SetRadius(0.6);
        medium->SetHeight(2.5);
      } },
    { "a closed surface",
      [](vtkParticipatingMedium* medium) {
        vtkNew<vtkSphereSource> ball;
        ball->SetCenter(0.5, 0.0, 0.5);
        ball->SetRadius(1.1);
        ball->Update();
        medium->SetRegionToSurface();
        medium->SetSurface(ball->GetOutput());
      } },
    { "an image with empty borders",
      [](vtkParticipatingMedium* medium) {
        const auto image = MakeDensity({ 9, 8, 10 }, { -3, -2, -2 }, { 3, 3, 2.5 });
        FillCloud(image, 71300);
        for (int k = 0; k < 10; ++k)
        {
          for (int j = 0; j < 8; ++j)
          {
            for (int i = 0; i < 9; ++i)
            {
              const bool empty = i < 2 || i > 5 || j < 1 || j > 5 || k < 3 || k > 7;
              image->SetScalarComponentFromDouble(
                i, j, k, 0, empty ? 0.0 : image->GetScalarComponentAsDouble(i, j, k, 0));
            }
          }
        }
        Rotate(image, 0.6, -0.4);
        medium->SetDensityImage(image);
        medium->SetDensityToImage();
      } },
    { "two of them",
      [](vtkParticipatingMedium* medium) {
        medium->SetRegionToSphere();
        medium->SetCenter(-1.5, 0.5, -0.5);
        medium->SetRadius(0.7);
      } },
    { "an image without density", [](vtkParticipatingMedium* medium) {
       const auto image = MakeDensity({ 4, 5, 3 }, { -1, -1, -1 }, { 1, 1, 1 });
       image->GetPointData()->GetScalars()->Fill(0.0);
       medium->SetDensityImage(image);
       medium->SetDensityToImage();
     } } };
}

const glm::dvec3 Lamps[] = {
  { 3.0, 4.0, 2.0 },  // to one side
  { -4.0, 0.3, 0.2 }, // level with the media: shadows without end
  { 0.0, 0.5, 12.0 }, // behind the camera
  { 0.3, 1.4, 0.2 },  // in the midst
};

double largest = 0.0;

// Each phase function compiles for itself.
void SetPhase(vtkParticipatingMedium* medium, bool mie)
{
  if (mie)
  {
    medium->SetPhaseFunctionToMieHazy();
    return;
  }
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(0.6);
}

//------------------------------------------------------------------------------
void TestBeside(const Kind& kind, int lamp)
{
  const std::string name = Text(kind.Name, ", lamp ", lamp);
  WindowScene scene(60, 45, 0);
  scene.Renderer->RemoveAllLights();
  scene.Lights.clear();
  vtkLight* light = scene.AddPointLight(Lamps[lamp]);
  scene.Medium->SetRegionToUnbounded();
  scene.Medium->SetScattering(0.05, 0.06, 0.08);
  SetPhase(scene.Medium, lamp == 1 && std::string(kind.Name) == "a box");
  const Buffers fog = scene.Render();
  vtkNew<vtkParticipatingMedium> other;
  other->SetScattering(0.5, 0.4, 0.3);
  other->SetAbsorption(0.3, 0.3, 0.3);
  kind.Shape(other);
  if (std::string(kind.Name) == "two of them")
  {
    // The fog is neither the first nor the last.
    vtkNew<vtkParticipatingMedium> box;
    GetKinds()[0].Shape(box);
    box->SetScattering(0.2, 0.4, 0.3);
    scene.Pass->RemoveAllMedia();
    scene.Pass->AddMedium(box);
    scene.Pass->AddMedium(scene.Medium);
  }
  scene.Pass->AddMedium(other);
  for (const bool shadows : { false, true })
  {
    if (shadows && lamp != 0)
    {
      continue;
    }
    shadows ? scene.Pass->SetShadowTechniqueToShadowPlanes()
            : scene.Pass->SetShadowTechniqueToNone();
    light->SetAttenuationValues(0.0, 0.0, 1.0);
    const Buffers closed = scene.Render();
    light->SetAttenuationValues(1e-12, 0.0, 1.0);
    const Buffers numeric = scene.Render();
    const double error = CompareBuffers(numeric.at("Airlight"), closed.at("Airlight"));
    largest = std::max(largest, error);
    Check(error < 2e-4, Text(name, shadows ? "" : ", no shadows", ": difference ", error));
    const double effect = CompareBuffers(fog.at("Airlight"), closed.at("Airlight"));
    const bool isEmpty = std::string(kind.Name).find("without density") != std::string::npos;
    Check(isEmpty || shadows || effect > 2e-3, Text(name, ": the medium is seen, ", effect));
  }
}
}

//------------------------------------------------------------------------------
int TestMediaBeside(int, char*[])
{
  for (const Kind& kind : GetKinds())
  {
    for (int lamp = 0; lamp < 4; ++lamp)
    {
      TestBeside(kind, lamp);
    }
  }
  std::cout << "largest difference: " << largest << "\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
