// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The mean of many frames beside the mean of vtkAirlightReference over other places in each pixel,
// at all pixels: the edges of surfaces and of shadows, too.

#include "AirlightTestMeans.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightReference.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
constexpr int Width = 48;
constexpr int Height = 36;
constexpr int Frames = 256;
constexpr int Places = 512;

//------------------------------------------------------------------------------
// Hammersley's points. A grid of as many is off by 1/45 of the contrast at edges along it.
glm::dvec2 GetPlace(int number)
{
  double inverse = 0.0;
  double digit = 0.5;
  for (int rest = number; rest > 0; rest /= 2)
  {
    inverse += rest % 2 == 1 ? digit : 0.0;
    digit /= 2.0;
  }
  const double half = 0.5 / Places;
  return { static_cast<double>(number) / Places + half - 0.5, inverse + half - 0.5 };
}

std::vector<double> AverageReference(WindowScene& scene)
{
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetMedium(scene.Medium);
  reference->SetSize(Width, Height);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  std::vector<double> sums(3 * Width * Height, 0.0);
  for (int number = 0; number < Places; ++number)
  {
    const glm::dvec2 place = GetPlace(number);
    camera->SetWindowCenter(2.0 * place.x / Width, 2.0 * place.y / Height);
    reference->Modified();
    reference->Update();
    vtkDataArray* radiance = reference->GetOutput()->GetPointData()->GetArray("Radiance");
    for (size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] +=
        radiance->GetComponent(static_cast<vtkIdType>(i / 3), static_cast<int>(i % 3)) / Places;
    }
  }
  camera->SetWindowCenter(0.0, 0.0);
  return sums;
}

//------------------------------------------------------------------------------
void CheckScene(const std::string& name, WindowScene& scene)
{
  const std::vector<double> expected = AverageReference(scene);
  scene.Pass->SetSubpixelFrames(1);
  const std::vector<double> one = GetRelativeErrors(scene.Render().at("Radiance"), expected);
  scene.Pass->SetSubpixelFrames(Frames);
  const std::vector<double> mean = GetRelativeErrors(scene.Render().at("Radiance"), expected);
  const size_t middle = mean.size() / 2;
  const size_t most = mean.size() * 99 / 100;
  std::cout << name << ": median " << mean[middle] << ", 99 % below " << mean[most] << ", largest "
            << mean.back() << "; of one frame " << one[middle] << " and " << one[most] << "\n";
  Check(mean[middle] < 1e-4, name + ": the median of all pixels");
  Check(mean[most] < 1e-2, name + ": 99 % of all pixels, edges too");
  Check(one[most] > 0.1, name + ": there are edges");
}
}

//------------------------------------------------------------------------------
int TestSubpixelReference(int, char*[])
{
  WindowScene box(Width, Height, 2);
  CheckScene("two lamps in a box", box);
  WindowScene sun(Width, Height, 0);
  sun.AddDirectionalLight({ 0.4, 1.0, 0.2 }, glm::dvec3(4.0));
  CheckScene("a sun in a box", sun);
  WindowScene parallel(Width, Height, 1);
  parallel.Renderer->GetActiveCamera()->ParallelProjectionOn();
  parallel.Medium->SetRegionToUnbounded();
  CheckScene("an unbounded medium, parallel projection", parallel);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
