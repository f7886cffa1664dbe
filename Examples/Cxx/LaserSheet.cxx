// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A laser's light sheet through the smoke of a wind tunnel, past a cylinder and its shadow; in a
 * window or, with -o, in a picture (.png). At the point where the middle line meets the sheet, it
 * prints the thickness of the sheet along the view and its radiance, as drawn and by hand. It also
 * prints how much of the floor's middle line the cylinder shadows.
 * Examples/Python/laser_sheet.py is the same example in Python.
 */

#include "ExampleScene.h"

#include <vtkAirlight.h>
#include <vtkAirlightPass.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCylinderSource.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLineSource.h>
#include <vtkLitIntervalsFilter.h>
#include <vtkMath.h>
#include <vtkParticipatingMedium.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using example::MakeBox;

namespace
{
constexpr double Radius = 0.1; // m, of the cylinder around the z axis; air flows along x
constexpr double Lens[3] = { 0.1, 0.75, 0.0 };
constexpr double Slit = 0.001, SlitDepth = 0.11;      // m wide, and how far below the lens it ends
constexpr double Intensity[3] = { 9.0, 200.0, 26.0 }; // W/sr, green
constexpr double Scattering = 2.0;                    // per metre, in the streaks
constexpr double Wires = 0.05;                        // m between the smoke wires
constexpr double Eye[3] = { 0.75, 0.35, 2.0 };
constexpr double Probe[3] = { -0.35, 0.0, 0.0 }; // on the middle line, before the cylinder

vtkNew<vtkTransformPolyDataFilter> MakeCylinder()
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetRadius(Radius);
  cylinder->SetHeight(0.4);
  cylinder->SetResolution(192);
  vtkNew<vtkTransform> turn;
  turn->RotateX(90.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetInputConnection(cylinder->GetOutputPort());
  turned->SetTransform(turn);
  return turned;
}

// Density 1 in streaks of equal stream function y (1 - R^2/r^2) of potential flow, 0.15 between.
vtkNew<vtkParticipatingMedium> MakeSmoke()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(301, 161, 2);
  image->SetOrigin(-0.6, -0.4, -0.3);
  image->SetSpacing(1.5 / 300.0, 0.8 / 160.0, 0.6);
  image->AllocateScalars(VTK_DOUBLE, 1);
  auto* density = static_cast<double*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double r2 = std::max(p[0] * p[0] + p[1] * p[1], Radius * Radius);
    const double stream = p[1] * (1.0 - Radius * Radius / r2);
    density[i] = 0.15 + 0.85 * std::pow(std::cos(vtkMath::Pi() * stream / Wires), 8);
  }
  vtkNew<vtkParticipatingMedium> smoke;
  smoke->SetScattering(Scattering, Scattering, Scattering);
  smoke->SetDensityImage(image);
  smoke->SetDensityToImage();
  return smoke;
}

void Add(vtkRenderer* renderer, vtkAlgorithm* source, const example::Colour& albedo)
{
  example::Add(renderer, source, albedo)->GetProperty()->SetAmbient(0.15); // to see the tunnel by
}

void AddTunnel(vtkRenderer* renderer)
{
  const double bottom = Lens[1] - SlitDepth;
  for (const auto& [z0, z1] : { std::pair(Slit / 2.0, 0.15), std::pair(-0.15, -Slit / 2.0) })
  {
    Add(renderer, MakeBox(-0.3, 0.5, bottom, bottom + 0.01, z0, z1), { 0.2, 0.2, 0.2 });
  }
  Add(renderer, MakeCylinder(), { 0.5, 0.5, 0.5 });
  Add(renderer, MakeBox(-0.6, 0.9, -0.41, -0.4, -0.3, 0.3), { 0.1, 0.1, 0.1 });
  Add(renderer, MakeBox(-0.6, 0.9, -0.4, 0.4, -0.31, -0.3), { 0.02, 0.02, 0.02 });
}

