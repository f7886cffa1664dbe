// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far exit signs can be read in a corridor full of smoke, in a window or, with -o, in a picture
 * (.png). Prints the contrast of letters that shine and of letters that are lit, and the distance
 * at which it has fallen to 2 %. Examples/Python/smoke_corridor.py is the same example in Python
 * and states the measured rule.
 */

#include "ExampleScene.h"

#include <vtkAirlight.h>
#include <vtkAirlightLight.h>
#include <vtkAirlightPass.h>
#include <vtkAirlightProbeFilter.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkParticipatingMedium.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkVectorText.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

using example::MakeBox;

namespace
{
constexpr double Extinction = 0.12 + 0.08; // per metre: scattering plus absorption of the smoke
constexpr double Ambient = 0.06;         // W/(m^2 sr), scattered more than once by smoke and walls
constexpr double Letters = 8.0;          // W/(m^2 sr), of letters that shine
constexpr double Albedo = 0.8;           // of letters that do not
constexpr double Eye = 1.6, Sign = 2.26; // m: heights; the corridor goes along -z
constexpr double FirstLamp = -2.5, LampStep = -5.0, Ceiling = 2.45;
constexpr int Lamps = 8;
constexpr int Signs = 8; // every 5 m

void AddLamps(vtkRenderer* renderer, vtkAirlightProbeFilter* probe)
{
  const double intensity[3] = { 7.5, 6.8, 5.7 }; // W/sr
  for (int i = 0; i < Lamps; ++i)
  {
    const double z = FirstLamp + i * LampStep;
    vtkNew<vtkLight> lamp;
    vtkAirlight::SetRadiantIntensity(lamp, intensity);
    lamp->SetPosition(0.0, Ceiling, z);
    lamp->SetFocalPoint(0.0, 0.0, z);
    lamp->SetConeAngle(80.0);
    lamp->SetExponent(0.0);
    vtkAirlightLight::SetRadius(lamp, 0.15); // its glass, in means of frames
    renderer->AddLight(lamp);
    probe->AddLight(lamp);
  }
}

double Mean(vtkPointData* data, const char* name, vtkIdType i)
{
  const double* rgb = data->GetArray(name)->GetTuple3(i);
  return (rgb[0] + rgb[1] + rgb[2]) / 3.0;
}

void Report(const char* name, const std::vector<double>& contrast)
{
  std::printf("signs that %s: contrast ", name);
  double reach = 0.0;
  for (int i = 0; i < Signs; ++i)
  {
    const double distance = 5.0 * (i + 1);
    std::printf("%s%.3g at %.1f m", i > 0 ? ", " : "", contrast[i], distance);
    if (i > 0 && contrast[i - 1] > 0.02 && contrast[i] <= 0.02)
    {
      // Between two signs the contrast falls about exponentially.
      const double part =
        std::log(contrast[i - 1] / 0.02) / std::log(contrast[i - 1] / contrast[i]);
      reach = distance - 5.0 + 5.0 * part;
    }
  }
  std::printf("\n  readable to %.1f m, K times that %.1f\n", reach, reach * Extinction);
}

// Signs every 5 m from the camera: their light that arrives, and that of the smoke in front.
void MeasureSigns(vtkAirlightProbeFilter* probe)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < Signs; ++i)
  {
    places->InsertNextPoint(0.0, Sign, -5.0 * (i + 1));
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(places);
  surface->GetPointData()->SetNormals(normals);
  probe->SetInputData(surface);
  probe->SetViewpoint(0.0, Eye, 0.0);
  probe->Update();
  vtkPointData* data = probe->GetOutput()->GetPointData();
  std::vector<double> shining;
  std::vector<double> lit;
  const double pi = std::acos(-1.0);
  for (int i = 0; i < Signs; ++i)
  {
    const double part = Mean(data, "Transmittance", i) / Mean(data, "Radiance", i);
    shining.push_back(Letters * part);
    lit.push_back(Albedo / pi * (Mean(data, "DirectIrradiance", i) + pi * Ambient) * part);
  }
  Report("shine", shining);
  Report("are lit", lit);
}

