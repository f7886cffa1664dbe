// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Which casters AUTOMATIC gives a shadow map since their shadow planes would give a pixel more
// boundaries than SetMaximumBoundariesPerPixel() allows; how exact the picture then is, against
// shadow planes; that it says so once; and that nothing flickers where a camera crosses the limit.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestImageErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "ShadowVolumes/AirlightBoundaryEstimate.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
const int Automatic = vtkAirlightPass::AUTOMATIC;
const int Planes = vtkAirlightPass::SHADOW_PLANES;
const int Map = vtkAirlightPass::SHADOW_MAP;
const double Most = 3.0; // boundaries a pixel
const double Any = std::numeric_limits<double>::infinity();

// So many leaves around a place.
vtkSmartPointer<vtkPolyData> MakeSwarm(int count, const glm::dvec3& centre, unsigned int seed)
{
  Random random(seed);
  std::vector<Triangle> leaves;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at = centre +
      glm::dvec3(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    leaves.push_back({ at, at + 0.15 * RandomUnit(random), at + 0.15 * RandomUnit(random) });
  }
  return MakeSoup(leaves);
}

void AddFloor(Scene& scene) { scene.AddBox({ -8, -2.2, -8 }, { 8, -2, 8 }, glm::dvec3(0.7)); }

struct Difference
{
  double Rms = 0.0;    // over the mean airlight
  double Beyond = 0.0; // share of pixels beyond ErrorBound
  double Equal = 0.0;  // share of pixels in which only rounding differs
};

Difference Compare(const Buffers& picture, const Buffers& exact, int width, int height)
{
  Difference difference;
  for (int i = 0; i < width * height; ++i)
  {
    const int x = i % width;
    const int y = i / width;
    const glm::dvec3 value = GetColour(exact.at("Airlight"), x, y);
    const glm::dvec3 error = glm::abs(GetColour(picture.at("Airlight"), x, y) - value);
    const double largest = std::max({ error.x, error.y, error.z });
    difference.Beyond += largest > GetValue(picture.at("ErrorBound"), x, y) ? 1.0 : 0.0;
    difference.Equal += largest <= 1e-5 * value.x ? 1.0 : 0.0;
  }
  const double pixels = width * height;
  difference.Rms = GetError(picture, exact, "Airlight");
  difference.Beyond /= pixels;
  difference.Equal /= pixels;
  return difference;
}

Buffers Draw(Scene& scene, int technique, double most)
{
  scene.Pass->SetShadowTechnique(technique);
  scene.Pass->SetMaximumBoundariesPerPixel(most);
  return scene.Render();
}

//------------------------------------------------------------------------------
void CheckSwarm(const std::string& name, Scene& scene)
{
  AddFloor(scene);
  scene.Add(MakeSphere(0.6), [](vtkActor* actor) { actor->SetPosition(2.2, 0.0, 0.0); });
  scene.Add(MakeSwarm(4000, { -1.2, 0.2, 0.0 }, 5));
  ErrorListener warned(scene.Pass, vtkCommand::WarningEvent);
  const Buffers exact = Draw(scene, Planes, Most);
  Check(GetMean(exact.at("BoundaryCount")) > 1.2 * Most, name + ": there are many boundaries");
  Check(scene.Pass->GetEffectiveShadowTechnique() == Planes, name + ": forced planes");
  Check(warned.Take() == 0, name + ": forced planes need no warning");

  const Buffers mixed = Draw(scene, Automatic, Most);
  Check(scene.Pass->GetEffectiveShadowTechnique() == Map, name + ": the technique is a map");
  Check(scene.Pass->GetEffectiveShadowTechnique(scene.Lights[0]) == Map, name + ": of the light");
  Check(warned.Take() == 1, name + ": a warning");
  for (const char* word : { "SetMaximumBoundariesPerPixel", "ShadowPlanes" })
  {
    Check(warned.GetText().find(word) != std::string::npos,
      name + ": the warning says " + word + ": " + warned.GetText());
  }
  const Difference mixedError = Compare(mixed, exact, scene.Width, scene.Height);
  const Difference mapError = Compare(Draw(scene, Map, Most), exact, scene.Width, scene.Height);
  std::cout << name << ": error " << mixedError.Rms << " of the mean, " << mixedError.Beyond
            << " beyond the bound, " << mixedError.Equal << " equal; all from a map "
            << mapError.Rms << ", " << mapError.Beyond << ", " << mapError.Equal << "\n";
  Check(mixedError.Rms <= 5e-3 && mixedError.Rms > 0.0, name + ": error beside the mean airlight");
  Check(mixedError.Beyond <= 0.01 && mapError.Beyond <= 0.01, name + ": ErrorBound holds");
  // The ball keeps its planes.
  Check(mixedError.Equal > mapError.Equal, name + ": more is exact than with a map alone");

  CheckSame(exact, Draw(scene, Automatic, Any), name + ": without a limit it is planes");
  CheckSame(exact, Draw(scene, Planes, 0.0), name + ": planes stay what they are");
  CheckSame(mixed, Draw(scene, Automatic, Most), name + ": again");
  Check(warned.Take() == 0, name + ": it is said once");
}

