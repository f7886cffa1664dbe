// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent casters to which AUTOMATIC gives a froxel grid since their shadow planes would give a
// pixel more boundaries than SetMaximumBoundariesPerPixel() allows; how exact the picture then is,
// against shadow planes; that it says so once; and which casters keep their planes. The same grid
// for many point Gaussians.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestImageErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkPlaneSource.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
const int Automatic = vtkAirlightPass::AUTOMATIC;
const int Planes = vtkAirlightPass::SHADOW_PLANES;
const int Froxels = vtkAirlightPass::FROXELS;
const double Most = 3.0; // boundaries a pixel
const double Any = std::numeric_limits<double>::infinity();

// Thirty, one behind the other.
void AddSheets(Scene& scene, double opacity)
{
  for (int i = 0; i < 30; ++i)
  {
    const double z = -2.0 + 4.0 * i / 30;
    vtkNew<vtkPlaneSource> sheet;
    sheet->SetOrigin(-1.5, -1.0, z);
    sheet->SetPoint1(1.5, -1.0, z);
    sheet->SetPoint2(-1.5, 1.0, z);
    scene.Add(sheet, [opacity](vtkActor* actor) { actor->GetProperty()->SetOpacity(opacity); });
  }
}

Buffers Draw(Scene& scene, int technique, double most)
{
  scene.Pass->SetShadowTechnique(technique);
  scene.Pass->SetMaximumBoundariesPerPixel(most);
  return scene.Render();
}

int GetTechnique(Scene& scene) { return scene.Pass->GetEffectiveShadowTechnique(); }

// The share of pixels whose airlight differs by more than a limit.
template <typename Limit>
double GetShareBeyond(const Buffers& picture, const Buffers& exact, const Limit& limit)
{
  int count = 0;
  const int* size = exact.at("Airlight")->GetDimensions();
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    const int x = i % size[0];
    const int y = i / size[0];
    const glm::dvec3 error =
      glm::abs(GetColour(picture.at("Airlight"), x, y) - GetColour(exact.at("Airlight"), x, y));
    count += std::max({ error.x, error.y, error.z }) > limit(x, y) ? 1 : 0;
  }
  return double(count) / (size[0] * size[1]);
}

//------------------------------------------------------------------------------
// Measured: airlight 1.3e-4 to 6.9e-4 for faint sheets, 9.7e-4 to 4.5e-3 for dense ones; the
// picture, with the sheets, their light and their shadows on the floor, 5e-3 to 1.4e-2 and 4.8e-2
// to 9.6e-2.
struct Limits
{
  double Airlight;
  double Radiance;
};

