// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A cloud of noise whose details are as small as a few samples, on which nothing was tuned, in a
// turned image: vtkAirlightPass against vtkAirlightReference. What the sun loses comes from a grid
// along its rays: they are oblique, along an axis and along a face. A lamp's grid is even.

#include "AirlightTestDensity.h"
#include "AirlightTestTools.h"

#include "vtkMatrix3x3.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr double Median = 1e-3;
constexpr double P99 = 1e-2;

struct Wave
{
  glm::dvec3 Way;
  double Phase;
  double Height;
};

// Nothing at the image's rim.
void FillNoise(vtkImageData* image, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Wave> waves(40);
  for (Wave& wave : waves)
  {
    const double frequency = random.LogUniform(6.0, 60.0); // radians in the longest side
    wave.Way = frequency * glm::normalize(RandomPoint(random, 1.0));
    wave.Phase = random.Uniform(0.0, 6.3);
    wave.Height = std::pow(frequency, -0.6);
  }
  int size[3];
  image->GetDimensions(size);
  const double longest = std::max({ size[0], size[1], size[2] }) - 1.0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const glm::dvec3 place(i, j, k);
        double sum = 0.0;
        for (const Wave& wave : waves)
        {
          sum += wave.Height * std::sin(glm::dot(wave.Way, place) / longest + wave.Phase);
        }
        const glm::dvec3 share = place / glm::dvec3(size[0] - 1, size[1] - 1, size[2] - 1);
        const glm::dvec3 rim = 4.0 * share * (1.0 - share);
        const double density = 0.5 * sum + 2.0 * rim.x * rim.y * rim.z;
        image->SetScalarComponentFromDouble(i, j, k, 0, std::max(density, 0.0) * rim.x);
      }
    }
  }
}

void Compare(const std::string& name, const std::function<void(Scene&, vtkImageData*)>& light)
{
  const auto image =
    MakeDensity(glm::ivec3(130, 44, 100), glm::dvec3(-3, -1, -2.3), glm::dvec3(3, 1, 2.3));
  FillNoise(image, 90210);
  Rotate(image, 0.4, 0.2);
  DensityScene scene(image, 40, 30);
  scene.Medium->SetScattering(0.9, 0.8, 0.7);
  scene.Medium->SetAbsorption(0.1, 0.1, 0.1);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.5);
  light(scene, image);
  scene.Compare(name, Median, P99);
}

glm::dvec3 GetAxis(vtkImageData* image, int axis)
{
  return { image->GetDirectionMatrix()->GetElement(0, axis),
    image->GetDirectionMatrix()->GetElement(1, axis),
    image->GetDirectionMatrix()->GetElement(2, axis) };
}
}

//------------------------------------------------------------------------------
int TestDetailedCloud(int, char*[])
{
  Compare("an oblique sun", [](Scene& s, vtkImageData*) { s.AddDirectionalLight({ -2, 1.5, 1 }); });
  Compare("a sun behind", [](Scene& s, vtkImageData*) {
    s.AddDirectionalLight({ 0.3, -0.2, -1 });
  });
  Compare("a sun along an axis",
    [](Scene& s, vtkImageData* image) { s.AddDirectionalLight(GetAxis(image, 1)); });
  Compare("a sun along a face", [](Scene& s, vtkImageData* image) {
    s.AddDirectionalLight(GetAxis(image, 1) - GetAxis(image, 0));
  });
  Compare("a lamp", [](Scene& s, vtkImageData*) { s.AddPointLight({ 0.5, 0.3, 0.4 }); });
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
