// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far an underwater vehicle's camera sees by its lamp, and why the lamp is mounted aside; in a
 * window or, with -o, in a picture (.png). Prints the contrast of a white board with the veil of
 * water in front of it, and the range at which the contrast is 2 %.
 * Examples/Python/underwater_lamp.py is the same example in Python and gives the sources of the
 * water's coefficients.
 */

#include "ExampleScene.h"

#include <vtkAirlight.h>
#include <vtkAirlightPass.h>
#include <vtkCamera.h>
#include <vtkCylinderSource.h>
#include <vtkLight.h>
#include <vtkParticipatingMedium.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstdio>

using example::Add;
using example::MakeBox;

namespace
{
using Vector = std::array<double, 3>;

constexpr Vector Lamp = { 1.6, 0.9, 0.3 }; // m; the camera is at the origin and looks along -z
constexpr Vector LampBeside = { 0.15, 0.1, 0.0 };
constexpr Vector Intensity = { 240.0, 228.0, 204.0 }; // W/sr
constexpr double Albedo = 0.9;                        // of the board

// Light of a white board that arrives, divided by the light of the water in front of it.
Vector Contrast(vtkParticipatingMedium* water, const Vector& lamp, double distance)
{
  const double eye[3] = { 0.0, 0.0, 0.0 };
  const double ahead[3] = { 0.0, 0.0, -1.0 };
  const double board[3] = { 0.0, 0.0, -distance };
  const double r = std::hypot(lamp[0], lamp[1], lamp[2] + distance);
  const double irradiance = (lamp[2] + distance) / (r * r * r); // of 1 W/sr
  Vector veil;
  Vector there;
  Vector back;
  vtkAirlight::Inscatter(
    water, lamp.data(), Intensity.data(), eye, ahead, 0.0, distance, veil.data());
  vtkAirlight::Transmittance(water, lamp.data(), board, there.data());
  vtkAirlight::Transmittance(water, board, eye, back.data());
  Vector contrast;
  for (int i = 0; i < 3; ++i)
  {
    contrast[i] =
      Albedo / std::acos(-1.0) * Intensity[i] * irradiance * there[i] * back[i] / veil[i];
  }
  return contrast;
}

// Distance at which the contrast is 2 %; the contrast falls with the distance.
double FindRange(vtkParticipatingMedium* water, const Vector& lamp, int channel)
{
  double near = 0.5;
  double far = 500.0;
  while (far - near > 1e-6)
  {
    const double middle = (near + far) / 2.0;
    (Contrast(water, lamp, middle)[channel] > 0.02 ? near : far) = middle;
  }
  return near;
}

void Report(vtkParticipatingMedium* water, const char* name, const Vector& lamp)
{
  std::printf("lamp %s: contrast ", name);
  for (const int distance : { 2, 5, 10 })
  {
    const Vector c = Contrast(water, lamp, distance);
    std::printf("%s%.3g %.3g %.3g at %d m", distance > 2 ? ", " : "", c[0], c[1], c[2], distance);
  }
  std::printf("\n  range: red %.2f, green %.2f, blue %.2f m\n", FindRange(water, lamp, 0),
    FindRange(water, lamp, 1), FindRange(water, lamp, 2));
}

// A sandy sea floor, 1.5 m below, with ripples of 5 cm. It casts no shadows.
void AddFloor(vtkRenderer* renderer)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-12.0, 0.0, 2.0);
  plane->SetPoint1(12.0, 0.0, 2.0);
  plane->SetPoint2(-12.0, 0.0, -30.0);
  plane->SetResolution(240, 320);
  plane->Update();
  vtkPoints* points = plane->GetOutput()->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vector p;
    points->GetPoint(i, p.data());
    p[1] = -1.5 + 0.05 * std::sin(4.0 * p[2] + std::sin(1.3 * p[0])) +
      0.12 * std::sin(0.7 * p[0] + 0.4 * p[2]);
    points->SetPoint(i, p.data());
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(plane->GetOutput());
  vtkActor* floor = Add(renderer, normals, { 0.62, 0.56, 0.42 });
  vtkAirlightPass::SetCastsShadow(floor, false);
}

void AddPipe(
  vtkRenderer* renderer, double radius, double length, double z, const example::Colour& albedo)
{
  vtkNew<vtkCylinderSource> pipe;
  pipe->SetRadius(radius);
  pipe->SetHeight(length);
  pipe->SetResolution(48);
  auto actor = Add(renderer, pipe, albedo);
  actor->SetPosition(-1.3, -1.2, z);
  actor->RotateX(90.0);
}

void AddSeaFloor(vtkRenderer* renderer)
{
  AddFloor(renderer);
  AddPipe(renderer, 0.3, 40.0, -12.0, { 0.7, 0.68, 0.6 });
  for (int z = -29; z < 0; z += 3)
  {
    AddPipe(renderer, 0.36, 0.15, z, { 0.75, 0.2, 0.1 });
  }
  const double boards[][2] = { { 0.45, -3.0 }, { 0.0, -5.0 }, { -1.2, -8.0 }, { -0.6, -12.0 } };
  for (const auto& [x, z] : boards)
  {
    Add(renderer, MakeBox(x, x + 0.6, -0.9, -0.3, z - 0.03, z), { 0.9, 0.9, 0.9 });
    Add(renderer, MakeBox(x + 0.27, x + 0.33, -1.7, -0.9, z - 0.03, z), { 0.5, 0.5, 0.5 });
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  CLI::App program("How far an underwater vehicle's camera sees by its lamp");
  std::string picture;
  program.add_option("-o,--output", picture, "picture to write, a PNG; default: a window");
  CLI11_PARSE(program, argc, argv);

  vtkNew<vtkParticipatingMedium> water;
  water->SetScattering(0.15, 0.15, 0.15); // per metre
  water->SetAbsorption(0.29, 0.07, 0.06);
  water->SetPhaseFunctionToHenyeyGreenstein();
  water->SetAnisotropy(0.92);
  Report(water, "beside the camera", LampBeside);
  Report(water, "on an arm", Lamp);

  vtkNew<vtkLight> lamp;
  vtkAirlight::SetRadiantIntensity(lamp, Intensity.data());
  lamp->SetPosition(Lamp.data());
  lamp->SetFocalPoint(-0.3, -0.8, -7.0);
  lamp->SetConeAngle(40.0);
  lamp->SetExponent(0.0);
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(water);
  pass->SetExposure(4.0); // for the eye
  pass->SetToneMappingToReinhard();
  pass->SetOutputColorSpaceToSRGB();
  vtkNew<vtkRenderer> renderer;
  renderer->UseFXAAOn();
  renderer->AddLight(lamp);
  renderer->SetPass(pass);
  AddSeaFloor(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, -0.12, -1.0);
  camera->SetViewAngle(45.0);
  renderer->ResetCameraClippingRange();
  return example::Window(renderer, 480, 320, picture).Show();
}