void CheckSheets(const std::string& name, Scene& scene, double opacity, const Limits& limits)
{
  scene.AddBox({ -8, -2.2, -8 }, { 8, -2, 8 }, glm::dvec3(0.7));
  scene.Add(MakeSphere(0.6), [](vtkActor* actor) { actor->SetPosition(2.2, 0.0, 0.0); });
  AddSheets(scene, opacity);
  ErrorListener warned(scene.Pass, vtkCommand::WarningEvent);
  const Buffers exact = Draw(scene, Planes, Most);
  Check(GetMean(exact.at("BoundaryCount")) > 1.2 * Most, name + ": there are many boundaries");
  Check(GetTechnique(scene) == Planes && warned.Take() == 0, name + ": forced planes");

  const Buffers coarse = Draw(scene, Automatic, Most);
  Check(GetTechnique(scene) == Froxels, name + ": the technique is a grid");
  Check(
    scene.Pass->GetEffectiveShadowTechnique(scene.Lights[0]) == Froxels, name + ": of the light");
  Check(warned.Take() == 1, name + ": a warning");
  for (const char* word : { "SetMaximumBoundariesPerPixel", "ShadowPlanes", "grid" })
  {
    Check(warned.GetText().find(word) != std::string::npos,
      name + ": the warning says " + word + ": " + warned.GetText());
  }
  const double airlight = GetError(coarse, exact, "Airlight");
  const double radiance = GetError(coarse, exact, "Radiance");
  const double beyond = GetShareBeyond(
    coarse, exact, [&](int x, int y) { return GetValue(coarse.at("ErrorBound"), x, y); });
  const double other = GetShareBeyond(
    coarse, exact, [&](int x, int y) { return 1e-5 * GetValue(exact.at("Airlight"), x, y); });
  std::cout << name << ", opacity " << opacity << ": error " << airlight << " of the mean, "
            << beyond << " beyond the bound, " << 1.0 - other << " equal; picture " << radiance
            << "\n";
  Check(airlight <= limits.Airlight && airlight > 0.0, name + ": error beside the mean airlight");
  Check(radiance <= limits.Radiance, name + ": error of the picture");
  Check(beyond <= 0.01, name + ": ErrorBound holds");
  // Where translucent casters take nothing, all is as with planes.
  Check(other < 0.95, name + ": some pixels are exact");

  CheckSame(exact, Draw(scene, Automatic, Any), name + ": without a limit it is planes");
  CheckSame(exact, Draw(scene, Planes, 0.0), name + ": planes stay what they are");
  CheckSame(coarse, Draw(scene, Automatic, Most), name + ": again");
  Check(warned.Take() == 0, name + ": it is said once");
}

void CheckLights(double opacity, const Limits& limits)
{
  Scene point;
  point.AddPointLight({ 1.0, 5.0, 3.0 });
  CheckSheets("point light", point, opacity, limits);

  Scene sun;
  sun.AddDirectionalLight({ 0.6, 2.0, 0.8 });
  CheckSheets("directional light", sun, opacity, limits);

  Scene parallel;
  parallel.AddPointLight({ 1.0, 5.0, 3.0 });
  parallel.Renderer->GetActiveCamera()->ParallelProjectionOn();
  parallel.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  CheckSheets("parallel projection", parallel, opacity, limits);

  Scene coloured;
  coloured.AddPointLight({ 1.0, 5.0, 3.0 });
  coloured.Medium->SetScattering(0.02, 0.05, 0.09);
  coloured.Medium->SetPhaseFunctionToHenyeyGreenstein();
  coloured.Medium->SetAnisotropy(0.6);
  CheckSheets("coloured medium", coloured, opacity, limits);
}

//------------------------------------------------------------------------------
// With the airlight of each of two lights.
Buffers DrawWithLights(Scene& scene, int technique)
{
  Buffers buffers = Draw(scene, technique, Most);
  for (const char* name : { "Airlight:0", "Airlight:1" })
  {
    vtkNew<vtkImageData> copy;
    copy->DeepCopy(scene.GetBuffer(name));
    buffers[name] = copy.Get();
  }
  return buffers;
}

// What casters take of each light is in its own buffer, and in the sum.
void TestLights()
{
  Scene scene;
  scene.AddPointLight({ 1.0, 5.0, 3.0 });
  scene.AddDirectionalLight({ -0.6, 2.0, 0.8 });
  vtkLight* unshadowed = scene.AddPointLight({ -3.0, 1.0, 2.0 });
  unshadowed->SetLightTypeToHeadlight(); // its shadows lie behind what casts them
  AddSheets(scene, 0.1);
  const Buffers exact = DrawWithLights(scene, Planes);
  const Buffers coarse = DrawWithLights(scene, Automatic);
  Check(GetTechnique(scene) == Froxels, "lights: a grid");
  Check(scene.Pass->GetEffectiveShadowTechnique(unshadowed) == vtkAirlightPass::NONE,
    "lights: one has no shadows");
  for (const char* name : { "Airlight", "Airlight:0", "Airlight:1" })
  {
    const double error = GetError(coarse, exact, name);
    Check(error <= 2e-3, Text(name, ": error ", error));
  }
}

