// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass for media inside closed surfaces, convex and not, against vtkAirlight on the pixels'
// rays, which TestClosedSurface compares with quadrature: camera and light inside, outside and in
// cavities, in perspective and parallel projection, with a wall behind, in the middle or none.

#include "AirlightTestMatrix.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestSurfaces.h"

#include "vtkAirlight.h"

#include <algorithm>
#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Step = 31; // every which pixel is compared

struct Values
{
  glm::dvec3 Airlight;
  glm::dvec3 Transmittance;
};

struct Sample
{
  int I;
  int J;
  PixelRay Ray;
  double End;
  Values Expected;
};

// Places, of cameras and lights, for all the solids: each is inside of some. None lies near the
// plane of a face that it sees the samples across, where the way to the light jumps from in to out.
const glm::dvec3 Places[] = { { 1.4, 1.2, 7.0 }, { 0.2, 0.1, 0.3 }, { -1.3, -1.2, 1.2 },
  { 3.6, 2.9, -1.7 }, { 0.1, 1.3, 1.4 } };
enum Wall
{
  NONE,
  BEHIND,
  MIDDLE,
  WALLS
};

class Experiment
{
public:
  Experiment()
  {
    this->Scene.AddTiltedPlane();
    this->Scene.Medium->SetScattering(0.3, 0.2, 0.1);
    this->Scene.Medium->SetAbsorption(0.0, 0.2, 0.05);
  }

  void Run(const Solid& solid, const MatrixCell& cell, int i);
  bool Report() const;

private:
  void Place(const Solid& solid, const MatrixCell& cell, int i);
  Values Compute(const PixelRay& ray, double end);
  bool Grazes(const Sample& sample);

  PixelScene Scene;
  Comparison Airlight{ "Airlight" };
  Comparison Transmittance{ "Transmittance, absolute" };
  Comparison Finite{ "values, finite (0) or not (1)" };
  long Rays = 0;
  long Grazing = 0;
};

//------------------------------------------------------------------------------
void Experiment::Place(const Solid& solid, const MatrixCell& cell, int i)
{
  vtkParticipatingMedium* medium = this->Scene.Medium;
  medium->SetSurface(solid.Surface);
  cell.Apply(medium, this->Scene.Light);
  medium->SetScaleHeight(3.0);
  medium->SetUp(0.2, 1.0, -0.1);
  const glm::dvec3 eye = Places[i % 5];
  const glm::dvec3 lamp = Places[(i + 1 + i / 5 % 4) % 5];
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(&eye.x);
  camera->SetFocalPoint(0.15, 0.25, -0.35);
  camera->SetViewAngle(60.0);
  camera->SetParallelScale(2.2);
  camera->SetParallelProjection(i % 2);
  camera->SetClippingRange(0.1, 50.0);
  this->Scene.Light->SetPosition(&lamp.x);
  this->Scene.Light->SetFocalPoint(-0.3, 0.4, -0.6);
  this->Scene.Light->SetColor(4.0, 7.0, 2.0);
  const int wall = i / 2 % WALLS;
  this->Scene.Actor->SetVisibility(wall != NONE);
  const double z = wall == BEHIND ? -4.0 : -0.4;
  this->Scene.Plane->SetOrigin(-9.0, -9.0, z - 0.3);
  this->Scene.Plane->SetPoint1(1.2, -9.0, z);
  this->Scene.Plane->SetPoint2(-9.0, 9.0, z + 0.2);
}

Values Experiment::Compute(const PixelRay& ray, double end)
{
  Values values;
  const glm::dvec3 to = ray.Origin + end * ray.Direction;
  vtkAirlight::Inscatter(this->Scene.Medium, this->Scene.Light, &ray.Origin.x, &ray.Direction.x,
    0.0, end, &values.Airlight.x);
  vtkAirlight::Transmittance(this->Scene.Medium, &ray.Origin.x, &to.x, &values.Transmittance.x);
  return values;
}

