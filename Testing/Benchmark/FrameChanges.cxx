// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameChanges.h"

#include "FrameRows.h"
#include "FrameWindow.h"

#include "vtkActor.h"
#include "vtkAirlight.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <string>

namespace benchmarks
{
namespace
{
struct Change
{
  const char* Name;
  void (*Apply)(FrameScene& scene);
  int Width = 800;
  int Height = 600;
};

void PutIntoSurface(vtkParticipatingMedium* medium)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 1.0, 0.0);
  ball->SetRadius(4.0);
  ball->SetThetaResolution(16);
  ball->SetPhiResolution(16);
  ball->Update();
  medium->SetRegionToSurface();
  medium->SetSurface(ball->GetOutput());
}

void SetImage(vtkParticipatingMedium* medium)
{
  vtkNew<vtkRTAnalyticSource> wavelet; // of 37 to 277
  wavelet->Update();
  medium->SetScattering(5e-4, 5e-4, 5e-4);
  medium->SetAbsorption(1e-4, 1e-4, 1e-4);
  medium->SetDensityImage(wavelet->GetOutput());
  medium->SetDensityToImage();
}

// Beside the fog.
void AddInside(FrameScene& scene, void (*change)(vtkParticipatingMedium* medium))
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.1, 0.1);
  change(medium);
  scene.AddMedium(medium);
}

const Change Numbers[] = {
  { "extinction", [](FrameScene& scene) { scene.Medium->SetScattering(0.05, 0.05, 0.05); } },
  { "lamp-moves", [](FrameScene& scene) { scene.GetFirstLamp()->SetPosition(1.0, 5.0, 0.3); } },
  { "lamp-dims",
    [](FrameScene& scene) {
      const double intensity[3] = { 10.0, 20.0, 30.0 };
      vtkAirlight::SetRadiantIntensity(scene.GetFirstLamp(), intensity);
    } },
  { "ball-moves", [](FrameScene& scene) { scene.GetFirstActor()->AddPosition(0.3, 0.2, 0.1); } },
  { "colour",
    [](FrameScene& scene) { scene.GetFirstActor()->GetProperty()->SetColor(0.2, 0.9, 0.4); } },
  { "window", [](FrameScene& scene) { scene.Window->SetSize(760, 570); } },
};

const Change Kinds[] = {
  { "coloured", [](FrameScene& scene) { scene.Medium->SetScattering(0.05, 0.06, 0.07); } },
  { "anisotropy",
    [](FrameScene& scene) {
      scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
      scene.Medium->SetAnisotropy(0.7);
    } },
  { "rayleigh", [](FrameScene& scene) { scene.Medium->SetPhaseFunctionToRayleigh(); } },
  { "box",
    [](FrameScene& scene) {
      scene.Medium->SetRegionToBox();
      scene.Medium->SetBounds(-6, 6, -1, 6, -6, 6);
    } },
  { "height",
    [](FrameScene& scene) {
      scene.Medium->SetDensityToExponentialHeight();
      scene.Medium->SetScaleHeight(3.0);
    } },
  { "second-lamp", [](FrameScene& scene) { scene.AddLamp(-2.0, 4.0, 1.0); } },
  { "spot",
    [](FrameScene& scene) {
      scene.GetFirstLamp()->SetPositional(true);
      scene.GetFirstLamp()->SetConeAngle(30.0);
      scene.GetFirstLamp()->SetExponent(0.0);
    } },
  { "sun", [](FrameScene& scene) { scene.GetFirstLamp()->SetPositional(false); } },
  { "translucent",
    [](FrameScene& scene) { scene.GetFirstActor()->GetProperty()->SetOpacity(0.5); } },
  // Their frames take long.
  { "surface", [](FrameScene& scene) { PutIntoSurface(scene.Medium); }, 160, 120 },
  { "surface-in-fog", [](FrameScene& scene) { AddInside(scene, PutIntoSurface); }, 160, 120 },
  { "image", [](FrameScene& scene) { SetImage(scene.Medium); }, 160, 120 },
  { "image-in-fog", [](FrameScene& scene) { AddInside(scene, SetImage); }, 160, 120 },
};
}

//------------------------------------------------------------------------------
std::vector<SceneRecipe> MakeChangeRecipes(const std::function<void(FrameScene&)>& fill)
{
  std::vector<SceneRecipe> recipes;
  const auto add = [&](const std::string& group, const Change& change) {
    SceneRecipe recipe;
    recipe.Name = "changes/" + group + change.Name;
    recipe.Fill = fill;
    recipe.Change = change.Apply;
    recipe.Width = change.Width;
    recipe.Height = change.Height;
    recipe.Ways = { MakePlain(), MakeAutomatic() };
    recipes.push_back(recipe);
  };
  for (const Change& change : Numbers)
  {
    add("number-", change);
  }
  for (const Change& change : Kinds)
  {
    add("kind-", change);
  }
  return recipes;
}

//------------------------------------------------------------------------------
void TimeChange(const SceneRecipe& recipe, const WindowMaker& windows, int repetitions, Rows& rows)
{
  for (int i = 0; i < repetitions; ++i)
  {
    for (const Way& way : recipe.Ways)
    {
      FrameScene scene(windows.Make(recipe.Width, recipe.Height));
      recipe.Fill(scene);
      const auto add = [&](const std::string& name, const FrameTime& time) {
        Row& row = rows.Get(recipe.Name, name);
        row.Counters = { { "width", recipe.Width }, { "height", recipe.Height } };
        row.Clock.Seconds.push_back(time.Clock);
        row.Processors.Seconds.push_back(time.Processor);
      };
      add(way.Name, scene.Time(way));
      recipe.Change(scene);
      add(way.Name + FirstFrame, scene.TimeOne(way));
      add(way.Name + SecondFrame, scene.TimeOne(way));
    }
  }
}

//------------------------------------------------------------------------------
void KeepNoShaders()
{
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  setenv("MESA_GLSL_CACHE_DISABLE", "true", 1);
}
}
