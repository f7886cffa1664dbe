// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's tone mapping outside the pass is its formula of the radiance, of radiances above 1, too.

#include "AirlightTestComposition.h"

#include "vtkToneMappingPass.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const double Exposure = 1.3;

// In linear light, as VTK documents them.
double Map(int type, double radiance)
{
  switch (type)
  {
    case vtkToneMappingPass::Clamp:
      return std::min(radiance, 1.0);
    case vtkToneMappingPass::Reinhard:
      return radiance / (radiance + 1.0);
    default:
      return 1.0 - std::exp(-Exposure * radiance);
  }
}

//------------------------------------------------------------------------------
// The largest distance of the picture from what is encoded for display, in steps of 1/255.
template <typename Mapping>
double GetLargestError(Composition& scene, const Picture& picture, const Mapping& map)
{
  double largest = 0.0;
  vtkImageData* radiance = scene.GetBuffer("Radiance");
  for (int y = 0; y < scene.Height; ++y)
  {
    for (int x = 0; x < scene.Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double shown = 255.0 * std::pow(map(GetValue(radiance, x, y, c)), 1.0 / 2.2);
        const double error = std::abs(picture[3 * (y * scene.Width + x) + c] - shown);
        largest = error <= largest ? largest : error; // NaN stays
      }
    }
  }
  return largest;
}

int CountBright(Composition& scene)
{
  int count = 0;
  vtkImageData* radiance = scene.GetBuffer("Radiance");
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    count += GetValue(radiance, i % scene.Width, i / scene.Width) > 1.2 ? 1 : 0;
  }
  return count;
}

// Rounding to 8 bits is 0.5; single precision and the graphics card's powers are less than as much
// again.
void CheckMappings(Composition& scene, vtkToneMappingPass* tone, const std::string& what)
{
  for (const int type :
    { vtkToneMappingPass::Clamp, vtkToneMappingPass::Reinhard, vtkToneMappingPass::Exponential })
  {
    tone->SetToneMappingType(type);
    const Picture picture = scene.Show(tone);
    const double error =
      GetLargestError(scene, picture, [type](double radiance) { return Map(type, radiance); });
    std::cout << what << ", type " << type << ": differs by " << error << "\n";
    Check(error <= 1.0, what + ": the formula's picture, type " + std::to_string(type));
    const int bright = CountBright(scene);
    Check(bright > 200, what + ": radiances above 1.2 in " + std::to_string(bright) + " pixels");
  }
}
}

//------------------------------------------------------------------------------
int TestCompositionToneMapping(int, char*[])
{
  Composition scene;
  const double intensity[3] = { 300.0, 250.0, 180.0 };
  vtkAirlight::SetRadiantIntensity(scene.Lamp, intensity);
  scene.Pass->EncodedOutputOn();
  const Picture encoded = scene.Show(scene.Pass);
  const double error =
    GetLargestError(scene, encoded, [](double radiance) { return std::min(radiance, 1.0); });
  Check(error <= 1.0, "an encoded picture is that of the radiance: " + std::to_string(error));

  vtkNew<vtkToneMappingPass> tone;
  tone->SetDelegatePass(scene.Pass);
  tone->SetExposure(static_cast<float>(Exposure));
  CheckMappings(scene, tone, "surfaces");
  scene.AddTranslucentBall();
  CheckMappings(scene, tone, "translucent surfaces");
  tone->ReleaseGraphicsResources(scene.Window);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