void Add(vtkRenderer* renderer, vtkAlgorithm* source, const example::Colour& albedo)
{
  example::Add(renderer, source, albedo)->GetProperty()->SetAmbient(Ambient);
}

vtkSmartPointer<vtkActor> AddShining(
  vtkRenderer* renderer, vtkAlgorithm* source, const example::Colour& radiance)
{
  vtkSmartPointer<vtkActor> actor = example::Add(renderer, source, radiance);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  return actor;
}

void AddWalls(vtkRenderer* renderer)
{
  const double near = 2.0, far = -45.0;
  Add(renderer, MakeBox(-1.3, 1.3, -0.1, 0.0, far, near), { 0.3, 0.3, 0.33 });
  Add(renderer, MakeBox(-1.3, 1.3, 2.6, 2.7, far, near), { 0.7, 0.7, 0.7 });
  for (const double side : { -1.0, 1.0 })
  {
    // A wall, its skirting board and its handrail.
    const double x = side * 1.25;
    Add(renderer, MakeBox(x - 0.05, x + 0.05, 0.0, 2.6, far, near), { 0.6, 0.58, 0.5 });
    const double board = side * 1.185;
    Add(
      renderer, MakeBox(board - 0.015, board + 0.015, 0.0, 0.25, far, near), { 0.08, 0.07, 0.06 });
    const double rail = side * 1.16;
    Add(renderer, MakeBox(rail - 0.04, rail + 0.04, 0.9, 1.0, far, near), { 0.3, 0.15, 0.07 });
  }
}

void AddSignsAndLampBodies(vtkRenderer* renderer)
{
  vtkNew<vtkVectorText> text;
  text->SetText("EXIT");
  text->Update();
  double bounds[6];
  text->GetOutput()->GetBounds(bounds);
  for (int i = 0; i < Signs; ++i)
  {
    const double z = -5.0 * (i + 1);
    AddShining(renderer, MakeBox(-0.34, 0.34, 2.12, 2.4, z - 0.04, z - 0.01), { 0.01, 0.8, 0.2 });
    auto letters = AddShining(renderer, text, { Letters, Letters, Letters });
    letters->SetPosition(-0.15 * 0.5 * (bounds[0] + bounds[1]), 2.19, z);
    letters->SetScale(0.15);
  }
  for (int i = 0; i < Lamps; ++i)
  {
    const double z = FirstLamp + i * LampStep;
    const auto makePart = [z](double low, double high) {
      return MakeBox(-0.2, 0.2, low, high, z - 0.2, z + 0.2);
    };
    AddShining(renderer, makePart(Ceiling + 0.01, Ceiling + 0.03), { 4.0, 3.8, 3.4 });
    Add(renderer, makePart(Ceiling + 0.03, 2.6), { 0.5, 0.5, 0.5 });
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  CLI::App program("How far exit signs can be read in a corridor full of smoke");
  std::string picture;
  program.add_option("-o,--output", picture, "picture to write, a PNG; default: a window");
  CLI11_PARSE(program, argc, argv);

  vtkNew<vtkParticipatingMedium> smoke;
  smoke->SetScattering(0.12, 0.12, 0.12); // per metre
  smoke->SetAbsorption(0.08, 0.08, 0.08);
  smoke->SetAmbientRadiance(Ambient, Ambient, Ambient);
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(smoke);
  pass->SetShadowTechniqueToShadowPlanes(); // exact, though there are many edges
  pass->SetToneMappingToNeutralPBR();       // for the eye
  pass->SetOutputColorSpaceToSRGB();
  vtkNew<vtkRenderer> renderer;
  renderer->UseFXAAOn();
  renderer->SetPass(pass);
  AddWalls(renderer);
  AddSignsAndLampBodies(renderer);
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetMedium(smoke);
  AddLamps(renderer, probe);
  MeasureSigns(probe);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, Eye, 0.0);
  camera->SetFocalPoint(0.0, Eye + 0.05, -1.0);
  camera->SetViewAngle(40.0);
  renderer->ResetCameraClippingRange();
  return example::Window(renderer, 480, 320, picture).Show();
}
