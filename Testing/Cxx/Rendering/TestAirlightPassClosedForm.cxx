// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass's buffers, pixel by pixel, against vtkAirlight in double precision on the pixel's ray
// (which TestClosedForm compares with quadrature): random media, lights and cameras, with nothing
// in the scene and with a plane that ends some of the rays.

#include "AirlightTestPixelScene.h"
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

// Random cameras, lights, media and planes.
class Experiment : public PixelScene
{
public:
  Experiment() { this->AddTiltedPlane(); }

  void Run(int index, Comparisons& comparisons)
  {
    this->Render(index);
    if (!this->GetPixel("Airlight", 0, 0))
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
  // The index chooses the kinds of things, the random numbers where they are.
  void Render(int index)
  {
    this->Index = index;
    this->PlaceCamera();
    this->PlaceLight();
    this->ChooseMedium();
    this->PlacePlane();
    this->Window->Render();
  }
  void PlaceCamera();
  void PlaceLight();
  void ChooseMedium();
  void PlacePlane();
  std::string Describe(int i, int j, double t1);

  struct Expected
  {
    double Airlight[3];
    double Transmittance[3];
  };
  Expected Compute(vtkParticipatingMedium* medium, const PixelRay& ray, double t1);
  bool Grazes(const PixelRay& ray, double t1, const Expected& expected);
  void ComparePixel(int i, int j, Comparisons& comparisons);

  Random Numbers{ 5 };
  int Index = 0;
  glm::dvec3 LightPosition{ 0.0 };
  double Intensity[3] = { 10.0, 20.0, 5.0 };
};

//------------------------------------------------------------------------------
void Experiment::PlaceCamera()
{
  Random& random = this->Numbers;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 position = 3.0 * RandomUnit(random);
  const glm::dvec3 focalPoint = position + random.Uniform(2.0, 10.0) * RandomUnit(random);
  const glm::dvec3 up = RandomUnit(random);
  camera->SetPosition(&position.x);
  camera->SetFocalPoint(&focalPoint.x);
  camera->SetViewUp(&up.x);
  camera->SetViewAngle(random.Uniform(20.0, 90.0));
  camera->SetParallelScale(random.Uniform(0.5, 5.0));
  camera->SetParallelProjection(this->Index % 3 == 2);
  camera->SetClippingRange(0.1, 100.0);
}

//------------------------------------------------------------------------------
// In turn: anywhere, on a pixel's ray, very near the camera, far away, behind the camera, in front.
void Experiment::PlaceLight()
{
  Random& random = this->Numbers;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const PixelRay middle = this->GetRay(32, 24);
  const glm::dvec3 eye(
    camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]);
  switch (this->Index % 6)
  {
    case 0:
      this->LightPosition = random.Uniform(0.5, 8.0) * RandomUnit(random);
      break;
    case 1:
    {
      const PixelRay ray =
        this->GetRay(random.Index(PixelScene::Width), random.Index(PixelScene::Height));
      this->LightPosition = ray.Origin + random.Uniform(1.0, 6.0) * ray.Direction;
      break;
    }
    case 2:
      this->LightPosition = eye + random.LogUniform(1e-4, 1e-2) * RandomUnit(random);
      break;
    case 3:
      this->LightPosition = random.LogUniform(20.0, 1000.0) * RandomUnit(random);
      break;
    case 4:
      this->LightPosition =
        eye - random.Uniform(0.5, 4.0) * middle.Direction + 0.3 * RandomUnit(random);
      break;
    default:
      this->LightPosition =
        eye + random.Uniform(1.0, 6.0) * middle.Direction + 0.3 * RandomUnit(random);
  }
  this->Intensity[0] = random.LogUniform(1.0, 100.0);
  this->Light->SetPosition(&this->LightPosition.x);
  vtkAirlight::SetRadiantIntensity(this->Light, this->Intensity);
}