void TestSwarms()
{
  Scene point(200, 150);
  point.AddPointLight({ 1.0, 5.0, 3.0 });
  CheckSwarm("point light", point);

  Scene sun(200, 150);
  sun.AddDirectionalLight({ 0.6, 2.0, 0.8 });
  CheckSwarm("directional light", sun);

  Scene parallel(200, 150);
  parallel.AddPointLight({ 1.0, 5.0, 3.0 });
  parallel.Renderer->GetActiveCamera()->ParallelProjectionOn();
  parallel.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  CheckSwarm("parallel projection", parallel);

  Scene coloured(200, 150);
  coloured.AddPointLight({ 1.0, 5.0, 3.0 });
  coloured.Medium->SetScattering(0.02, 0.05, 0.09);
  coloured.Medium->SetPhaseFunctionToHenyeyGreenstein();
  coloured.Medium->SetAnisotropy(0.6);
  CheckSwarm("coloured medium", coloured);
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
    scene.Add(MakeSwarm(300, { 0.0, 1.0, 0.0 }, 9));
    const double mean = GetMean(Draw(scene, Planes, Any).at("BoundaryCount"));
    const std::string name =
      Text(directional ? "directional" : "point", " light, ", mean, " boundaries: ");
    Draw(scene, Automatic, 1.1 * mean);
    Check(scene.Pass->GetEffectiveShadowTechnique() == Planes, name + "planes at a tenth more");
    Draw(scene, Automatic, 0.85 * mean);
    Check(scene.Pass->GetEffectiveShadowTechnique() == Map, name + "a map at some less");
  }
}

//------------------------------------------------------------------------------
// Each light decides for itself.
void TestLights()
{
  Scene scene(160, 120);
  vtkLight* above = scene.AddPointLight({ 0.0, 4.0, 0.0 });
  vtkLight* behind = scene.AddPointLight({ 0.0, -60.0, 0.0 }); // shadows leave the view
  vtkLight* dark = scene.AddPointLight({ 2.0, 3.0, 1.0 });
  dark->SetLightTypeToHeadlight(); // its shadows lie behind what casts them
  scene.Add(MakeSwarm(600, { 0.0, 2.5, 0.0 }, 3));
  vtkNew<vtkLight> other;
  Draw(scene, Automatic, 8.0);
  Check(scene.Pass->GetEffectiveShadowTechnique(above) == Map, "a map from above");
  Check(scene.Pass->GetEffectiveShadowTechnique(behind) == Planes, "planes from below");
  Check(scene.Pass->GetEffectiveShadowTechnique(dark) == vtkAirlightPass::NONE,
    Text("no shadows: ", scene.Pass->GetEffectiveShadowTechnique(dark)));
  Check(scene.Pass->GetEffectiveShadowTechnique(other) == vtkAirlightPass::NONE, "another light");
  Check(scene.Pass->GetEffectiveShadowTechnique(nullptr) == vtkAirlightPass::NONE, "no light");
  Draw(scene, vtkAirlightPass::NONE, 8.0);
  Check(scene.Pass->GetEffectiveShadowTechnique(above) == vtkAirlightPass::NONE, "no technique");
}

//------------------------------------------------------------------------------
// All of a prop goes to the map, the prop with the most boundaries first.
void TestChoice()
{
  const auto props = reinterpret_cast<const vtkProp*>(&Automatic); // to be compared only
  std::vector<airlight::Caster> casters(5);
  for (size_t i = 0; i < casters.size(); ++i)
  {
    casters[i].Owner = i < 3 ? nullptr : props;
    casters[i].OpticalThickness.Blocks = glm::ivec3(1);
  }
  const std::vector<double> boundaries{ 2.0, 3.0, 4.0, 5.0, 1.0 };
  using Chosen = std::vector<bool>;
  Check(airlight::FindCostlyCasters(casters, boundaries, 15.0).empty(), "none");
  Check(airlight::FindCostlyCasters(casters, boundaries, 14.0) ==
      Chosen({ true, true, true, false, false }),
    "the prop with the most");
  Check(airlight::FindCostlyCasters(casters, boundaries, 5.0) == Chosen(5, true), "both");
  casters[1].OpticalThickness.Blocks = glm::ivec3(0);
  Check(airlight::FindCostlyCasters(casters, boundaries, 5.0) ==
      Chosen({ false, false, false, true, true }),
    "what lets light through stays");
}

//------------------------------------------------------------------------------
// A camera that moves towards a swarm and beyond the limit.
void TestCameraPath()
{
  constexpr int Frames = 120;
  Scene scene(80, 60);
  scene.AddPointLight({ 0.3, 4.0, 0.2 });
  scene.Add(MakeSwarm(150, { 0.0, 1.0, 0.0 }, 11));
  int switches = 0;
  bool before = false;
  for (int i = 0; i < Frames; ++i)
  {
    scene.Look({ 0.0, 1.0, 30.0 - 25.0 * i / Frames }, { 0.0, 0.5, 0.0 });
    const Buffers picture = Draw(scene, Automatic, 5.0);
    const bool map = scene.Pass->GetEffectiveShadowTechnique() == Map;
    if (i > 0 && map != before)
    {
      ++switches;
      const Difference jump =
        Compare(Draw(scene, Map, 5.0), Draw(scene, Planes, 5.0), scene.Width, scene.Height);
      Check(jump.Beyond <= 0.01, Text("frame ", i, ": ", jump.Beyond, " beyond the bound"));
    }
    before = map;
  }
  Check(switches == 1, Text(switches, " changes of the technique"));
}

//------------------------------------------------------------------------------
void TestBadValues()
{
  vtkNew<vtkAirlightPass> pass;
  ErrorListener errors(pass);
  for (const double most : { -1.0, -Any, std::nan("") })
  {
    pass->SetMaximumBoundariesPerPixel(most);
    Check(errors.Take() == 1, "a bad number is an error");
    Check(errors.GetText().find("must not be below 0") != std::string::npos, "that says the range");
  }
  Check(pass->GetMaximumBoundariesPerPixel() == 16.0, "the value stays");
}
}

//------------------------------------------------------------------------------
int TestMaximumBoundaries(int, char*[])
{
  TestSwarms();
  TestThreshold();
  TestLights();
  TestChoice();
  TestCameraPath();
  TestBadValues();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
