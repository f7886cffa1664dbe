// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Images of density that vtkAirlightPass cannot draw: one error each that names the medium and the
// remedy, and the scene as without the medium. Bad values, missing images: the medium is nowhere.

#include "AirlightTestDensity.h"
#include "AirlightTestErrors.h"

#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
void CheckText(ErrorListener& listener, const std::string& part, const std::string& what)
{
  Check(listener.Take() == 1, what + ": one message");
  Check(listener.GetText().find(part) != std::string::npos,
    what + ": it says '" + part + "', not: " + listener.GetText());
}

std::vector<unsigned char> GetPicture(Scene& scene)
{
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> colours;
  scene.Window->GetPixelData(0, 0, scene.Width - 1, scene.Height - 1, 0, colours);
  const unsigned char* first = colours->GetPointer(0);
  return std::vector<unsigned char>(first, first + colours->GetNumberOfValues());
}

double GetTransmittance(Scene& scene)
{
  scene.Window->Render();
  return GetColour(scene.GetBuffer("Transmittance"), scene.Width / 2, scene.Height / 2).x;
}

//------------------------------------------------------------------------------
void CheckCombinations(DensityScene& scene)
{
  ErrorListener errors(scene.Pass);
  const std::vector<unsigned char> fogged = GetPicture(scene);
  Check(errors.Take() == 0, "one medium is no error");
  scene.Renderer->SetPass(nullptr);
  const std::vector<unsigned char> plain = GetPicture(scene);
  scene.Renderer->SetPass(scene.Pass);
  Check(fogged != plain, "the medium is seen");

  vtkNew<vtkParticipatingMedium> other;
  other->SetScattering(0.2, 0.2, 0.2);
  scene.Pass->AddMedium(other);
  Check(GetPicture(scene) != fogged && errors.Take() == 0, "several media are no error");
  scene.Pass->RemoveMedium(other);

  scene.Medium->SetSurface(MakeSphere(2.0));
  scene.Medium->SetRegionToSurface();
  const std::vector<unsigned char> filled = GetPicture(scene);
  Check(filled != plain && filled != fogged, "a closed surface is filled by the image");
  scene.Medium->SetRegionToUnbounded();
  Check(GetPicture(scene) == fogged, "after other regions the picture is the same");
  Check(errors.Take() == 0, "regions are no error");

  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.Pass->SetScatteredSurfaceLight(true);
  Check(GetPicture(scene) == fogged, "scattered light on surfaces has no effect");
  GetPicture(scene);
  CheckText(warnings, "the medium's density comes from an image", "scattered light on surfaces");
  scene.Pass->SetScatteredSurfaceLight(false);
}

//------------------------------------------------------------------------------
void CheckValues(DensityScene& scene)
{
  ErrorListener errors(scene.Medium);
  ErrorListener ofPass(scene.Pass);
  vtkDataArray* values = scene.Image->GetPointData()->GetScalars();
  for (const double bad : { -1.0, std::nan(""), HUGE_VAL })
  {
    const std::string name = "the value " + std::to_string(bad).substr(0, 2);
    values->SetComponent(4, 0, bad);
    scene.Image->Modified();
    Check(GetTransmittance(scene) == 1.0, name + ": the medium is nowhere");
    CheckText(errors, name, name);
  }
  values->SetComponent(4, 0, 1e100);
  scene.Image->Modified();
  scene.Window->Render();
  for (int pixel = 0; pixel < scene.Width * scene.Height; ++pixel)
  {
    const glm::dvec3 colour =
      GetColour(scene.GetBuffer("Radiance"), pixel % scene.Width, pixel / scene.Width);
    if (!Check(std::isfinite(colour.x + colour.y + colour.z), "huge values: radiance is finite"))
    {
      break;
    }
  }
  values->SetComponent(4, 0, 1.0);
  scene.Image->Modified();
  Check(GetTransmittance(scene) < 0.9, "a corrected image is drawn");
  scene.Medium->SetDensityImage(nullptr);
  Check(GetTransmittance(scene) == 1.0, "no image: the medium is nowhere");
  CheckText(errors, "call SetDensityImage()", "no image");
  Check(errors.Take() == 0 && ofPass.Take() == 0, "nothing else is said");
}
}

//------------------------------------------------------------------------------
int TestDensityPassErrors(int, char*[])
{
  DensityScene scene(MakeDensity({ 3, 4, 5 }, glm::dvec3(-2), glm::dvec3(2)));
  scene.Medium->SetAbsorption(0.2, 0.3, 0.4);
  scene.AddBodies();
  scene.AddPointLight({ 0, 1.5, 0 });
  CheckCombinations(scene);
  CheckValues(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