// Length of the cylinder's shadow on the floor's middle line, seen from the lens.
double MeasureShadow(vtkLight* lens, vtkParticipatingMedium* smoke)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-0.6, -0.39, 0.0);
  line->SetPoint2(0.9, -0.39, 0.0);
  const auto cylinder = MakeCylinder();
  vtkNew<vtkLitIntervalsFilter> lit;
  lit->SetInputConnection(line->GetOutputPort());
  lit->AddInputConnection(1, cylinder->GetOutputPort());
  lit->SetLight(lens);
  lit->SetMedium(smoke);
  lit->Update();
  vtkCellData* data = lit->GetOutput()->GetCellData();
  return data->GetArray("Start")->GetTuple1(1) - data->GetArray("End")->GetTuple1(0);
}

// The pixel that shows Probe, and the point at which its ray meets the sheet, the plane z = 0.
struct Place
{
  explicit Place(vtkRenderer* renderer)
  {
    renderer->SetWorldPoint(Probe[0], Probe[1], Probe[2], 1.0);
    renderer->WorldToDisplay();
    this->Column = static_cast<int>(renderer->GetDisplayPoint()[0]);
    this->Row = static_cast<int>(renderer->GetDisplayPoint()[1]);
    renderer->SetDisplayPoint(this->Column + 0.5, this->Row + 0.5, 0.5);
    renderer->DisplayToWorld();
    const double* world = renderer->GetWorldPoint();
    const double part = Eye[2] / (Eye[2] - world[2] / world[3]);
    for (int i = 0; i < 3; ++i)
    {
      this->Point[i] = Eye[i] + part * (world[i] / world[3] - Eye[i]);
    }
  }

  int Column;
  int Row;
  double Point[3];
};

void Report(vtkRenderer* renderer, vtkAirlightPass* pass, vtkLight* lens)
{
  const Place place(renderer);
  const auto get = [&](const char* name, int channel) {
    return pass->GetBuffer(name)->GetScalarComponentAsDouble(place.Column, place.Row, 0, channel);
  };
  // By hand: the sheet widens from the lens through the slit, and the view crosses it obliquely.
  const double across = Slit * (Lens[1] - place.Point[1]) / SlitDepth;
  const double thickness =
    across * std::sqrt(vtkMath::Distance2BetweenPoints(Eye, place.Point)) / Eye[2];
  std::printf("thickness along the view: %.2f mm, by hand %.2f mm\n", 1000.0 * get("LitLength", 0),
    1000.0 * thickness);
  // A thin sheet's radiance: sigma_s/(4 pi) I/r^2 T thickness.
  double there[3];
  double back[3];
  vtkAirlight::Transmittance(pass->GetMedium(0), Lens, place.Point, there);
  vtkAirlight::Transmittance(pass->GetMedium(0), place.Point, Eye, back);
  const double radiance = Scattering / (4.0 * vtkMath::Pi()) * Intensity[1] /
    vtkMath::Distance2BetweenPoints(Lens, place.Point) * there[1] * back[1] * thickness;
  std::printf("radiance: %.4f W/(m^2 sr), by hand %.4f W/(m^2 sr)\n", get("Airlight", 1), radiance);
  std::printf("shadow on the floor: %.4f m\n", MeasureShadow(lens, pass->GetMedium(0)));
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  CLI::App program("A laser's light sheet through the smoke of a wind tunnel");
  std::string picture;
  program.add_option("-o,--output", picture, "picture to write, a PNG; default: a window");
  CLI11_PARSE(program, argc, argv);

  vtkNew<vtkLight> lens; // a point, from which the sheet spreads
  vtkAirlight::SetRadiantIntensity(lens, Intensity);
  lens->SetPosition(Lens[0], Lens[1], Lens[2]);
  lens->SetFocalPoint(Lens[0], 0.0, Lens[2]);
  lens->SetConeAngle(50.0);
  lens->SetExponent(0.0);
  const auto smoke = MakeSmoke();
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(smoke);
  pass->RecordBuffersOn();
  pass->SetExposure(2.5); // for the eye
  pass->SetToneMappingToNeutralPBR();
  pass->SetOutputColorSpaceToSRGB();
  vtkNew<vtkRenderer> renderer;
  renderer->UseFXAAOn();
  renderer->AddLight(lens);
  renderer->SetPass(pass);
  AddTunnel(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(Eye);
  camera->SetFocalPoint(0.13, 0.02, 0.0);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();

  example::Window window(renderer, 480, 320, picture);
  Report(renderer, pass, lens);
  return window.Show();
}
