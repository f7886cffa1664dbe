// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps with photometric files in the pass: airlight against quadrature and lit surfaces against
// the formula, with the intensity looked up by hand; random tables of every type and symmetry and
// the files of Testing/Data/Photometry, fog everywhere, in a box and in a sphere.

#include "AirlightTestGoniometry.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"

#include <cstdlib>
#include <fstream>

using namespace airlight_test;

namespace
{
constexpr int Step = 37; // every 37th pixel is compared

struct Comparisons
{
  Comparison Airlight{ "airlight, relative" };
  Comparison Surface{ "surfaces, relative" };
  Comparison Maximum{ "largest intensity, relative" };
  long Bright = 0;  // rays with airlight
  long Shining = 0; // lit pixels of surfaces
};

class Experiment
{
public:
  Experiment() { this->Scene.AddTiltedPlane(); }

  // False where the pass refuses the file.
  bool Run(const LampTable& table, const std::string& file, double multiplier, Comparisons& found);

private:
  void PlaceLamp(const LampTable& table);
  void PlaceFog();
  void Compare(int pixel, Comparisons& found);

  Random Numbers{ 51 };
  int Index = 0;
  double Brightest = 0.0;
  TestFog Fog;
  TestGoniometricLamp Lamp;
  glm::dvec3 Normal{ 0.0 };
  PixelScene Scene;
};

//------------------------------------------------------------------------------
void Experiment::PlaceLamp(const LampTable& table)
{
  Random& random = this->Numbers;
  this->Lamp.Table = table;
  this->Lamp.Position = random.Uniform(0.3, 4.0) * RandomUnit(random);
  const glm::dvec3 aim = random.Uniform(0.0, 1.0) * RandomUnit(random);
  const glm::dvec3 up = random.LogUniform(1e-3, 1e3) * RandomUnit(random);
  this->Lamp.Aim(aim - this->Lamp.Position, up);
  this->Lamp.Intensity = { random.Uniform(5.0, 50.0), 12.0, random.Uniform(5.0, 50.0) };
  vtkAirlight::SetRadiantIntensity(this->Scene.Light, &this->Lamp.Intensity.x);
  this->Scene.Light->SetLightTypeToSceneLight();
  this->Scene.Light->SetPosition(&this->Lamp.Position.x);
  this->Scene.Light->SetFocalPoint(&aim.x);
  this->Scene.Pass->SetLightPhotometryUp(this->Scene.Light, up.x, up.y, up.z);
}

//------------------------------------------------------------------------------
// The camera and the lamp are inside or outside of the region by chance.
void Experiment::PlaceFog()
{
  Random& random = this->Numbers;
  vtkParticipatingMedium* medium = this->Scene.Medium;
  this->Fog.Region = this->Index % 3;
  this->Fog.Low = { -2.0, -1.5, -2.5 };
  this->Fog.High = { 2.5, 2.0, 1.8 };
  this->Fog.Centre = { 0.3, 0.2, -0.1 };
  this->Fog.Radius = 2.2;
  this->Fog.SigmaS = { random.LogUniform(0.02, 0.5), 0.2, random.LogUniform(0.02, 0.5) };
  const glm::dvec3 sigmaA(0.01, random.Uniform(0.0, 0.2), 0.05);
  this->Fog.SigmaT = this->Fog.SigmaS + sigmaA;
  const double anisotropies[] = { 0.0, 0.6, -0.4, 0.0, 0.85 };
  this->Fog.G = anisotropies[this->Index % 5];
  medium->SetScattering(&this->Fog.SigmaS.x);
  medium->SetAbsorption(&sigmaA.x);
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetPhaseTolerance(1e-5);
  medium->SetAnisotropy(this->Fog.G);
  const glm::dvec3& low = this->Fog.Low;
  const glm::dvec3& high = this->Fog.High;
  medium->SetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
  medium->SetCenter(&this->Fog.Centre.x);
  medium->SetRadius(this->Fog.Radius);
  const int regions[] = { vtkParticipatingMedium::UNBOUNDED, vtkParticipatingMedium::BOX,
    vtkParticipatingMedium::SPHERE };
  medium->SetRegion(regions[this->Fog.Region]);
}

//------------------------------------------------------------------------------
// Light less than 1e-4 of the picture's brightest is measured against that.
void Experiment::Compare(int pixel, Comparisons& found)
{
  const int i = pixel % PixelScene::Width;
  const int j = pixel / PixelScene::Width;
  const int k = pixel % 3;
  const PixelRay ray = this->Scene.GetRay(i, j);
  const double depth = *this->Scene.GetPixel("Depth", i, j);
  const auto describe = [&](double expected, double value) {
    return Text("setting ", this->Index, ", pixel ", i, " ", j, ", channel ", k, ": expected ",
      expected, ", got ", value, "; table of type ", this->Lamp.Table.Type, ", region ",
      this->Fog.Region, ", g ", this->Fog.G, ", depth ", depth);
  };
  const double airlight = GoniometricAirlight(
    this->Fog, this->Lamp, ray.Origin, ray.Direction, 0.0, depth >= 0.0 ? depth : 1e9, k);
  const double value = this->Scene.GetPixel("Airlight", i, j)[k];
  found.Airlight.Add(std::abs(value - airlight) / std::max(airlight, 1e-4 * this->Brightest + 1e-9),
    1e-3, [&] { return describe(airlight, value); });
  found.Bright += airlight > 0.01 * this->Brightest;
  if (depth < 0.0)
  {
    return;
  }
  const double surface =
    GoniometricSurface(this->Fog, this->Lamp, ray.Origin, ray.Direction, depth, this->Normal, k);
  const double shown = this->Scene.GetPixel("Surface", i, j)[k];
  found.Surface.Add(std::abs(shown - surface) / std::max(surface, 1e-4), 1e-3,
    [&] { return describe(surface, shown); });
  found.Shining += surface > 1e-3;
}

//------------------------------------------------------------------------------
bool Experiment::Run(
  const LampTable& table, const std::string& file, double multiplier, Comparisons& found)
{
  Random& random = this->Numbers;
  ++this->Index;
  if (!this->Scene.Pass->SetLightPhotometry(this->Scene.Light, file.c_str()))
  {
    return false;
  }
  this->PlaceLamp(table);
  this->PlaceFog();
  const glm::dvec3 eye = random.Uniform(1.0, 6.0) *
    glm::normalize(glm::dvec3(random.Uniform(-0.7, 0.7), random.Uniform(-0.4, 0.4), 1.0));
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(&eye.x);
  camera->SetFocalPoint(0.1, 0.2, -0.3);
  camera->SetViewAngle(55.0);
  camera->SetParallelProjection(this->Index % 7 == 0);
  camera->SetParallelScale(2.0);
  camera->SetClippingRange(0.1, 50.0);
  this->Scene.Actor->SetVisibility(this->Index % 2);
  this->Scene.Plane->Update();
  this->Scene.Plane->GetNormal(&this->Normal.x);
  this->Scene.Window->Render();
  this->Brightest = this->Scene.Pass->GetBuffer("Airlight")->GetScalarRange()[1];
  for (int pixel = this->Index % Step; pixel < PixelScene::Width * PixelScene::Height;
       pixel += Step)
  {
    this->Compare(pixel, found);
  }
  const double maximum = this->Scene.Pass->GetLightPhotometryMaximum(this->Scene.Light);
  found.Maximum.Add(std::abs(maximum / (multiplier * this->Lamp.Largest()) - 1.0), 1e-14,
    [&] { return Text("setting ", this->Index, ": ", maximum); });
  return true;
}

//------------------------------------------------------------------------------
bool RunAll(const std::string& data, const std::string& temporary)
{
  Comparisons found;
  Experiment experiment;
  Random random(8);
  bool ok = true;
  for (int i = 0; i < 5 * TableKinds; ++i)
  {
    // TableNumbers() writes candela 1.5 times the values.
    const LampTable table = RandomTable(random, i % TableKinds);
    std::ofstream(temporary) << TableText(table);
    ok = experiment.Run(table, temporary, 1.5, found) && ok;
  }
  // Their multipliers times their ballast factors.
  const std::pair<const char*, double> files[] = { { "downlight.ies", 1.0 }, { "lowbeam.ies", 1.0 },
    { "streetlight.ies", 1.5 * 0.9 } };
  for (int i = 0; i < 6; ++i)
  {
    const std::string file = data + files[i % 3].first;
    ok = experiment.Run(ReadTable(file), file, files[i % 3].second, found) && ok;
  }
  std::cout << found.Bright << " bright rays, " << found.Shining << " lit pixels of surfaces\n";
  return AllOk({ &found.Airlight, &found.Surface, &found.Maximum }) && ok && found.Bright > 1000 &&
    found.Shining > 200;
}
}

//------------------------------------------------------------------------------
int TestPhotometryPass(int argc, char* argv[])
{
  const std::string temporary = GetTemporaryFile(argc, argv, "TestPhotometryPass.ies");
  return RunAll(GetPhotometricFile(argc, argv), temporary) ? EXIT_SUCCESS : EXIT_FAILURE;
}
