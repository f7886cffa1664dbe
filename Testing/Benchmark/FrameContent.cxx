// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameContent.h"

#include "vtkCamera.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace benchmarks
{
//------------------------------------------------------------------------------
void FillBallAndFloor(FrameScene& scene, int lights)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 1.0, 0.0);
  ball->SetRadius(1.0);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(33);
  ball->Update();
  scene.Add(ball->GetOutput());
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-6.0, 0.0, 6.0);
  floor->SetPoint1(6.0, 0.0, 6.0);
  floor->SetPoint2(-6.0, 0.0, -6.0);
  floor->Update();
  scene.Add(floor->GetOutput());
  for (int k = 0; k < lights; ++k)
  {
    const double angle = 2.399963 * k; // the golden angle spreads any number of lights
    const double r = 0.9 * std::sqrt(static_cast<double>(k));
    scene.AddLamp(0.8 + r * std::cos(angle), 4.0, 0.6 + r * std::sin(angle));
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 3.0, 8.0);
  camera->SetFocalPoint(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.1, 40.0);
}

//------------------------------------------------------------------------------
std::vector<SceneRecipe> MakeContentRecipes()
{
  std::vector<Content> contents = GetMeshContent();
  for (const Content& content : GetPropContent())
  {
    contents.push_back(content);
  }
  std::vector<SceneRecipe> recipes;
  for (int lights : { 1, 4, 16 })
  {
    const std::string group =
      lights == 1 ? "content/" : "content-" + std::to_string(lights) + "-lights/";
    for (const Content& content : contents)
    {
      SceneRecipe recipe;
      recipe.Name = group + content.Name;
      recipe.Base = [lights](FrameScene& scene) { FillBallAndFloor(scene, lights); };
      recipe.BaseName = BallAndFloor;
      recipe.Fill = [lights, add = content.Add](FrameScene& scene) {
        FillBallAndFloor(scene, lights);
        add(scene);
      };
      recipe.Width = 400;
      recipe.Height = 300;
      recipe.Ways = { MakePlain(), MakeUnshadowed(), MakeAutomatic(), MakeShadowMap(64) };
      recipes.push_back(recipe);
    }
  }
  return recipes;
}
}