//------------------------------------------------------------------------------
void Experiment::ChooseMedium()
{
  Random& random = this->Numbers;
  vtkParticipatingMedium* medium = this->Medium;
  const double grey = random.LogUniform(1e-3, 2.0);
  if (this->Index % 2 == 0)
  {
    medium->SetScattering(grey, grey, grey);
    medium->SetAbsorption(0.5 * grey, 0.5 * grey, 0.5 * grey);
  }
  else
  {
    medium->SetScattering(grey, random.LogUniform(1e-3, 2.0), random.LogUniform(1e-3, 2.0));
    medium->SetAbsorption(0.0, random.LogUniform(1e-3, 1.0), 0.1);
  }
  medium->SetAmbientRadiance(0.0, this->Index % 5 == 0 ? 0.3 : 0.0, 0.0);

  const double anisotropies[] = { 0.0, 0.9, -0.9, 0.5, -0.3, 0.76, -0.7 };
  const double tolerances[] = { 1e-3, 1e-5, 1e-2 };
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(anisotropies[this->Index % 7]);
  medium->SetPhaseTolerance(tolerances[this->Index % 3]);

  // A box that holds the light. The camera is inside some and outside others.
  medium->SetRegionToUnbounded();
  if (this->Index % 4 == 1)
  {
    double bounds[6];
    for (int i = 0; i < 6; ++i)
    {
      bounds[i] = this->LightPosition[i / 2] + (i % 2 ? 1.0 : -1.0) * random.Uniform(0.2, 5.0);
    }
    medium->SetBounds(bounds);
    medium->SetRegionToBox();
  }
}

//------------------------------------------------------------------------------
// In every other configuration: tilted, and over a part of the view.
void Experiment::PlacePlane()
{
  Random& random = this->Numbers;
  this->Actor->SetVisibility(this->Index % 2 == 1);
  const PixelRay a = this->GetRay(10, 5);
  const PixelRay b = this->GetRay(45, 8);
  const PixelRay c = this->GetRay(14, 40);
  const glm::dvec3 p = a.Origin + random.Uniform(1.0, 8.0) * a.Direction;
  const glm::dvec3 q = b.Origin + random.Uniform(1.0, 8.0) * b.Direction;
  const glm::dvec3 r = c.Origin + random.Uniform(1.0, 8.0) * c.Direction;
  this->Plane->SetOrigin(p.x, p.y, p.z);
  this->Plane->SetPoint1(q.x, q.y, q.z);
  this->Plane->SetPoint2(r.x, r.y, r.z);
}

//------------------------------------------------------------------------------
std::string Experiment::Describe(int i, int j, double t1)
{
  const PixelRay ray = this->GetRay(i, j);
  vtkParticipatingMedium* m = this->Medium;
  return Text("configuration ", this->Index, ", pixel ", i, " ", j, ": light ",
    Text3(&this->LightPosition.x), ", origin ", Text3(&ray.Origin.x), ", direction ",
    Text3(&ray.Direction.x), ", end ", t1, ", sigmaS ", Text3(m->GetScattering()), ", sigmaA ",
    Text3(m->GetAbsorption()), ", g ", m->GetAnisotropy(), ", poles ", m->GetNumberOfPhasePoles(),
    ", region ", m->GetRegion(), " ", Text3(m->GetBounds()), " ", Text3(m->GetBounds() + 3));
}

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
  vtkParticipatingMedium* medium = this->Medium;
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
  const PixelRay ray = this->GetRay(i, j);
  const double t1 = this->GetEnd(i, j);
  const float* airlight = this->GetPixel("Airlight", i, j);
  const float* surface = this->GetPixel("Surface", i, j);
  const float* radiance = this->GetPixel("Radiance", i, j);
  const float* passes = this->GetPixel("Transmittance", i, j);
  const float litLength = *this->GetPixel("LitLength", i, j);
  const auto describe = [&] { return this->Describe(i, j, t1); };

  const Expected expected = this->Compute(this->Medium, ray, t1);
  const bool grazing = this->Grazes(ray, t1, expected);
  ++comparisons.Rays;
  comparisons.Grazing += grazing ? 1 : 0;

  // The documented radius of lights: rays that pass within 1e-5 of the distance from camera to
  // light are shaded as if they passed there.
  vtkCamera* camera = this->Renderer->GetActiveCamera();
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
  const double inside = InsideLength(this->Medium, ray.Origin, ray.Origin + t1 * ray.Direction);
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
  Experiment experiment;
  for (int i = 0; i < 60; ++i)
  {
    experiment.Run(i, comparisons);
  }
  return comparisons.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
