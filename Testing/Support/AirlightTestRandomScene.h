// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random cameras, lights, media and a plane for the comparison of the pass's buffers with numbers.
 */

#ifndef AirlightTestRandomScene_h
#define AirlightTestRandomScene_h

#include "AirlightTestDirections.h"
#include "AirlightTestPlaneScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"

namespace airlight_test
{
class RandomPixelScene
{
public:
  explicit RandomPixelScene(std::uint64_t seed)
    : Numbers(seed)
  {
  }

  // The index chooses the kinds of things, the random numbers where they are.
  void Render(int index)
  {
    this->Index = index;
    this->PlaceCamera();
    this->PlaceLight();
    this->ChooseMedium();
    this->PlacePlane();
    this->Scene.Window->Render();
  }

protected:
  std::string Describe(int i, int j, double t1);

  glm::dvec3 LightPosition{ 0.0 };
  double Intensity[3] = { 10.0, 20.0, 5.0 };
  PlaneScene Scene;

private:
  void PlaceCamera();
  void PlaceLight();
  void ChooseMedium();
  void PlacePlane();

  Random Numbers;
  int Index = 0;
};

//------------------------------------------------------------------------------
inline void RandomPixelScene::PlaceCamera()
{
  Random& random = this->Numbers;
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
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
inline void RandomPixelScene::PlaceLight()
{
  Random& random = this->Numbers;
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  const PixelRay middle = this->Scene.GetRay(32, 24);
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
        this->Scene.GetRay(random.Index(PixelScene::Width), random.Index(PixelScene::Height));
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
  this->Scene.Light->SetPosition(&this->LightPosition.x);
  vtkAirlight::SetRadiantIntensity(this->Scene.Light, this->Intensity);
}

//------------------------------------------------------------------------------
inline void RandomPixelScene::ChooseMedium()
{
  Random& random = this->Numbers;
  vtkParticipatingMedium* medium = this->Scene.Medium;
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
inline void RandomPixelScene::PlacePlane()
{
  Random& random = this->Numbers;
  this->Scene.Actor->SetVisibility(this->Index % 2 == 1);
  const PixelRay a = this->Scene.GetRay(10, 5);
  const PixelRay b = this->Scene.GetRay(45, 8);
  const PixelRay c = this->Scene.GetRay(14, 40);
  const glm::dvec3 p = a.Origin + random.Uniform(1.0, 8.0) * a.Direction;
  const glm::dvec3 q = b.Origin + random.Uniform(1.0, 8.0) * b.Direction;
  const glm::dvec3 r = c.Origin + random.Uniform(1.0, 8.0) * c.Direction;
  this->Scene.Plane->SetOrigin(p.x, p.y, p.z);
  this->Scene.Plane->SetPoint1(q.x, q.y, q.z);
  this->Scene.Plane->SetPoint2(r.x, r.y, r.z);
}

//------------------------------------------------------------------------------
inline std::string RandomPixelScene::Describe(int i, int j, double t1)
{
  const PixelRay ray = this->Scene.GetRay(i, j);
  vtkParticipatingMedium* m = this->Scene.Medium;
  return Text("configuration ", this->Index, ", pixel ", i, " ", j, ": light ",
    Text3(&this->LightPosition.x), ", origin ", Text3(&ray.Origin.x), ", direction ",
    Text3(&ray.Direction.x), ", end ", t1, ", sigmaS ", Text3(m->GetScattering()), ", sigmaA ",
    Text3(m->GetAbsorption()), ", g ", m->GetAnisotropy(), ", poles ", m->GetNumberOfPhasePoles(),
    ", region ", m->GetRegion(), " ", Text3(m->GetBounds()), " ", Text3(m->GetBounds() + 3));
}
}

#endif
