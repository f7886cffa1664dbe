// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLampShapes.h"

#include "Integration/AirlightMatrix.h"
#include "Photometry/AirlightLightProperties.h"
#include "Scene/AirlightLampSamples.h"
#include "Scene/AirlightSceneLights.h"
#include "vtkAirlightLight.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr int Sides = 64; // of what is round

enum class LampKind
{
  Ball,
  Disc,
  Rectangle
};

// A lamp in the coordinates of its light, which the light's matrix takes into the world.
struct Lamp
{
  LampKind Kind = LampKind::Ball;
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Axis{ 0.0, 0.0, 1.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  glm::dvec2 Size{ 0.0 }; // of half of it for what is round

  double GetArea() const
  {
    return this->Size.x * this->Size.y * (this->Kind == LampKind::Rectangle ? 1.0 : vtkMath::Pi());
  }
};

bool IsShownLamp(vtkLight* light)
{
  return light->GetSwitch() && light->GetPositional() && light->LightTypeIsSceneLight() &&
    GetProperties(light).Visible;
}

Lamp GetLamp(vtkLight* light)
{
  const LightProperties& properties = GetProperties(light);
  Lamp lamp;
  light->GetPosition(&lamp.Position.x);
  lamp.Size = glm::dvec2(properties.Extent.Radius);
  const glm::dvec3 axis = GetLampAxis(light);
  if (axis != glm::dvec3(0.0))
  {
    const bool flat = properties.Extent.Size != glm::dvec2(0.0);
    lamp.Kind = flat ? LampKind::Rectangle : LampKind::Disc;
    lamp.Size = flat ? properties.Extent.Size : lamp.Size;
    lamp.Axis = axis;
    lamp.Up = MakeAcross(properties.PhotometryUp, lamp.Axis);
  }
  return lamp;
}

glm::dmat4 GetToWorld(vtkLight* light)
{
  vtkMatrix4x4* matrix = light->GetTransformMatrix();
  return matrix ? ToGlm(matrix) : glm::dmat4(1.0);
}

// Of size 1, about the origin, across the z axis.
vtkSmartPointer<vtkPolyDataAlgorithm> MakeShape(LampKind kind)
{
  if (kind == LampKind::Rectangle)
  {
    return vtkSmartPointer<vtkPlaneSource>::New(); // from -0.5 to 0.5
  }
  if (kind == LampKind::Disc)
  {
    auto disc = vtkSmartPointer<vtkRegularPolygonSource>::New();
    disc->SetNumberOfSides(Sides);
    disc->SetRadius(1.0);
    disc->GeneratePolylineOff();
    return disc;
  }
  auto ball = vtkSmartPointer<vtkSphereSource>::New();
  ball->SetRadius(1.0);
  ball->SetThetaResolution(Sides);
  ball->SetPhiResolution(Sides / 2);
  return ball;
}

// What of the intensity a spotlight sends to the eye, 0 outside its cone.
double GetShare(vtkLight* light, const Lamp& lamp, const glm::dvec3& eye)
{
  if (!(light->GetConeAngle() < 90.0))
  {
    return 1.0;
  }
  const double cosine = glm::dot(glm::normalize(eye - lamp.Position), lamp.Axis);
  return cosine >= std::cos(glm::radians(light->GetConeAngle()))
    ? std::pow(cosine, light->GetExponent())
    : 0.0;
}

bool Contains(const Lamp& lamp, const glm::dvec3& point)
{
  return lamp.Kind == LampKind::Ball && glm::length(point - lamp.Position) <= lamp.Size.x;
}

glm::dmat4 GetPlace(const Lamp& lamp)
{
  const double depth = lamp.Kind == LampKind::Ball ? lamp.Size.x : 1.0;
  return { glm::dvec4(lamp.Size.x * glm::cross(lamp.Up, lamp.Axis), 0.0),
    glm::dvec4(lamp.Size.y * lamp.Up, 0.0), glm::dvec4(depth * lamp.Axis, 0.0),
    glm::dvec4(lamp.Position, 1.0) };
}

vtkSmartPointer<vtkActor> MakeActor()
{
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkMatrix4x4> matrix;
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetUserMatrix(matrix);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Changes nothing that is as it was, by which a picture at rest is recognized.
void UpdateActor(
  vtkActor* actor, const Lamp& lamp, const glm::dmat4& toWorld, const glm::dvec3& radiance)
{
  const char* names[] = { "vtkSphereSource", "vtkRegularPolygonSource", "vtkPlaneSource" };
  vtkMapper* mapper = actor->GetMapper();
  vtkAlgorithm* before = mapper->GetInputAlgorithm();
  if (!before || !before->IsA(names[static_cast<int>(lamp.Kind)]))
  {
    mapper->SetInputConnection(MakeShape(lamp.Kind)->GetOutputPort());
  }
  const glm::dmat4 place = toWorld * GetPlace(lamp);
  for (int i = 0; i < 16; ++i)
  {
    actor->GetUserMatrix()->SetElement(i % 4, i / 4, place[i / 4][i % 4]);
  }
  actor->GetProperty()->SetColor(radiance.x, radiance.y, radiance.z);
}
}

//------------------------------------------------------------------------------
const std::vector<vtkProp*>& LampShapes::Update(vtkRenderer* renderer, bool linear)
{
  this->Props.clear();
  this->Range = glm::dvec2(0.0);
  std::map<vtkLight*, vtkSmartPointer<vtkActor>> used;
  glm::dvec3 eye;
  renderer->GetActiveCamera()->GetPosition(&eye.x);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it = nullptr;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    const Lamp lamp = GetLamp(light);
    if (!IsShownLamp(light) || !(lamp.GetArea() > 0.0) || used.count(light) > 0)
    {
      continue;
    }
    const glm::dmat4 toWorld = GetToWorld(light);
    const glm::dvec3 from = glm::inverse(toWorld) * glm::dvec4(eye, 1.0);
    const double share = GetShare(light, lamp, from);
    if (!(share > 0.0) || Contains(lamp, from))
    {
      continue;
    }
    glm::dvec3 radiance;
    vtkAirlightLight::GetRadiantIntensity(light, &radiance.x);
    radiance *= share / lamp.GetArea();
    vtkSmartPointer<vtkActor>& actor = used[light];
    actor = this->Actors.count(light) > 0 ? this->Actors[light] : MakeActor();
    UpdateActor(
      actor, lamp, toWorld, linear ? radiance : glm::pow(radiance, glm::dvec3(1.0 / 2.2)));
    this->Props.push_back(actor);
    this->AddToRange(renderer->GetActiveCamera(), actor);
  }
  this->Actors.swap(used);
  return this->Props;
}

