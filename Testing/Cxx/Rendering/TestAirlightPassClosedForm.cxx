// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass's buffers, pixel by pixel, against vtkAirlight in double precision on the pixel's ray
// (which TestClosedForm compares with quadrature): random media, lights and cameras, with nothing
// in the scene and with a plane that ends some of the rays.

#include "AirlightTestRandomScene.h"
#include "AirlightTestSpace.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// The limits, and the worst cases of all configurations.
struct Comparisons
{
  Comparison Airlight{ "Airlight, of the ray's airlight" };
  Comparison Transmittance{ "Transmittance, absolute" };
  Comparison LitLength{ "LitLength, of the distances" };
  Comparison Radiance{ "Radiance = Airlight + Surface, relative" };
  Comparison Finite{ "rays at the light, finite (0) or not (1)" };
  // Rays that graze a box are left out; they must stay few.
  long Rays = 0;
  long Grazing = 0;

  bool Report() const
  {
    const bool few = this->Rays > 0 && this->Grazing <= 0.02 * this->Rays;
    std::cout << (few ? "ok      " : "FAILED  ") << this->Grazing << " of " << this->Rays
              << " rays graze a box and are left out\n";
    return AllOk({ &this->Airlight, &this->Transmittance, &this->LitLength, &this->Radiance,
             &this->Finite }) &&
      few;
  }
};

class Experiment : public RandomPixelScene
{
public:
  using RandomPixelScene::RandomPixelScene;

  void Run(int index, Comparisons& comparisons)
  {
    this->Render(index);
    if (!this->Scene.GetPixel("Airlight", 0, 0))
    {
      std::cerr << "There are no buffers in configuration " << index << "\n";
      std::exit(EXIT_FAILURE);
    }
    for (int j = 0; j < PixelScene::Height; ++j)
    {
      for (int i = 0; i < PixelScene::Width; ++i)
      {
        this->ComparePixel(i, j, comparisons);
      }
    }
  }

private:
  struct Expected
  {
    double Airlight[3];
    double Transmittance[3];
  };
  Expected Compute(vtkParticipatingMedium* medium, const PixelRay& ray, double t1);
  bool Grazes(const PixelRay& ray, double t1, const Expected& expected);
  void ComparePixel(int i, int j, Comparisons& comparisons);
};

//------------------------------------------------------------------------------
Experiment::Expected Experiment::Compute(
  vtkParticipatingMedium* medium, const PixelRay& ray, double t1)
{
  Expected expected;
  double ambient[3];
  const glm::dvec3 end = ray.Origin + t1 * ray.Direction;
  vtkAirlight::Inscatter(medium, &this->LightPosition.x, this->Intensity, &ray.Origin.x,
    &ray.Direction.x, 0.0, t1, expected.Airlight);
  vtkAirlight::Ambient(medium, &ray.Origin.x, &ray.Direction.x, t1, ambient);
  vtkAirlight::Transmittance(medium, &ray.Origin.x, &end.x, expected.Transmittance);
  for (int k = 0; k < 3; ++k)
  {
    expected.Airlight[k] += ambient[k];
  }
  return expected;
}

//------------------------------------------------------------------------------
// Single precision places the faces of a box, and the ray, to some 1e-7 of their distance. A ray
// that grazes the box is left out: one for which a box larger by 5e-7 of the distance makes more
// of a difference than half the limits allow.
bool Experiment::Grazes(const PixelRay& ray, double t1, const Expected& expected)
{
  vtkParticipatingMedium* medium = this->Scene.Medium;
  if (medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED)
  {
    return false;
  }
  double bounds[6];
  medium->GetBounds(bounds);
  double larger[6];
  for (int i = 0; i < 6; ++i)
  {
    const double distance = std::abs(bounds[i] - ray.Origin[i / 2]) + 1.0;
    larger[i] = bounds[i] + (i % 2 ? 5e-7 : -5e-7) * distance;
  }
  medium->SetBounds(larger);
  const Expected other = this->Compute(medium, ray, t1);
  medium->SetBounds(bounds);
  bool grazes = false;
  for (int k = 0; k < 3; ++k)
  {
    grazes = grazes ||
      std::abs(other.Airlight[k] - expected.Airlight[k]) > 0.5e-4 * expected.Airlight[k] ||
      std::abs(other.Transmittance[k] - expected.Transmittance[k]) > 1e-6;
  }
  return grazes;
}

//------------------------------------------------------------------------------
void Experiment::ComparePixel(int i, int j, Comparisons& comparisons)
{
  const PixelRay ray = this->Scene.GetRay(i, j);
  const double t1 = this->Scene.GetEnd(i, j);
  const float* airlight = this->Scene.GetPixel("Airlight", i, j);
  const float* surface = this->Scene.GetPixel("Surface", i, j);
  const float* radiance = this->Scene.GetPixel("Radiance", i, j);
  const float* passes = this->Scene.GetPixel("Transmittance", i, j);
  const float litLength = *this->Scene.GetPixel("LitLength", i, j);
  const auto describe = [&] { return this->Describe(i, j, t1); };

  const Expected expected = this->Compute(this->Scene.Medium, ray, t1);
  const bool grazing = this->Grazes(ray, t1, expected);
  ++comparisons.Rays;
  comparisons.Grazing += grazing ? 1 : 0;

  // The documented radius of lights: rays that pass within 1e-5 of the distance from camera to
  // light are shaded as if they passed there.
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  const glm::dvec3 eye(
    camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]);
  const double h = glm::length(glm::cross(this->LightPosition - ray.Origin, ray.Direction));
  const bool atLight = h < 1e-5 * glm::length(this->LightPosition - eye);
  for (int k = 0; k < 3; ++k)
  {
    const double sum = airlight[k] + surface[k];
    comparisons.Radiance.Add(std::abs(radiance[k] - sum), 1e-6 * sum + 1e-37, describe);
    if (!grazing)
    {
      comparisons.Transmittance.Add(
        std::abs(passes[k] - expected.Transmittance[k]), 2e-6, describe);
    }
    if (atLight)
    {
      comparisons.Finite.Add(std::isfinite(airlight[k]) ? 0.0 : 1.0, 0.5, describe);
    }
    else if (!grazing)
    {
      const double value = expected.Airlight[k];
      comparisons.Airlight.Add(std::abs(airlight[k] - value), 1e-4 * value + 1e-37,
        [&] { return Text(describe(), ", h ", h, "; expected ", value, ", got ", airlight[k]); });
    }
  }
  // Every part of the ray inside the medium is lit. Both ends of it are positions, which single
  // precision rounds in proportion to their distance; a box is about the light.
  const double inside =
    InsideLength(this->Scene.Medium, ray.Origin, ray.Origin + t1 * ray.Direction);
  if (!grazing)
  {
    comparisons.LitLength.Add(std::abs(litLength - inside),
      2e-6 * (inside + glm::length(this->LightPosition - ray.Origin)), describe);
  }
}
}

//------------------------------------------------------------------------------
int TestAirlightPassClosedForm(int, char*[])
{
  Comparisons comparisons;
  Experiment experiment(5);
  for (int i = 0; i < 60; ++i)
  {
    experiment.Run(i, comparisons);
  }
  return comparisons.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
