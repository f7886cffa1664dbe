// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sun through the windows of a dusty room, in a window or, with -o, in a picture (.png).
 * Prints how much of the view ray through the centre of the picture is in the sun.
 * Examples/Python/daylight_room.py shows the same room and measures its floor.
 */

#include "ExampleScene.h"

#include <vtkAirlight.h>
#include <vtkAirlightPass.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkParticipatingMedium.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <CLI/CLI.hpp>

#include <cstdio>

namespace
{
constexpr double White = 45.0;                                 // W/(m^2 sr), shown as white
constexpr double Room[6] = { -3.5, 3.5, 0.0, 3.2, -6.0, 5.0 }; // m, inside the walls
constexpr double SkyLight[3] = { 4.5 / White, 5.0 / White, 5.6 / White };
constexpr double Sun[3] = { 800.0 / White, 720.0 / White, 600.0 / White }; // W/m^2

constexpr double Walls[][6] = { { -3.7, -3.5, 0, 0.9, -6, 5 }, { -3.7, -3.5, 2.7, 3.2, -6, 5 },
  { -3.7, -3.5, 0.9, 2.7, -6, -5.2 }, { -3.7, -3.5, 0.9, 2.7, -3.8, -2.9 },
  { -3.7, -3.5, 0.9, 2.7, -1.5, -0.6 }, { -3.7, -3.5, 0.9, 2.7, 0.8, 5 },
  { -3.64, -3.56, 0.9, 2.7, -4.54, -4.46 }, { -3.64, -3.56, 0.9, 2.7, -2.24, -2.16 },
  { -3.64, -3.56, 0.9, 2.7, 0.06, 0.14 }, { -3.64, -3.56, 2.06, 2.14, -5.2, 0.8 },
  { -3.7, 3.7, 3.2, 3.4, -6.2, 5.2 }, { 3.5, 3.7, 0, 3.2, -6, 5 }, { -3.7, 3.7, 0, 3.2, -6.2, -6 },
  { -3.7, 3.7, 0, 3.2, 5, 5.2 } };
constexpr double Table[][6] = { { -1.9, -0.2, 0.7, 0.75, -2.5, -1.1 },
  { -1.85, -1.78, 0, 0.7, -2.45, -2.38 }, { -1.85, -1.78, 0, 0.7, -1.22, -1.15 },
  { -0.32, -0.25, 0, 0.7, -2.45, -2.38 }, { -0.32, -0.25, 0, 0.7, -1.22, -1.15 } };

// Adds a surface. All surfaces receive the same skylight.
void Add(vtkRenderer* renderer, vtkAlgorithm* source, const example::Colour& albedo)
{
  vtkProperty* property = example::Add(renderer, source, albedo)->GetProperty();
  property->SetAmbientColor(
    albedo[0] * SkyLight[0], albedo[1] * SkyLight[1], albedo[2] * SkyLight[2]);
  property->SetAmbient(1.0);
}

void AddBox(vtkRenderer* renderer, const double b[6], const example::Colour& albedo)
{
  Add(renderer, example::MakeBox(b[0], b[1], b[2], b[3], b[4], b[5]), albedo);
}

void AddRoom(vtkRenderer* renderer)
{
  const double floor[6] = { -3.7, 3.5, -0.2, 0.0, -6.0, 5.0 };
  AddBox(renderer, floor, { 0.36, 0.23, 0.13 });
  for (const auto& wall : Walls)
  {
    AddBox(renderer, wall, { 0.75, 0.72, 0.66 });
  }
  for (const auto& part : Table)
  {
    AddBox(renderer, part, { 0.45, 0.22, 0.1 });
  }
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(-1.2, 0.97, -1.7);
  ball->SetRadius(0.22);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(48);
  Add(renderer, ball, { 0.3, 0.55, 0.6 });
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  CLI::App program("The sun through the windows of a dusty room");
  std::string picture;
  program.add_option("-o,--output", picture, "picture to write, a PNG; default: a window");
  CLI11_PARSE(program, argc, argv);

  vtkNew<vtkLight> sun;
  vtkAirlight::SetIrradiance(sun, Sun);
  sun->SetPosition(-1.0, 0.72, -0.3); // where it shines from
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  vtkNew<vtkParticipatingMedium> dust;
  dust->SetScattering(0.07, 0.07, 0.07); // per metre
  dust->SetAbsorption(0.007, 0.007, 0.007);
  dust->SetAmbientRadiance(SkyLight);
  dust->SetPhaseFunctionToHenyeyGreenstein();
  dust->SetAnisotropy(0.6);
  dust->SetRegionToBox();
  dust->SetBounds(Room);
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(dust);
  pass->RecordBuffersOn();
  pass->SetToneMappingToNeutralPBR(); // for the eye
  pass->SetOutputColorSpaceToSRGB();
  vtkNew<vtkRenderer> renderer;
  renderer->UseFXAAOn();
  renderer->SetBackground(0.5, 0.7, 0.9); // the sky in the windows
  renderer->AddLight(sun);
  renderer->SetPass(pass);
  AddRoom(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(2.9, 1.5, 3.6);
  camera->SetFocalPoint(-2.4, 1.0, -1.5);
  camera->SetViewAngle(42.0);
  renderer->ResetCameraClippingRange();

  example::Window window(renderer, 480, 320, picture);
  std::printf("of %.3f m straight ahead %.3f m are in the sun\n",
    pass->GetBuffer("Depth")->GetScalarComponentAsDouble(240, 160, 0, 0),
    pass->GetBuffer("LitLength")->GetScalarComponentAsDouble(240, 160, 0, 0));
  return window.Show();
}