//------------------------------------------------------------------------------
// The number that decides is that of the boundaries that are drawn, where nothing hides them.
void TestThreshold()
{
  for (const bool directional : { false, true })
  {
    Scene scene(160, 120);
    directional ? scene.AddDirectionalLight({ 0.3, 1.0, 0.2 })
                : scene.AddPointLight({ 0.3, 4.0, 0.2 });
    AddSheets(scene, 0.1);
    const double mean = GetMean(Draw(scene, Planes, Any).at("BoundaryCount"));
    const std::string name =
      Text(directional ? "directional" : "point", " light, ", mean, " boundaries: ");
    Draw(scene, Automatic, 1.1 * mean);
    Check(GetTechnique(scene) == Planes, name + "planes at a tenth more");
    Draw(scene, Automatic, 0.9 * mean);
    Check(GetTechnique(scene) == Froxels, name + "a grid at a tenth less");
    scene.Pass->TranslucentShadowsOff();
    Draw(scene, Automatic, 0.9 * mean);
    Check(GetTechnique(scene) == Planes, name + "planes where they cast no shadows");
  }
}

//------------------------------------------------------------------------------
// Their fragments have no records then. Before them and on them are the shadows of a ball, and of
// themselves, from a map.
void TestGaussians()
{
  Scene scene;
  scene.AddPointLight({ 1.0, 5.0, 3.0 });
  scene.AddBall({ 0.8, 1.5, 1.0 }, 0.6, glm::dvec3(0.5));
  Random random(7);
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 2000; ++i)
  {
    points->InsertNextPoint(
      random.Uniform(-2.0, 2.0), random.Uniform(-1.0, 1.0), random.Uniform(-2.0, 2.0));
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(cloud);
  mapper->SetScaleFactor(0.05);
  mapper->EmissiveOff();
  scene.Renderer->AddActor(Scene::MakeActor(mapper));
  ErrorListener warned(scene.Pass, vtkCommand::WarningEvent);
  const Buffers exact = Draw(scene, Automatic, Any);
  warned.Take();
  const Buffers coarse = Draw(scene, Automatic, Most);
  Check(warned.Take() == 1, "Gaussians: a warning");
  Check(warned.GetText().find("Gaussians") != std::string::npos, warned.GetText());
  Check(GetTechnique(scene) == vtkAirlightPass::SHADOW_MAP, "Gaussians: they cast by a map");
  // Nothing lets light through: what opaque surfaces have is as before.
  Check(GetError(coarse, exact, "Airlight") == 0.0, "Gaussians: the airlight before surfaces");
  const double error = GetError(coarse, exact, "Radiance");
  std::cout << "Gaussians: error " << error << " of the picture\n";
  Check(error > 0.0 && error <= 2e-2, "Gaussians: error of the picture");
  scene.Pass->SetShadowTechniqueToNone();
  Check(GetError(scene.Render(), exact, "Radiance") > 3.0 * error,
    "Gaussians: it is less than that without shadows");
}

//------------------------------------------------------------------------------
// A grid has one number for what blocks light, not one for each channel.
void TestBlockedChannel()
{
  Scene scene(80, 60);
  scene.AddPointLight({ 0.3, 4.0, 0.2 });
  AddSheets(scene, 0.1);
  vtkActor* filter = scene.Add(MakeSphere(0.3));
  vtkAirlightPass::SetShadowOpacity(filter, 1.0, 0.5, 0.0);
  Draw(scene, Automatic, 1.0);
  Check(GetTechnique(scene) == Planes, "planes beside a filter that blocks one channel");
}
}

//------------------------------------------------------------------------------
int TestFroxels(int, char*[])
{
  CheckLights(0.05, { 1.5e-3, 2e-2 });
  CheckLights(0.5, { 5e-3, 1e-1 });
  TestLights();
  TestGaussians();
  TestThreshold();
  TestBlockedChannel();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
