// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A molecule in a haze that shows depth: DNA, four turns of the double helix; in a window or, with
 * -o, in a picture (.png). A colour at distance d keeps exp(-d/Range) of its contrast with the
 * background. Prints this fraction for the nearest and the farthest part. Lengths are in
 * nanometres. Examples/Python/depth_cueing.py is the same example in Python.
 */

#include "ExampleScene.h"

#include <vtkAirlight.h>
#include <vtkAirlightPass.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkParticipatingMedium.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>

namespace
{
using Point = std::array<double, 3>;
using Polyline = std::vector<Point>;

const std::string Sequence = "CAGCAGGGGGGCGTGACTGATCAAGCCTGAGATAATGCGGGT";
constexpr double Range = 8.0; // distance at which a colour has lost 63 % of its contrast
constexpr double Pi = 3.14159265358979323846;
// B-DNA: radius, rise and twist of a pair, and the angle across the minor groove.
constexpr double Radius = 0.9, Rise = 0.332, Twist = 2.0 * Pi / 10.5, Groove = 133.0 * Pi / 180.0;

struct Base
{
  // Both are used through the map.
  char Partner;           // cppcheck-suppress unusedStructMember
  example::Colour Albedo; // cppcheck-suppress unusedStructMember
};
const std::map<char, Base> Bases = { { 'A', { 'T', { 0.75, 0.2, 0.15 } } },
  { 'T', { 'A', { 0.85, 0.65, 0.15 } } }, { 'G', { 'C', { 0.15, 0.5, 0.25 } } },
  { 'C', { 'G', { 0.15, 0.3, 0.7 } } } };

// Points along one strand of a helix along -z, rotated by an angle about its axis.
Polyline Strand(double offset)
{
  Polyline strand;
  for (std::size_t i = 0; i < Sequence.size(); ++i)
  {
    const double angle = i * Twist + offset;
    strand.push_back({ Radius * std::cos(angle), Radius * std::sin(angle), 1.0 - i * Rise });
  }
  return strand;
}

vtkNew<vtkPolyData> MakeLines(const std::vector<Polyline>& lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Polyline& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Point& p : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

void MakeMatt(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.9);
}

void AddTubes(vtkRenderer* renderer, const std::vector<Polyline>& lines, double radius,
  const example::Colour& albedo)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(MakeLines(lines));
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(16);
  tubes->CappingOn();
  MakeMatt(example::Add(renderer, tubes, albedo));
}

void AddPhosphates(vtkRenderer* renderer, const Polyline& strand)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.2);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakeLines({ strand }));
  mapper->SetSourceConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.75, 0.5, 0.3);
  MakeMatt(actor);
  renderer->AddActor(actor);
}

void AddMolecule(vtkRenderer* renderer)
{
  const Polyline first = Strand(0.0);
  const Polyline second = Strand(Groove);
  AddTubes(renderer, { first, second }, 0.1, { 0.6, 0.6, 0.62 });
  AddPhosphates(renderer, first);
  AddPhosphates(renderer, second);
  // Each base reaches from its strand to the middle of its pair.
  std::map<char, std::vector<Polyline>> halves;
  for (std::size_t i = 0; i < Sequence.size(); ++i)
  {
    const Point& a = first[i];
    const Point& b = second[i];
    const Point middle = { (a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0, (a[2] + b[2]) / 2.0 };
    halves[Sequence[i]].push_back({ a, middle });
    halves[Bases.at(Sequence[i]).Partner].push_back({ b, middle });
  }
  for (const auto& [letter, lines] : halves)
  {
    AddTubes(renderer, lines, 0.09, Bases.at(letter).Albedo);
  }
}

void Report(vtkAirlightPass* pass)
{
  vtkDataArray* depth = pass->GetBuffer("Depth")->GetPointData()->GetScalars();
  vtkDataArray* kept = pass->GetBuffer("Transmittance")->GetPointData()->GetScalars();
  vtkIdType nearest = -1; // of the pixels that show the molecule
  vtkIdType farthest = -1;
  for (vtkIdType i = 0; i < depth->GetNumberOfTuples(); ++i)
  {
    const double distance = depth->GetComponent(i, 0);
    if (distance > 0.0 && (nearest < 0 || distance < depth->GetComponent(nearest, 0)))
    {
      nearest = i;
    }
    if (distance > 0.0 && (farthest < 0 || distance > depth->GetComponent(farthest, 0)))
    {
      farthest = i;
    }
  }
  for (const auto& [name, i] : { std::pair("nearest", nearest), std::pair("farthest", farthest) })
  {
    std::printf("%s: at %.3f nm %.2f %% of the contrast\n", name, depth->GetComponent(i, 0),
      100.0 * kept->GetComponent(i, 0));
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  CLI::App program("DNA in a haze that tells near from far");
  std::string picture;
  program.add_option("-o,--output", picture, "picture to write, a PNG; default: a window");
  CLI11_PARSE(program, argc, argv);

  vtkNew<vtkParticipatingMedium> haze;
  haze->SetScattering(1.0 / Range, 1.0 / Range, 1.0 / Range);
  haze->SetAmbientRadiance(0.02, 0.04, 0.09);
  vtkNew<vtkLight> lamp;
  const double irradiance[3] = { 5.0, 4.9, 4.6 };
  vtkAirlight::SetIrradiance(lamp, irradiance);
  lamp->SetPosition(-1.0, 3.0, 1.5);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(haze);
  pass->SetShadowTechniqueToShadowPlanes(); // exact, though there are many edges
  pass->SetLightScatters(lamp, false);      // the haze has the background's colour everywhere
  pass->RecordBuffersOn();
  pass->EncodedOutputOn(); // for the eye
  vtkNew<vtkRenderer> renderer;
  renderer->UseFXAAOn();
  renderer->AddLight(lamp);
  renderer->SetPass(pass);
  AddMolecule(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(-2.3, 2.1, 5.0);
  camera->SetFocalPoint(-0.15, 0.12, -0.5);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();

  example::Window window(renderer, 480, 320, picture);
  Report(pass);
  return window.Show();
}
