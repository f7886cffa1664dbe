// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the medium leaves of light on its way to surfaces. Where it is everywhere the same the
// mappers' shaders take their own distance to the lamp for it, else the pixel's ray: in a medium
// that ends far outside of all there is to be seen both must be the same. And whatever calls for
// the one or the other from frame to frame, surfaces are those of a fresh scene.

#include "AirlightTestPhotometry.h"
#include "AirlightTestWindowScene.h"

#include "vtkLightCollection.h"

#include <functional>
#include <string>

using namespace airlight_test;

namespace
{
using Change = std::function<void(WindowScene&)>;

void Unbound(WindowScene& scene) { scene.Medium->SetRegionToUnbounded(); }

void BoundFarAway(WindowScene& scene)
{
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-90, 90, -90, 90, -90, 90);
}

vtkLight* GetLight(WindowScene& scene, int index)
{
  return vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(index));
}

//------------------------------------------------------------------------------
// Single precision: the depth, up to 3, of either way has an error of a few parts in 1e7 of it.
void CompareRegions(const std::string& name, const Change& change)
{
  WindowScene unbounded(120, 90, 2);
  Unbound(unbounded);
  change(unbounded);
  WindowScene bounded(120, 90, 2);
  BoundFarAway(bounded);
  change(bounded);
  const Buffers a = unbounded.Render();
  const Buffers b = bounded.Render();
  Check(AreSame(a.at("Depth"), b.at("Depth")), name + ": the same distances");
  const double difference = CompareBuffers(a.at("Surface"), b.at("Surface"));
  std::cout << name << ": surfaces differ by " << difference << " of the brightest\n";
  Check(difference < 3e-6, name + ": the same light on surfaces");
  // Not because there is none.
  Check(GetValue(a.at("Surface"), 60, 20) > 0.01, name + ": the floor is lit");
}

void TestRegions()
{
  CompareRegions("two lamps", [](WindowScene&) {});
  CompareRegions("no shadows", [](WindowScene& s) { s.Pass->SetShadowTechniqueToNone(); });
  CompareRegions(
    "a coloured medium", [](WindowScene& s) { s.Medium->SetScattering(0.02, 0.05, 0.12); });
  CompareRegions("a spot", [](WindowScene& s) { GetLight(s, 0)->SetConeAngle(50.0); });
  CompareRegions("a lamp for surfaces alone",
    [](WindowScene& s) { s.Pass->SetLightScatters(GetLight(s, 0), false); });
  CompareRegions("parallel projection", [](WindowScene& s) {
    s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    s.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  });
  CompareRegions("an actor's matrix", [](WindowScene& s) {
    s.Ball->SetScale(1.5, 0.7, 1.2);
    s.Ball->RotateZ(30.0);
  });
  CompareRegions("six lamps", [](WindowScene& s) {
    for (int i = 0; i < 4; ++i)
    {
      s.AddPointLight({ 3.0 - 2.0 * i, 3.0, 3.0 }, { 2, 2, 2 });
    }
  });
}

//------------------------------------------------------------------------------
// A scene drawn, changed and drawn is a fresh one that was changed; and taken back it is the first.
void CompareChange(
  const std::string& name, const Change& start, const Change& change, const Change& back)
{
  WindowScene scene(120, 90, 2);
  start(scene);
  const Buffers before = scene.Render();
  change(scene);
  const Buffers after = scene.Render();
  WindowScene fresh(120, 90, 2);
  start(fresh);
  change(fresh);
  CheckSame(fresh.Render(), after, name);
  Check(!AreSame(before.at("Surface"), after.at("Surface")), name + ": surfaces change");
  back(scene);
  CheckSame(before, scene.Render(), name + ", taken back");
}

void TestChanges(const std::string& photometry)
{
  CompareChange(
    "bounds", Unbound, [](WindowScene& s) { s.Medium->SetRegionToSphere(); }, Unbound);
  CompareChange(
    "height fog", Unbound,
    [](WindowScene& s) {
      s.Medium->SetDensityToExponentialHeight();
      s.Medium->SetScaleHeight(2.0);
    },
    [](WindowScene& s) { s.Medium->SetDensityToUniform(); });
  vtkNew<vtkParticipatingMedium> smoke;
  smoke->SetAbsorption(0.1, 0.1, 0.1);
  CompareChange(
    "a second medium", Unbound, [&](WindowScene& s) { s.Pass->AddMedium(smoke); },
    [&](WindowScene& s) { s.Pass->RemoveMedium(smoke); });
  CompareChange(
    "a lamp without power", Unbound, [](WindowScene& s) { GetLight(s, 0)->SetIntensity(0.0); },
    [](WindowScene& s) { GetLight(s, 0)->SetIntensity(1.0); });
  CompareChange(
    "photometry", Unbound,
    [&](WindowScene& s) {
      Check(s.Pass->SetLightPhotometry(GetLight(s, 0), photometry.c_str()), "the file is read");
    },
    [](WindowScene& s) { s.Pass->SetLightPhotometry(GetLight(s, 0), nullptr); });
}
}

//------------------------------------------------------------------------------
int TestLightTransmittance(int argc, char* argv[])
{
  TestRegions();
  TestChanges(GetPhotometricFile(argc, argv, "lowbeam.ies"));
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