//------------------------------------------------------------------------------
// Single precision places triangles to some 1e-7 of their distance. A ray grazes one where another
// ray beside it by 1e-6 of the distance (8 here) makes more of a difference than half the limits
// allow.
bool Experiment::Grazes(const Sample& sample)
{
  const glm::dvec3& d = sample.Ray.Direction;
  const glm::dvec3 right = glm::normalize(glm::cross(d, glm::dvec3(0.3, 1.0, 0.2)));
  const glm::dvec3 up = glm::cross(right, d);
  for (const glm::dvec3& beside : { right, -right, up, -up })
  {
    const Values other = this->Compute({ sample.Ray.Origin + 8e-6 * beside, d }, sample.End);
    const glm::dvec3 change = glm::abs(other.Airlight - sample.Expected.Airlight);
    const glm::dvec3 passes = glm::abs(other.Transmittance - sample.Expected.Transmittance);
    if (glm::any(glm::greaterThan(change, 0.5e-3 * sample.Expected.Airlight)) ||
      glm::any(glm::greaterThan(passes, glm::dvec3(0.5e-5))))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void Experiment::Run(const Solid& solid, const MatrixCell& cell, int i)
{
  this->Place(solid, cell, i);
  this->Scene.Window->Render();
  std::vector<Sample> samples;
  std::vector<double> sizes;
  for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; ++pixel)
  {
    const int x = pixel % PixelScene::Width;
    const int y = pixel / PixelScene::Width;
    const float* a = this->Scene.GetPixel("Airlight", x, y);
    const float* t = this->Scene.GetPixel("Transmittance", x, y);
    const bool finite = std::isfinite(a[0] + a[1] + a[2]) && std::isfinite(t[0] + t[1] + t[2]);
    this->Finite.Add(finite ? 0.0 : 1.0, 0.5,
      [&] { return Text(solid.Name, ", ", cell.Describe(), ", ", i, ", ", x, " ", y); });
    if (pixel % Step == i % Step)
    {
      const PixelRay ray = this->Scene.GetRay(x, y);
      const double end = this->Scene.GetEnd(x, y);
      samples.push_back({ x, y, ray, end, this->Compute(ray, end) });
      sizes.push_back(samples.back().Expected.Airlight.x);
    }
  }
  std::sort(sizes.begin(), sizes.end());
  const double floor = 1e-6 * sizes[sizes.size() * 99 / 100] + 1e-37;
  for (const Sample& sample : samples)
  {
    const float* a = this->Scene.GetPixel("Airlight", sample.I, sample.J);
    const float* t = this->Scene.GetPixel("Transmittance", sample.I, sample.J);
    const glm::dvec3 airlight(a[0], a[1], a[2]);
    const glm::dvec3 passes(t[0], t[1], t[2]);
    const glm::dvec3 error = glm::abs(airlight - sample.Expected.Airlight);
    const glm::dvec3 limit = glm::max(1e-3 * sample.Expected.Airlight, glm::dvec3(floor));
    const glm::dvec3 passError = glm::abs(passes - sample.Expected.Transmittance);
    const bool ok = glm::all(glm::lessThanEqual(error, limit)) &&
      glm::all(glm::lessThanEqual(passError, glm::dvec3(1e-5)));
    ++this->Rays;
    if (!ok && this->Grazes(sample))
    {
      ++this->Grazing;
      continue;
    }
    const auto describe = [&] {
      return Text(solid.Name, ", ", cell.Describe(), ", view ", i, ", pixel ", sample.I, " ",
        sample.J, ": expected ", Text3(&sample.Expected.Airlight.x), ", got ", Text3(&airlight.x),
        ", transmittance ", Text3(&sample.Expected.Transmittance.x), ", got ", Text3(&passes.x),
        ", origin ", Text3(&sample.Ray.Origin.x), ", direction ", Text3(&sample.Ray.Direction.x),
        ", end ", sample.End, ", light ", Text3(this->Scene.Light->GetPosition()));
    };
    for (int k = 0; k < 3; ++k)
    {
      this->Airlight.Add(error[k], limit[k], describe);
      this->Transmittance.Add(passError[k], 1e-5, describe);
    }
  }
}

bool Experiment::Report() const
{
  const bool few = this->Grazing < 0.01 * this->Rays;
  std::cout << (few ? "ok      " : "FAILED  ") << this->Grazing << " of " << this->Rays
            << " rays graze and are left out\n";
  return AllOk({ &this->Airlight, &this->Transmittance, &this->Finite }) && few;
}
}

//------------------------------------------------------------------------------
int TestClosedSurfacePass(int, char*[])
{
  Experiment experiment;
  for (const Solid& solid : MakeSolids())
  {
    for (int i = 0; i < 20; ++i)
    {
      const MatrixCell cell{ i * 2 % MATRIX_LIGHTS, vtkParticipatingMedium::SURFACE, i % 3 == 2,
        i / 3 % 2 == 0 ? MATRIX_ISOTROPIC : MATRIX_FORWARD };
      experiment.Run(solid, cell, i);
    }
  }
  const Solid torus{ "torus", {}, false, MakeTorus(0.6, 24) };
  for (int i = 0; i < 8; ++i)
  {
    experiment.Run(
      torus, { i % MATRIX_LIGHTS, vtkParticipatingMedium::SURFACE, 0, MATRIX_ISOTROPIC }, i);
  }
  return experiment.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
