// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// One lamp for surfaces and medium: a white plane under a point light shows the radiance
// I/(pi r^2) cos(theta) of a Lambertian surface of albedo 1, attenuated on both ways. And the
// lights that the pass integrates otherwise: without fall-off, and the renderer's own headlight.

#include "AirlightTestPixelScene.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// Surface = I/(pi r^2) cos(theta) exp(-sigmaT (r + t)), r from the light to the point.
bool TestWhitePlane()
{
  Comparison clear("white plane in a clear medium, relative");
  Comparison foggy("white plane in fog, relative");
  Comparison depth("distance of the plane, relative");
  const double extinctions[][3] = { { 0, 0, 0 }, { 0.05, 0.05, 0.05 }, { 0.3, 0.1, 0.0 } };
  const glm::dvec3 lights[] = { { 0.5, 0.3, 2.0 }, { -1.5, 1.0, 0.7 }, { 30.0, 10.0, 40.0 } };
  PixelScene scene;
  scene.AddBroadPlane();
  scene.Renderer->AddLight(scene.Light);
  const double intensity[3] = { 10.0, 20.0, 3.0 };
  vtkAirlight::SetRadiantIntensity(scene.Light, intensity);
  for (const auto& sigmaT : extinctions)
  {
    scene.Medium->SetScattering(0.5 * sigmaT[0], 0.5 * sigmaT[1], 0.5 * sigmaT[2]);
    scene.Medium->SetAbsorption(0.5 * sigmaT[0], 0.5 * sigmaT[1], 0.5 * sigmaT[2]);
    for (const glm::dvec3& position : lights)
    {
      scene.Light->SetPosition(position.x, position.y, position.z);
      scene.RenderFitted();
      for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; ++pixel)
      {
        const int i = pixel % PixelScene::Width;
        const int j = pixel / PixelScene::Width;
        const PixelRay ray = scene.GetRay(i, j);
        const double t = -ray.Origin.z / ray.Direction.z;
        const glm::dvec3 point = ray.Origin + t * ray.Direction;
        const double r = glm::length(position - point);
        const auto describe = [&] {
          return Text("light ", Text3(&position.x), ", pixel ", i, " ", j, ", r ", r, ", t ", t);
        };
        depth.Add(std::abs(*scene.GetPixel("Depth", i, j) / t - 1.0), 1e-5, describe);
        for (int k = 0; k < 3; ++k)
        {
          const double expected =
            intensity[k] / (Pi * r * r) * (position.z / r) * std::exp(-sigmaT[k] * (r + t));
          (sigmaT[0] == 0.0 ? clear : foggy)
            .Add(std::abs(scene.GetPixel("Surface", i, j)[k] / expected - 1.0), 1e-5,
              [&] { return Text(describe(), ", sigmaT ", sigmaT[k]); });
        }
      }
    }
  }
  return AllOk({ &depth, &clear, &foggy });
}

//------------------------------------------------------------------------------
// "Airlight" against vtkAirlight with the same light, to 1e-3: finite and above 0 everywhere.
void CompareAirlight(PixelScene& scene, vtkLight* light, Comparison& comparison)
{
  for (int j = 0; j < PixelScene::Height; ++j)
  {
    for (int i = 0; i < PixelScene::Width; ++i)
    {
      const PixelRay ray = scene.GetRay(i, j);
      const float depth = *scene.GetPixel("Depth", i, j);
      const float* airlight = scene.GetPixel("Airlight", i, j);
      double expected[3];
      vtkAirlight::Inscatter(scene.Medium, light, &ray.Origin.x, &ray.Direction.x, 0.0,
        depth >= 0.0f ? depth : 1e18, expected);
      for (int k = 0; k < 3; ++k)
      {
        const double error = std::abs(airlight[k] - expected[k]) / expected[k];
        comparison.Add(airlight[k] > 0.0f ? error : 1e30, 1e-3, [&] {
          return Text("pixel ", i, " ", j, ", channel ", k, ", depth ", depth, ", g ",
            scene.Medium->GetAnisotropy(), "; expected ", expected[k], ", got ", airlight[k]);
        });
      }
    }
  }
}

bool TestOtherLights()
{
  Comparison headlight("the renderer's own headlight, relative");
  Comparison atCamera("point light at the camera without fall-off, relative");
  Comparison constant("point lights without fall-off, relative");
  for (double g : { 0.0, 0.6, -0.6 })
  {
    for (bool visible : { false, true })
    {
      PixelScene scene;
      scene.AddBroadPlane();
      scene.Actor->SetVisibility(visible);
      scene.Pass->SetShadowTechniqueToNone();
      scene.Medium->SetScattering(0.1, 0.3, 0.02);
      scene.Medium->SetAbsorption(0.05, 0.0, 0.2);
      scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
      scene.Medium->SetAnisotropy(g);
      scene.Renderer->AutomaticLightCreationOn();
      scene.Renderer->CreateLight();
      auto* own = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
      scene.Pass->SetLightScatters(own, true);
      scene.RenderFitted();
      CompareAirlight(scene, own, headlight);

      scene.Renderer->RemoveAllLights();
      vtkLight* light = scene.Light;
      light->PositionalOn();
      light->SetConeAngle(90.0);
      scene.Renderer->AddLight(light);
      light->SetPosition(scene.Renderer->GetActiveCamera()->GetPosition());
      scene.RenderFitted();
      CompareAirlight(scene, light, atCamera);
      for (const glm::dvec3& position :
        { glm::dvec3(0.3, 0.2, 1.0), glm::dvec3(-30.0, 5.0, 20.0), glm::dvec3(1.0, -4.0, 8.0) })
      {
        light->SetPosition(position.x, position.y, position.z);
        scene.RenderFitted();
        CompareAirlight(scene, light, constant);
      }
    }
  }
  return AllOk({ &headlight, &atCamera, &constant });
}
}

//------------------------------------------------------------------------------
int TestAirlightPassLights(int, char*[])
{
  const bool ok = TestWhitePlane();
  return TestOtherLights() && ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
