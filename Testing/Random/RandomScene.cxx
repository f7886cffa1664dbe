// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScene.h"

#include "RandomParts.h"

#include <algorithm>

namespace airlight_test
{
//------------------------------------------------------------------------------
RandomScene::RandomScene(std::uint64_t seed, airlight_test::Scene& scene)
  : Group(seed / GroupSize)
  , Seed(seed)
  , Numbers(Mix(12, seed))
  , Scene(scene)
{
  scene.Renderer->RemoveAllViewProps();
  scene.Renderer->RemoveAllLights();
  scene.Pass->RemoveAllMedia();
  Random& random = this->Numbers;
  // The whole scene is as large as a grain of sand or a country.
  this->Unit = random.Index(2) ? 1.0 : random.LogUniform(1e-4, 1e5);
  this->Text = airlight_test::Text("unit ", this->Unit);
  this->PlaceCamera();
  this->PlaceLights();
  this->AddMedia();
  this->AddParts();
  const bool background = random.Index(4) == 0;
  scene.Renderer->SetBackground(0.0, background ? 0.2 : 0.0, background ? 0.4 : 0.0);
  scene.Pass->SetSurfaceShadows(random.Index(8) != 0);
  // The airlight of a lamp at the eye is without bounds but for the lamp's size.
  const bool atEye = std::count(this->Group.Lights.begin(), this->Group.Lights.end(),
                       static_cast<int>(LIGHT_HEADLAMP)) > 0;
  const double radius = random.LogUniform(1e-3, 1e-1) * this->Unit;
  scene.Pass->SetLightRadius(atEye || random.Index(4) == 0 ? radius : 0.0);
  this->Text += airlight_test::Text(" radius ", scene.Pass->GetLightRadius());
}

//------------------------------------------------------------------------------
std::string RandomScene::Describe() const
{
  return airlight_test::Text("scene ", this->Seed, ", ", this->Group.Describe(), "; ", this->Text);
}

//------------------------------------------------------------------------------
// In turn: before the scene, in it, or on whole numbers and along an axis, where much is
// degenerate. Usual, narrow and wide.
void RandomScene::PlaceCamera()
{
  Random& random = this->Numbers;
  const int place = random.Index(4);
  const glm::dvec3 side = RandomUnit(random);
  this->Eye = random.Uniform(2.5, 8.0) * side;
  this->Focus = RandomPoint(random, 0.7);
  if (place == 1)
  {
    this->Eye = RandomPoint(random, 1.5);
    this->Focus = this->Eye + RandomUnit(random);
  }
  else if (place == 2)
  {
    this->Focus = glm::dvec3(0.0);
    this->Eye = glm::dvec3(0.0);
    this->Eye[random.Index(3)] = random.Index(2) ? 3.0 : -4.0;
  }
  double angle = random.Uniform(25.0, 60.0);
  const int lens = random.Index(5);
  if (lens == 0)
  {
    angle = random.Uniform(90.0, 150.0);
  }
  else if (lens == 1)
  {
    angle = random.LogUniform(0.5, 10.0);
    this->Eye = this->Focus + 30.0 / angle * (this->Eye - this->Focus);
  }
  const glm::dvec3 eye = this->Unit * this->Eye;
  const glm::dvec3 focus = this->Unit * this->Focus;
  const glm::dvec3 along = glm::normalize(focus - eye);
  glm::dvec3 up(0.0, 1.0, 0.0);
  while (glm::length(glm::cross(up, along)) < 0.05 || (place != 2 && up == glm::dvec3(0, 1, 0)))
  {
    up = RandomUnit(random);
  }
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetPosition(&eye.x);
  camera->SetFocalPoint(&focus.x);
  camera->SetViewUp(&up.x);
  camera->SetViewAngle(angle);
  camera->SetParallelScale(this->Unit * random.LogUniform(0.3, 5.0));
  camera->SetParallelProjection(this->Group.Parallel);
  const double distance = std::max(glm::length(focus - eye), this->Unit);
  const double near = distance * random.LogUniform(1e-3, 3e-2);
  camera->SetClippingRange(near, distance * random.Uniform(5.0, 50.0));
  this->Text += airlight_test::Text(", camera ", Text3(&this->Eye.x), " to ", Text3(&this->Focus.x),
    " up ", Text3(&up.x), " angle ", angle, " scale ", camera->GetParallelScale(), " range ",
    camera->GetClippingRange()[0], " ", camera->GetClippingRange()[1]);
}

//------------------------------------------------------------------------------
// Anywhere, on whole numbers, far away, or near the eye.
glm::dvec3 RandomScene::ChooseLightPosition()
{
  Random& random = this->Numbers;
  switch (random.Index(8))
  {
    case 0:
      return { 1.0, 2.0, random.Index(3) - 1.0 };
    case 1:
    {
      const glm::dvec3 side = RandomUnit(random);
      return random.LogUniform(5.0, 300.0) * side;
    }
    case 2:
    {
      const glm::dvec3 side = RandomUnit(random);
      return this->Eye + random.LogUniform(1e-3, 0.3) * side;
    }
    case 3:
      return this->Eye + random.Uniform(0.2, 1.5) * (this->Focus - this->Eye);
    default:
      return RandomPoint(random, 2.5);
  }
}

//------------------------------------------------------------------------------
void RandomScene::PlaceLight(vtkLight* light, int kind)
{
  Random& random = this->Numbers;
  const double blue = random.LogUniform(1.0, 100.0);
  const glm::dvec3 colour(random.LogUniform(1.0, 100.0), 20.0, blue);
  const glm::dvec3 intensity = this->Unit * this->Unit * colour;
  glm::dvec3 position = this->ChooseLightPosition();
  glm::dvec3 aim = RandomPoint(random, 1.0);
  const bool sun = kind == LIGHT_SUN || kind == LIGHT_HEADLIGHT || kind == LIGHT_CAMERA_SUN;
  if (sun)
  {
    vtkAirlight::SetIrradiance(light, &colour.x);
  }
  else
  {
    vtkAirlight::SetRadiantIntensity(light, &intensity.x);
  }
  if (kind == LIGHT_HEADLIGHT || kind == LIGHT_HEADLAMP)
  {
    light->SetLightTypeToHeadlight();
  }
  else if (kind == LIGHT_CAMERA || kind == LIGHT_CAMERA_SUN)
  {
    // Of a space whose unit is the way from the eye to the focal point.
    light->SetLightTypeToCameraLight();
    position = RandomPoint(random, 1.0) + glm::dvec3(0.0, 0.0, 1.0);
    aim = RandomPoint(random, 0.3);
  }
  const double scale = light->LightTypeIsCameraLight() ? 1.0 : this->Unit;
  light->SetPosition(scale * position.x, scale * position.y, scale * position.z);
  light->SetFocalPoint(scale * aim.x, scale * aim.y, scale * aim.z);
  light->SetExponent(0.0);
  if (kind == LIGHT_SPOT || kind == LIGHT_SOFT_SPOT)
  {
    light->SetConeAngle(random.Uniform(3.0, 85.0));
  }
  if (kind == LIGHT_SOFT_SPOT)
  {
    light->SetExponent(random.Uniform(0.5, 8.0));
  }
  if (kind == LIGHT_ATTENUATED)
  {
    // Of the colour as it is for the inverse square, in units of the scene.
    const double u = 1.0 / this->Unit;
    const double square = random.Index(3) ? random.Uniform(0.1, 2.0) * u * u : 0.0;
    const double linear = random.Uniform(0.05, 1.0) * u;
    const double constant =
      random.Index(3) ? random.Uniform(0.1, 1.0) * u * u * this->Unit * this->Unit : 0.0;
    light->SetAttenuationValues(constant, linear, square);
    vtkNew<vtkLight> plain;
    vtkAirlight::SetRadiantIntensity(plain, &colour.x);
    light->SetColor(plain->GetDiffuseColor());
    light->SetIntensity(plain->GetIntensity());
  }
  this->Text += airlight_test::Text("; ", GetLightName(kind), " ", Text3(&position.x), " to ",
    Text3(&aim.x), " cone ", light->GetConeAngle(), " exponent ", light->GetExponent(),
    " attenuation ", Text3(light->GetAttenuationValues()));
}

//------------------------------------------------------------------------------
void RandomScene::PlaceLights()
{
  for (int kind : this->Group.Lights)
  {
    vtkNew<vtkLight> light;
    this->PlaceLight(light, kind);
    this->Scene.Renderer->AddLight(light);
    this->Scene.Pass->SetLightScatters(light, true); // those that are fixed to the camera, too
  }
}

//------------------------------------------------------------------------------
void RandomScene::AddParts()
{
  Random& random = this->Numbers;
  const int count = 1 + random.Index(6);
  this->Text += ";";
  for (int i = 0; i < count; ++i)
  {
    this->AddPart(random.Index(PART_KINDS));
  }
}

//------------------------------------------------------------------------------
// Placed by its points or by its actor's matrix, which may mirror and stretch it.
void RandomScene::AddPart(int kind)
{
  Random& random = this->Numbers;
  TriangleList triangles = MakePart(kind, random);
  glm::dvec3 centre(0.0);
  double size = 1.0;
  if (kind != PART_FLOOR && random.Index(5) != 0)
  {
    centre = RandomPoint(random, 1.5);
    size = random.LogUniform(0.1, 1.5);
    size = random.Index(8) == 0 ? random.LogUniform(1e-4, 1e5) : size;
  }
  const bool turned = random.Index(3) != 0 && kind != PART_FLOOR;
  const bool single = random.Index(3) == 0;
  const bool shared = random.Index(2) == 0;
  const bool byMatrix = random.Index(2) == 0;
  const glm::dvec3 axis = RandomUnit(random);
  const double angle = turned ? random.Uniform(0.0, 180.0) : 0.0;
  const double flat = random.Index(4) ? 1.0 : 0.3;
  const glm::dvec3 stretch(random.Index(4) ? 1.0 : -1.0, flat, 1.0);

  vtkSmartPointer<vtkActor> actor =
    airlight_test::Scene::MakeActor(static_cast<vtkMapper*>(nullptr));
  actor->SetPosition(this->Unit * centre.x, this->Unit * centre.y, this->Unit * centre.z);
  const glm::dvec3 scale = this->Unit * size * stretch;
  actor->SetScale(scale.x, scale.y, scale.z);
  actor->RotateWXYZ(angle, axis.x, axis.y, axis.z);
  if (!byMatrix)
  {
    vtkMatrix4x4* matrix = actor->GetMatrix();
    for (auto& triangle : triangles)
    {
      for (glm::dvec3& corner : triangle)
      {
        corner = airlight_test::TransformPoint(matrix, &corner.x);
      }
    }
    actor->SetPosition(0, 0, 0);
    actor->SetScale(1, 1, 1);
    actor->SetOrientation(0, 0, 0);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  // VTK's mappers shade a mirrored mesh by its normals from behind; without normals they take
  // differences between pixels, in single precision, which are no good where triangles are edge-on.
  const double side = byMatrix && stretch.x < 0.0 ? -1.0 : 1.0;
  mapper->SetInputData(MakeMesh(triangles, side, shared, single));
  actor->SetMapper(mapper);
  this->Scene.Renderer->AddActor(actor);
  this->Text += airlight_test::Text(" ", GetPartName(kind), " (", triangles.size(), ") at ",
    Text3(&centre.x), " size ", size, byMatrix ? " matrix" : "", single ? " single" : "",
    shared ? " shared" : "", " turn ", angle, ",");
}
}
