// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What an image of density leaves of lights on surfaces. The pass walks the ways of up to eight
// lights in a step of the full screen, those of others in the mappers' shaders: what nine lamps
// send is the sum of what each of them sends alone, whichever way it is walked; and behind an image
// of ones surfaces are as in the uniform box.

#include "AirlightTestDensity.h"
#include "AirlightTestTools.h"

#include "vtkCamera.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace airlight_test;

namespace
{
constexpr int Lamps = 9;

using Change = std::function<void(Scene&)>;

vtkSmartPointer<vtkImageData> MakeCloud()
{
  const auto image = MakeDensity(glm::ivec3(24), glm::dvec3(-3), glm::dvec3(3));
  FillCloud(image, 4711);
  return image;
}

void AddLamps(Scene& scene)
{
  for (int i = 0; i < Lamps; ++i)
  {
    const double angle = 0.7 * i;
    const glm::dvec3 at(3.5 * std::cos(angle), 2.5 + 0.1 * i, 3.5 * std::sin(angle));
    if (i % 4 == 3)
    {
      scene.AddDirectionalLight(at, glm::dvec3(0.1));
    }
    else
    {
      scene.AddPointLight(at, glm::dvec3(1.0, 0.8, 0.6));
    }
  }
}

void Prepare(DensityScene& scene, const Change& change)
{
  scene.Medium->SetScattering(0.5, 0.7, 0.9);
  scene.AddBodies();
  AddLamps(scene);
  change(scene);
}

std::vector<double> GetSurface(Scene& scene)
{
  scene.Window->Render();
  vtkDataArray* values = scene.GetBuffer("Surface")->GetPointData()->GetScalars();
  std::vector<double> result;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      result.push_back(values->GetComponent(i, c));
    }
  }
  return result;
}

double FindLargest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

// The largest difference, as a share of the brightest of b.
double Compare(const std::vector<double>& a, const std::vector<double>& b)
{
  double difference = 0.0;
  for (size_t i = 0; i < a.size(); ++i)
  {
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference / FindLargest(b);
}

//------------------------------------------------------------------------------
void TestSum(const std::string& name, const Change& change)
{
  DensityScene scene(MakeCloud());
  Prepare(scene, change);
  const std::vector<double> together = GetSurface(scene);
  std::vector<double> sum(together.size());
  for (vtkLight* light : scene.Lights)
  {
    for (vtkLight* other : scene.Lights)
    {
      other->SetSwitch(other == light);
    }
    const std::vector<double> alone = GetSurface(scene);
    std::transform(sum.begin(), sum.end(), alone.begin(), sum.begin(), std::plus<>());
  }
  const double difference = Compare(together, sum);
  std::cout << name << ": the sum differs by " << difference << " of the brightest, "
            << FindLargest(sum) << "\n";
  Check(difference < 2e-6, name + ": nine lamps are the sum of each of them");
  Check(FindLargest(sum) > 0.05, name + ": surfaces are lit");
}

void TestSums()
{
  TestSum("planes", [](Scene&) {});
  TestSum("no shadows", [](Scene& s) { s.Pass->SetShadowTechniqueToNone(); });
  TestSum("parallel projection", [](Scene& s) {
    s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    s.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  });
  TestSum("a part of the window", [](Scene& s) { s.Renderer->SetViewport(0.3, 0.2, 0.9, 0.8); });
  TestSum("headlights", [](Scene& s) {
    // Dimmed, but not scattered, before the others.
    for (vtkLight* light : { s.Lights[0], s.Lights[2] })
    {
      light->SetLightTypeToHeadlight();
    }
  });
  TestSum(
    "a lamp for surfaces alone", [](Scene& s) { s.Pass->SetLightScatters(s.Lights[1], false); });
  TestSum("a pane of glass", [](Scene& s) {
    s.Add(MakeSphere(0.8), [](vtkActor* ball) {
      ball->SetPosition(0.0, 0.5, 2.0);
      ball->GetProperty()->SetOpacity(0.4);
    });
  });
}

//------------------------------------------------------------------------------
// Of all surfaces, lit by a lamp in the medium, one outside and a sun.
void TestUniform()
{
  const glm::dvec3 low(-3);
  const glm::dvec3 high(3);
  const auto ones = MakeDensity(glm::ivec3(5), low, high);
  ones->GetPointData()->GetScalars()->Fill(1.0);
  DensityScene image(ones);
  Prepare(image, [](Scene&) {});
  DensityScene box(ones);
  Prepare(box, [](Scene&) {});
  box.Medium->SetDensityToUniform();
  box.Medium->SetRegionToBox();
  box.Medium->SetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
  const double difference = Compare(GetSurface(image), GetSurface(box));
  std::cout << "an image of ones: surfaces differ by " << difference << " of the brightest\n";
  Check(difference < 1e-5, "an image of ones dims surfaces as the uniform box does");
}
}

//------------------------------------------------------------------------------
int TestLightWaysPass(int, char*[])
{
  TestSums();
  TestUniform();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