//------------------------------------------------------------------------------
void LampShapes::AddToRange(vtkCamera* camera, vtkActor* actor)
{
  glm::dvec3 eye;
  glm::dvec3 view;
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&view.x);
  const double* center = actor->GetCenter();
  const double distance = glm::dot(glm::dvec3(center[0], center[1], center[2]) - eye, view);
  const double radius = 0.5 * actor->GetLength();             // half of its box's diagonal
  const bool parallel = camera->GetParallelProjection() != 0; // may see what is behind its position
  if ((parallel || distance + radius > 0.0) && std::isfinite(distance + radius))
  {
    const double nearest = parallel ? distance - radius : std::max(distance - radius, 0.0);
    const glm::dvec2 range(nearest, distance + radius);
    const bool first = !(this->Range.x < this->Range.y);
    this->Range.x = first ? range.x : std::min(this->Range.x, range.x);
    this->Range.y = first ? range.y : std::max(this->Range.y, range.y);
  }
}

//------------------------------------------------------------------------------
void LampShapes::Release(vtkWindow* window)
{
  for (const auto& actor : this->Actors)
  {
    actor.second->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
bool IsInvisiblePoint(vtkLight* light)
{
  return IsShownLamp(light) && !(GetLamp(light).GetArea() > 0.0);
}
}
