// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameQuadrature.h"

#include "vtkAirlightLight.h"
#include "vtkLight.h"

#include <stdexcept>
#include <string>

namespace benchmarks
{
namespace
{
// The light is at a height of 4.5.
void SetBox(FrameScene& scene, double top)
{
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-6.0, 6.0, -1.0, top, -6.0, 6.0);
}

// And 3.6 away from the middle.
void SetSphere(FrameScene& scene, double radius)
{
  scene.Medium->SetRegionToSphere();
  scene.Medium->SetCenter(0.0, 1.0, 0.0);
  scene.Medium->SetRadius(radius);
}

void SetHeightFog(FrameScene& scene)
{
  scene.GetFirstLamp()->SetPositional(false);
  scene.Medium->SetDensityToExponentialHeight();
  scene.Medium->SetScaleHeight(3.0);
}

void SetPhotometry(FrameScene& scene)
{
  const std::string path = AIRLIGHT_TEST_DATA "/Photometry/downlight.ies";
  if (!vtkAirlightLight::SetPhotometry(scene.GetFirstLamp(), path.c_str()))
  {
    throw std::runtime_error("cannot read the photometric file " + path);
  }
}

struct Pair
{
  const char* Name;
  void (*Quadrature)(FrameScene& scene);
  void (*Closed)(FrameScene& scene);
};

const Pair Pairs[] = {
  { "light-outside-box", [](FrameScene& scene) { SetBox(scene, 4.0); },
    [](FrameScene& scene) { SetBox(scene, 5.0); } },
  { "light-outside-sphere", [](FrameScene& scene) { SetSphere(scene, 3.4); },
    [](FrameScene& scene) { SetSphere(scene, 4.0); } },
  { "mie", [](FrameScene& scene) { scene.Medium->SetPhaseFunctionToMieMurky(); },
    [](FrameScene& scene) {
      scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
      scene.Medium->SetAnisotropy(0.8);
    } },
  { "height-fog-in-box",
    [](FrameScene& scene) {
      SetHeightFog(scene);
      SetBox(scene, 5.0);
    },
    [](FrameScene& scene) { SetHeightFog(scene); } },
  { "lamp-in-height-fog",
    [](FrameScene& scene) {
      scene.Medium->SetDensityToExponentialHeight();
      scene.Medium->SetScaleHeight(3.0);
    },
    [](FrameScene&) {} },
  { "photometry", [](FrameScene& scene) { SetPhotometry(scene); }, [](FrameScene&) {} },
};
}

//------------------------------------------------------------------------------
std::vector<SceneRecipe> MakeQuadratureRecipes(const std::function<void(FrameScene&)>& fill)
{
  std::vector<SceneRecipe> recipes;
  for (const Pair& pair : Pairs)
  {
    SceneRecipe recipe;
    recipe.Name = std::string("quadrature/") + pair.Name;
    recipe.Fill = [fill, change = pair.Quadrature](FrameScene& scene) {
      fill(scene);
      change(scene);
    };
    recipe.Base = [fill, change = pair.Closed](FrameScene& scene) {
      fill(scene);
      change(scene);
    };
    recipe.BaseName = Neighbour;
    recipe.Width = 400;
    recipe.Height = 300;
    recipe.Ways = { MakePlain(), MakeUnshadowed(), MakePlanes() };
    recipes.push_back(recipe);
  }
  return recipes;
}
}
