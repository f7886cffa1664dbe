// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a driver sees in fog at night by high beam and, with --low, by low beam; in a window or,
 * with -o, in a picture (.png). For the low beam, a shield in front of each lamp blocks the light
 * that would go higher than 1 % below the horizon. Prints the veil of fog in front of people on the
 * road and their contrast. Examples/Python/headlights_in_fog.py shows both beams.
 */

#include "ExampleScene.h"

#include <vtkAirlight.h>
#include <vtkAirlightPass.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLineSource.h>
#include <vtkParticipatingMedium.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>

using example::Add;
using example::MakeBox;

namespace
{
constexpr double White = 10.0; // cd/m^2, shown as white
constexpr double Intensity[3] = { 20000.0 / White, 19200.0 / White, 17200.0 / White }; // cd, axis
constexpr double People[][2] = { { 1.0, 12.0 }, { -0.4, 22.0 }, { -2.2, 34.0 }, { 0.4, 48.0 } };

using Point = std::array<double, 3>;

const example::Colour Coat = { 0.22, 0.1, 0.08 };
const example::Colour Skin = { 0.35, 0.25, 0.2 };

vtkSmartPointer<vtkActor> AddBall(
  vtkRenderer* renderer, const Point& centre, double radius, const example::Colour& colour)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(centre[0], centre[1], centre[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(32);
  source->SetPhiResolution(32);
  return Add(renderer, source, colour);
}

void AddLimb(vtkRenderer* renderer, const Point& start, const Point& end, double radius,
  const example::Colour& colour)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(start[0], start[1], start[2]);
  line->SetPoint2(end[0], end[1], end[2]);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(24);
  tube->CappingOn();
  Add(renderer, tube, colour);
}

void AddPerson(vtkRenderer* renderer, double x, double z)
{
  for (const double leg : { x - 0.2, x + 0.02 })
  {
    Add(renderer, MakeBox(leg, leg + 0.16, 0.0, 0.8, z - 0.1, z + 0.1), { 0.06, 0.07, 0.1 });
  }
  const auto body = AddBall(renderer, { 0.0, 0.0, 0.0 }, 1.0, Coat);
  body->SetPosition(x, 1.13, z);
  body->SetScale(0.23, 0.36, 0.14);
  for (const double side : { -1.0, 1.0 })
  {
    const Point shoulder = { x + 0.2 * side, 1.38, z };
    const Point hand = { x + 0.3 * side, 0.82, z + 0.06 };
    AddLimb(renderer, shoulder, hand, 0.065, Coat);
    AddBall(renderer, shoulder, 0.075, Coat);
    AddBall(renderer, hand, 0.06, Skin);
  }
  AddLimb(renderer, { x, 1.4, z }, { x, 1.6, z }, 0.06, Skin);
  AddBall(renderer, { x, 1.65, z }, 0.125, Skin);
}

void AddRoad(vtkRenderer* renderer)
{
  Add(renderer, MakeBox(-40.0, 40.0, -0.2, -0.02, -200.0, 10.0), { 0.035, 0.05, 0.025 }); // grass
  Add(renderer, MakeBox(-5.2, 2.1, -0.2, 0.0, -200.0, 10.0), { 0.07, 0.07, 0.07 });
  Add(renderer, MakeBox(1.8, 1.95, -0.1, 0.01, -200.0, 10.0), { 0.5, 0.5, 0.48 });
  for (int z = -190; z < 10; z += 9)
  {
    Add(renderer, MakeBox(-1.9, -1.78, -0.1, 0.01, z, z + 3), { 0.5, 0.5, 0.48 });
  }
  for (int z = -190; z < 0; z += 10)
  {
    Add(renderer, MakeBox(-5.6, -5.48, 0.0, 1.0, z, z + 0.12), { 0.7, 0.7, 0.7 });
    Add(renderer, MakeBox(2.4, 2.52, 0.0, 1.0, z, z + 0.12), { 0.7, 0.7, 0.7 });
  }
  for (const auto& person : People)
  {
    AddPerson(renderer, person[0], -person[1]);
  }
}

void AddLamp(vtkRenderer* renderer, double x, bool low)
{
  constexpr double Y = 0.65;
  vtkNew<vtkLight> lamp;
  vtkAirlight::SetRadiantIntensity(lamp, Intensity);
  lamp->SetPosition(x, Y, 0.0);
  lamp->SetFocalPoint(x, Y, -1.0);
  lamp->SetConeAngle(35.0);
  lamp->SetExponent(60.0); // half as bright 9 degrees off its axis
  renderer->AddLight(lamp);
  if (low)
  {
    // Its two sides transmit 1 %: stray light above the road.
    vtkActor* shield = Add(renderer,
      MakeBox(x - 0.05, x + 0.05, Y - 0.0005, Y + 0.04, -0.051, -0.05), { 0.0, 0.0, 0.0 });
    vtkAirlightPass::SetShadowOpacity(shield, 0.9, 0.9, 0.9);
  }
}

void Report(vtkRenderer* renderer, vtkAirlightPass* pass, double x, double distance)
{
  renderer->SetWorldPoint(x + 0.1, 0.15, 0.1 - distance, 1.0); // a leg
  renderer->WorldToDisplay();
  const int column = static_cast<int>(renderer->GetDisplayPoint()[0]);
  const int row = static_cast<int>(renderer->GetDisplayPoint()[1]);
  const auto get = [&](const char* name) {
    return White * pass->GetBuffer(name)->GetScalarComponentAsDouble(column, row, 0, 1);
  };
  const double veil = get("Airlight");
  std::printf("at %g m: veil %.3f cd/m^2, contrast %.3f\n", distance, veil, get("Surface") / veil);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  CLI::App program("Headlights in fog at night");
  std::string picture;
  bool low = false;
  program.add_option("-o,--output", picture, "picture to write, a PNG; default: a window");
  program.add_flag("--low", low, "low beam; default: high beam");
  CLI11_PARSE(program, argc, argv);

  vtkNew<vtkParticipatingMedium> fog;
  fog->SetVisibility(100.0); // m
  fog->SetPhaseFunctionToHenyeyGreenstein();
  fog->SetAnisotropy(0.85);
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(fog);
  pass->RecordBuffersOn();
  pass->SetExposure(2.5); // for the eye
  pass->SetToneMappingToReinhard();
  pass->SetOutputColorSpaceToSRGB();
  vtkNew<vtkRenderer> renderer;
  renderer->SetPass(pass);
  AddLamp(renderer, -0.62, low);
  AddLamp(renderer, 0.62, low);
  AddRoad(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-0.35, 1.25, 1.6);
  camera->SetFocalPoint(-0.35, 1.205, 0.6);
  camera->SetViewAngle(17.0);
  camera->SetClippingRange(0.5, 300.0);

  example::Window window(renderer, 480, 160, picture);
  for (const auto& person : People)
  {
    Report(renderer, pass, person[0], person[1]);
  }
  return window.Show();
}
