// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause

#include "AirlightTestPassMatrix.h"

#include "vtkAirlight.h"

#include <algorithm>

namespace airlight_test
{
namespace
{
// Every Step-th pixel of the picture is compared, another set in each combination: vtkAirlight's
// quadrature takes its time.
constexpr int Step = 11;
}

//------------------------------------------------------------------------------
// The camera is inside or outside the region by chance.
void PassMatrix::Place(const MatrixCell& cell, bool parallel, bool plane, bool lightInside)
{
  Random& random = this->Numbers;
  vtkParticipatingMedium* medium = this->Scene.Medium;
  cell.Apply(medium, this->Scene.Light);
  medium->SetScattering(random.Uniform(0.05, 0.4), 0.2, random.Uniform(0.05, 0.4));
  medium->SetAbsorption(0.0, random.Uniform(0.0, 0.2), 0.05);
  SetBox(medium, { -2.0, 2.5, -1.5, 2.0, -2.5, 1.8 });
  medium->SetCenter(0.3, 0.2, -0.1);
  medium->SetRadius(2.2);
  medium->SetHeight(3.4);
  medium->SetAxis(0.3, 1.0, -0.2);
  medium->SetScaleHeight(random.Uniform(1.0, 4.0));
  medium->SetReferenceHeight(random.Uniform(-1.0, 1.0));
  medium->SetUp(random.Uniform(-0.3, 0.3), 1.0, random.Uniform(-0.3, 0.3));

  const bool cameraInside = random.Index(2) == 0;
  const glm::dvec3 eye = (cameraInside ? 1.0 : random.Uniform(4.0, 6.0)) *
    glm::normalize(glm::dvec3(random.Uniform(-0.7, 0.7), random.Uniform(-0.4, 0.4), 1.0));
  const glm::dvec3 lamp =
    (lightInside ? random.Uniform(0.2, 1.3) : random.Uniform(4.0, 6.0)) * RandomUnit(random);
  const glm::dvec3 aim = random.Uniform(0.0, 1.0) * RandomUnit(random);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(&eye.x);
  camera->SetFocalPoint(0.1, 0.2, -0.3);
  camera->SetViewAngle(55.0);
  camera->SetParallelScale(2.0);
  camera->SetParallelProjection(parallel);
  camera->SetClippingRange(0.1, 50.0);
  this->Scene.Light->SetPosition(&lamp.x);
  this->Scene.Light->SetFocalPoint(&aim.x);
  if (cell.Light == MATRIX_SUN)
  {
    // At least 10 degrees above any horizon that SetUp() above makes.
    const glm::dvec3 sun(aim.x + random.Uniform(-1, 1), aim.y + 1.0, aim.z + random.Uniform(-1, 1));
    this->Scene.Light->SetPosition(&sun.x);
  }
  this->Scene.Light->SetColor(4.0, 7.0, 2.0);
  this->Scene.Actor->SetVisibility(plane);
  this->Closed = cell.HasClosedForm(lightInside, medium, true);
}

//------------------------------------------------------------------------------
PassMatrix::Expected PassMatrix::Compute(const Sample& sample)
{
  Expected expected;
  const PixelRay& ray = sample.Ray;
  const glm::dvec3 end = ray.Origin + sample.End * ray.Direction;
  vtkAirlight::Inscatter(this->Scene.Medium, this->Scene.Light, &ray.Origin.x, &ray.Direction.x,
    0.0, sample.End, expected.Airlight.data());
  vtkAirlight::Transmittance(
    this->Scene.Medium, &ray.Origin.x, &end.x, expected.Transmittance.data());
  return expected;
}

//------------------------------------------------------------------------------
// Single precision places faces, spheres and cones to some 1e-7 of their distance. A ray grazes one
// for which a region larger by 1e-6 of the distance (6 here), or a cone wider by 1e-6, makes more
// of a difference than half the limits allow.
bool PassMatrix::Grazes(const Sample& sample)
{
  constexpr double change = 6e-6;
  vtkParticipatingMedium* medium = this->Scene.Medium;
  Box bounds;
  Box larger;
  medium->GetBounds(bounds.data());
  for (int i = 0; i < 6; ++i)
  {
    larger[i] = bounds[i] + (i % 2 ? change : -change);
  }
  const double radius = medium->GetRadius();
  const double height = medium->GetHeight();
  const double cone = this->Scene.Light->GetConeAngle();
  SetBox(medium, larger);
  medium->SetRadius(radius + change);
  medium->SetHeight(height + 2.0 * change);
  this->Scene.Light->SetConeAngle(cone < 90.0 ? cone + 1e-6 * 180.0 / 3.14159265 : cone);
  const Expected other = this->Compute(sample);
  SetBox(medium, bounds);
  medium->SetRadius(radius);
  medium->SetHeight(height);
  this->Scene.Light->SetConeAngle(cone);
  bool grazes = false;
  for (int k = 0; k < 3; ++k)
  {
    const double value = sample.Values.Airlight[k];
    grazes = grazes ||
      std::abs(other.Airlight[k] - value) > (this->Closed ? 0.5e-4 : 0.5e-3) * value ||
      std::abs(other.Transmittance[k] - sample.Values.Transmittance[k]) > 0.5e-5;
  }
  return grazes;
}

//------------------------------------------------------------------------------
std::vector<PassMatrix::Sample> PassMatrix::TakeSamples()
{
  std::vector<Sample> samples;
  const int count = PixelScene::Width * PixelScene::Height;
  const int step =
    this->Scene.Medium->GetRegion() == vtkParticipatingMedium::SURFACE ? 5 * Step : Step;
  for (int pixel = this->Index % step; pixel < count; pixel += step)
  {
    Sample sample;
    sample.I = pixel % PixelScene::Width;
    sample.J = pixel / PixelScene::Width;
    sample.Ray = this->Scene.GetRay(sample.I, sample.J);
    sample.End = this->Scene.GetEnd(sample.I, sample.J);
    sample.Values = this->Compute(sample);
    samples.push_back(sample);
  }
  return samples;
}

//------------------------------------------------------------------------------
// The rays that graze are looked for among those that miss a limit.
void PassMatrix::Compare(
  const MatrixCell& cell, const Sample& sample, double floor, PassMatrixComparisons& comparisons)
{
  const float* airlight = this->Scene.GetPixel("Airlight", sample.I, sample.J);
  const float* passes = this->Scene.GetPixel("Transmittance", sample.I, sample.J);
  ++comparisons.Rays;
  bool misses = false;
  double limits[3];
  for (int k = 0; k < 3; ++k)
  {
    const double value = sample.Values.Airlight[k];
    limits[k] = std::max((this->Closed ? 1e-4 : 1e-3) * value, floor);
    misses = misses || !(std::abs(airlight[k] - value) <= limits[k]) ||
      !(std::abs(passes[k] - sample.Values.Transmittance[k]) <= 1e-5);
  }
  if (misses && this->Grazes(sample))
  {
    ++comparisons.Grazing;
    return;
  }
  for (int k = 0; k < 3; ++k)
  {
    const double value = sample.Values.Airlight[k];
    const auto describe = [&] {
      return Text(cell.Describe(), ", combination ", this->Index, ", pixel ", sample.I, " ",
        sample.J, ", channel ", k, ": expected ", value, ", got ", airlight[k], ", transmittance ",
        sample.Values.Transmittance[k], ", got ", passes[k], "; light ",
        Text3(this->Scene.Light->GetPosition()), " to ", Text3(this->Scene.Light->GetFocalPoint()),
        ", origin ", Text3(&sample.Ray.Origin.x), ", direction ", Text3(&sample.Ray.Direction.x),
        ", end ", sample.End, ", sigmaT ", Text3(this->Scene.Medium->GetExtinction()), ", scale ",
        this->Scene.Medium->GetScaleHeight(), ", reference ",
        this->Scene.Medium->GetReferenceHeight(), ", up ", Text3(this->Scene.Medium->GetUp()));
    };
    (this->Closed ? comparisons.Closed : comparisons.Quadrature)
      .Add(std::abs(airlight[k] - value), limits[k], describe);
    comparisons.Transmittance.Add(
      std::abs(passes[k] - sample.Values.Transmittance[k]), 1e-5, describe);
  }
}

//------------------------------------------------------------------------------
void PassMatrix::Run(const MatrixCell& cell, bool parallel, bool plane, bool lightInside,
  PassMatrixComparisons& comparisons)
{
  ++this->Index;
  ++comparisons.Combinations;
  this->Place(cell, parallel, plane, lightInside);
  this->Scene.Window->Render();
  const std::vector<Sample> samples = this->TakeSamples();
  std::vector<double> values;
  for (const Sample& sample : samples)
  {
    values.insert(values.end(), sample.Values.Airlight.begin(), sample.Values.Airlight.end());
  }
  const size_t rank = values.size() * 99 / 100;
  std::nth_element(values.begin(), values.begin() + static_cast<long>(rank), values.end());
  for (const Sample& sample : samples)
  {
    this->Compare(cell, sample, 1e-6 * values[rank] + 1e-37, comparisons);
  }
  for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; ++pixel)
  {
    const int i = pixel % PixelScene::Width;
    const int j = pixel / PixelScene::Width;
    const float* a = this->Scene.GetPixel("Airlight", i, j);
    const float* t = this->Scene.GetPixel("Transmittance", i, j);
    const bool finite = std::isfinite(a[0] + a[1] + a[2]) && std::isfinite(t[0] + t[1] + t[2]);
    comparisons.Finite.Add(finite ? 0.0 : 1.0, 0.5,
      [&] { return Text(cell.Describe(), ", combination ", this->Index, ", ", i, " ", j); });
  }
}
}
