// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows from shadow maps, against brute force (see AirlightTestBruteForce.h), for all kinds of
// lights, cameras and casters. The contract: half a percent in the median, five percent in the 99th
// percentile.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestErrors.h"

#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
Limits MapLimits()
{
  Limits limits;
  limits.Technique = vtkAirlightPass::SHADOW_MAP;
  limits.Median = 3e-3;
  limits.P99 = 1.5e-2;
  limits.Wrong = 1.0; // the percentiles say it
  // A texel is 2/1024 of the distance to the light, a pixel of these scenes 1/160 of that to the
  // eye.
  limits.EdgePixels = 0.7;
  return limits;
}

void CompareMap(const std::string& name, Scene& scene, bool spot = false)
{
  scene.Pass->SetShadowTechniqueToShadowMap();
  Limits limits = MapLimits();
  limits.Spot = spot;
  CompareScene(name, scene, 700, limits);
}

// Horizontal rectangles without thickness.
void AddSheet(Scene& scene, const glm::dvec3& centre, double dx, double dz)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(centre.x - dx, centre.y, centre.z + dz);
  plane->SetPoint1(centre.x + dx, centre.y, centre.z + dz);
  plane->SetPoint2(centre.x - dx, centre.y, centre.z - dz);
  scene.Add(plane);
}

void AddSpot(Scene& scene, double coneAngle)
{
  vtkLight* light = scene.AddPointLight({ 1, 5, 1 }, glm::dvec3(100.0));
  light->SetConeAngle(coneAngle);
  light->SetExponent(0.0);
  light->SetFocalPoint(-0.2, -2.5, 0.3);
}

void SetParallel(Scene& scene)
{
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
}

//------------------------------------------------------------------------------
void TestLights()
{
  Scene point;
  point.AddPointLight({ 2, 4, 3 });
  AddOpenBodies(point);
  CompareMap("point light", point);
  SetParallel(point);
  CompareMap("parallel projection, point light", point);

  Scene sun;
  sun.AddDirectionalLight({ 0.7, 2, 0.5 });
  AddOpenBodies(sun);
  CompareMap("directional light", sun);
  SetParallel(sun);
  CompareMap("parallel projection, directional light", sun);

  // All of a ray is lit or dark.
  Scene against;
  against.Look({ 7, 3, 10 }, { 0, 0, 0 });
  SetParallel(against);
  against.AddDirectionalLight({ -7, -3, -10 });
  AddOpenBodies(against);
  CompareMap("sun against a parallel view", against);

  for (const double angle : { 30.0, 75.0 })
  {
    Scene spot;
    AddSpot(spot, angle);
    AddOpenBodies(spot);
    CompareMap("spot of " + std::to_string(angle) + " degrees", spot, true);
  }

  // The map covers the cone, and no more.
  Scene opened;
  AddSpot(opened, 20.0);
  AddOpenBodies(opened);
  opened.Pass->SetShadowTechniqueToShadowMap();
  opened.Render();
  opened.Lights[0]->SetConeAngle(50.0);
  CompareMap("spot that opens", opened, true);

  Scene both;
  both.AddPointLight({ 3, 4, 2 });
  both.AddDirectionalLight({ -1, 1, 0.3 }, { 0.5, 0.2, 0.1 });
  AddOpenBodies(both);
  CompareMap("two lights", both);

  Scene box;
  box.AddPointLight({ 5, 6, 3 });
  box.Medium->SetRegionToBox();
  box.Medium->SetBounds(-4, 3, -2, 5, -3, 4);
  AddOpenBodies(box);
  CompareMap("box of medium beside the light", box);
}

//------------------------------------------------------------------------------
void TestCasters()
{
  Scene sheets;
  sheets.AddPointLight({ 0.4, 5, 0.2 });
  AddSheet(sheets, { 0, -2.5, -1 }, 8, 7);
  AddSheet(sheets, { -1.2, 1, 0 }, 0.7, 1.0);
  AddSheet(sheets, { 1.2, 0.3, 0.4 }, 0.8, 0.5);
  sheets.Add(MakeSoup({ { { 0, 2, 1 }, { 0.6, 2.2, 0.2 }, { -0.3, 2.4, -1 } } }));
  CompareMap("open sheets", sheets);

  Scene shadow;
  // From the side: rays that leave a shadow along its very edge leave it where a texel says.
  shadow.AddPointLight({ 7, 2, 10 });
  AddOpenBodies(shadow);
  vtkNew<vtkCubeSource> screen;
  screen->SetBounds(3.9, 4, -1, 4, 9, 11);
  shadow.Add(screen);
  CompareMap("camera in shadow", shadow);

  Scene far;
  const glm::dvec3 shift(1e6, -2e6, 5e5);
  far.Look(shift + glm::dvec3(0, 1, 10), shift);
  far.AddPointLight(shift + glm::dvec3(3, 4, 2));
  vtkNew<vtkSphereSource> sphere;
  for (double x : { -1.5, 1.5 })
  {
    far.Add(sphere, [&](vtkActor* actor) { actor->SetPosition(shift.x + x, shift.y, shift.z); });
  }
  CompareMap("a million units from the origin", far);
}

//------------------------------------------------------------------------------
// Bodies that a glyph mapper draws at these places.
vtkSmartPointer<vtkActor> AddGlyphs(
  Scene& scene, vtkPolyData* body, const std::vector<glm::dvec3>& places)
{
  vtkNew<vtkPoints> points;
  for (const glm::dvec3& place : places)
  {
    points->InsertNextPoint(&place.x);
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, 3, place[i]);
    }
    scene.AddTriangles(body, matrix);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceData(body);
  mapper->ScalingOff();
  mapper->ScalarVisibilityOff();
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  scene.Renderer->AddActor(actor);
  return actor;
}

void TestGlyphs()
{
  vtkNew<vtkCubeSource> source;
  source->SetXLength(0.8);
  source->SetZLength(0.7);
  vtkSmartPointer<vtkPolyData> cube = Make(source);
  for (const bool directional : { false, true })
  {
    for (const bool parallel : { false, true })
    {
      Scene scene;
      directional ? scene.AddDirectionalLight({ 0.7, 2, 0.5 }) : scene.AddPointLight({ 2, 4, 3 });
      AddSheet(scene, { 0, -2.5, -1 }, 8, 7);
      scene.Add(MakeSphere(0.7));
      AddGlyphs(scene, cube, { { -1.8, 0.1, 0.3 }, { 1.7, 0.4, 0.2 }, { 2.2, 1.6, 1.9 } });
      AddGlyphs(scene, MakeSphere(0.6), { { -0.6, 5.5, 1.2 }, { 1.1, 6.3, 1.8 } }); // not in view
      if (parallel)
      {
        SetParallel(scene);
      }
      CompareMap(std::string("glyphs, ") + (directional ? "directional" : "point") + " light" +
          (parallel ? ", parallel projection" : ""),
        scene);
    }
  }
}

//------------------------------------------------------------------------------
// Maps are kept between frames: a picture must be that of a new scene.
void TestUpdates()
{
  const auto draw = [](bool change) {
    Scene scene(80, 60);
    scene.Pass->SetShadowTechniqueToShadowMap();
    scene.AddPointLight(change ? glm::dvec3(3, 4, 1) : glm::dvec3(1, 3, 3));
    scene.AddDirectionalLight({ 1, 2, change ? 1.0 : 2.0 });
    vtkActor* body = scene.Add(MakeSphere(1.0));
    body->SetPosition(change ? 0 : 1, 0, 0);
    AddSheet(scene, { 0, -2.5, -1 }, 8, 7);
    scene.Pass->SetShadowMapResolution(change ? 64 : 256);
    const Buffers first = scene.Render();
    scene.Lights[0]->SetPosition(1, 3, 3);
    scene.Lights[1]->SetPosition(1, 2, 2);
    body->SetPosition(1, 0, 0);
    scene.Pass->SetShadowMapResolution(256);
    const Buffers second = scene.Render();
    Check(AreSame(first.at("Airlight"), second.at("Airlight")) != change, "a change shows");
    return second;
  };
  CheckSame(draw(false), draw(true), "changed light, caster and map");
}

//------------------------------------------------------------------------------
// A march approaches the same answer with more steps, more slowly; without casters it is lit air.
void TestRayMarch()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 3 });
  scene.AddDirectionalLight({ 0.7, 2, 0.5 }, { 0.5, 0.2, 0.1 });
  AddOpenBodies(scene);
  scene.Pass->SetShadowTechniqueToRayMarch();
  scene.Pass->SetNumberOfSteps(1024);
  Limits limits = MapLimits();
  limits.Technique = vtkAirlightPass::RAY_MARCH;
  CompareScene("ray march", scene, 500, limits);
  for (const int technique : { vtkAirlightPass::RAY_MARCH, vtkAirlightPass::SHADOW_MAP })
  {
    Scene empty(40, 30);
    empty.AddPointLight({ 2, 4, 3 });
    empty.AddDirectionalLight({ 0.7, 2, 0.5 }, { 0.5, 0.2, 0.1 });
    empty.Pass->SetShadowTechnique(technique);
    empty.Pass->SetNumberOfSteps(1024);
    empty.Window->Render();
    Check(empty.Pass->GetEffectiveShadowTechnique() == technique, "an empty scene's technique");
    for (int x = 0; x < 40; x += 3)
    {
      const glm::dvec3 expected = empty.GetAnswer(x + 0.5, 15.5).Airlight;
      const glm::dvec3 value = GetColour(empty.GetBuffer("Airlight"), x, 15);
      Check(std::abs(value.y - expected.y) < 1e-3 * expected.y, "empty scene's airlight");
    }
  }
}

//------------------------------------------------------------------------------
void TestBadValues()
{
  vtkNew<vtkAirlightPass> pass;
  ErrorListener errors(pass);
  for (const int resolution : { -1, 0, 15, 8193 })
  {
    pass->SetShadowMapResolution(resolution);
    Check(errors.Take() == 1, "a bad resolution is an error");
    Check(errors.GetText().find(std::to_string(resolution) + " must be from 16 to 8192") !=
        std::string::npos,
      "the error names value and range");
  }
  for (const int steps : { -1, 0, 2049 })
  {
    pass->SetNumberOfSteps(steps);
    Check(errors.Take() == 1, "a bad number of steps is an error");
    Check(
      errors.GetText().find(std::to_string(steps) + " must be from 1 to 2048") != std::string::npos,
      "the error names value and range");
  }
  Check(pass->GetShadowMapResolution() == 1024 && pass->GetNumberOfSteps() == 64, "values stay");
  pass->SetShadowTechnique(5);
  Check(errors.Take() == 1, "technique 5 is an error");

  // As coarse as it may be, it still has no undefined numbers.
  Scene scene(40, 30);
  scene.AddPointLight({ 0, 1, 0 }); // in the middle of the sphere's surface
  scene.Add(MakeSphere(1.0));
  scene.Pass->SetShadowTechniqueToShadowMap();
  scene.Pass->SetShadowMapResolution(16);
  scene.Pass->SetNumberOfSteps(1);
  CheckFinite(scene.Render(), "coarsest map");
}
}

//------------------------------------------------------------------------------
int TestShadowMap(int, char*[])
{
  TestLights();
  TestCasters();
  TestGlyphs();
  TestUpdates();
  TestRayMarch();
  TestBadValues();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
