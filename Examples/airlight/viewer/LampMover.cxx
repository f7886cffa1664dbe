// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/LampMover.h"

#include "formats/Vector3.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <cmath>

namespace airlight
{

namespace
{
constexpr double TurnPerHeight = 180.0; // degrees, of a directional light

// The picture's axes, of unit length: to the right, up, and into the scene.
struct PictureAxes
{
  explicit PictureAxes(vtkCamera* camera)
  {
    camera->GetDirectionOfProjection(this->Forward.data());
    vtkMath::Cross(this->Forward.data(), camera->GetViewUp(), this->Right.data());
    vtkMath::Normalize(this->Right.data());
    vtkMath::Cross(this->Right.data(), this->Forward.data(), this->Up.data());
  }

  Vector3 Right;
  Vector3 Up;
  Vector3 Forward;
};

Vector3 Difference(const double a[3], const double b[3])
{
  Vector3 difference;
  vtkMath::Subtract(a, b, difference.data());
  return difference;
}

void Translate(vtkLight* lamp, const Vector3& step)
{
  Vector3 position;
  Vector3 target;
  vtkMath::Add(lamp->GetPosition(), step.data(), position.data());
  vtkMath::Add(lamp->GetFocalPoint(), step.data(), target.data());
  lamp->SetPosition(position.data());
  lamp->SetFocalPoint(target.data());
}

// The height of what the picture shows in the lamp's plane.
double GetHeight(vtkCamera* camera, vtkLight* lamp, const Vector3& forward)
{
  if (camera->GetParallelProjection())
  {
    return 2.0 * camera->GetParallelScale();
  }
  const Vector3 way = Difference(lamp->GetPosition(), camera->GetPosition());
  double depth = vtkMath::Dot(way.data(), forward.data());
  if (depth <= 0.0)
  {
    depth = camera->GetDistance();
  }
  return 2.0 * depth * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
}
}

//------------------------------------------------------------------------------
void MoveLamp(vtkRenderer* renderer, vtkLight* lamp, double right, double up)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const PictureAxes axes(camera);
  if (lamp->GetPositional())
  {
    const double height = GetHeight(camera, lamp, axes.Forward);
    Vector3 step;
    for (std::size_t i = 0; i < 3; ++i)
    {
      step[i] = height * (right * axes.Right[i] + up * axes.Up[i]);
    }
    Translate(lamp, step);
    return;
  }
  const Vector3 way = Difference(lamp->GetPosition(), lamp->GetFocalPoint());
  vtkNew<vtkTransform> turn;
  turn->Translate(lamp->GetFocalPoint());
  turn->RotateWXYZ(TurnPerHeight * right, axes.Up.data());
  turn->RotateWXYZ(-TurnPerHeight * up, axes.Right.data());
  Vector3 position;
  turn->TransformPoint(way.data(), position.data());
  lamp->SetPosition(position.data());
}

//------------------------------------------------------------------------------
void PushLamp(vtkRenderer* renderer, vtkLight* lamp, double factor)
{
  if (lamp->GetPositional())
  {
    Vector3 step = Difference(lamp->GetPosition(), renderer->GetActiveCamera()->GetPosition());
    vtkMath::MultiplyScalar(step.data(), factor - 1.0);
    Translate(lamp, step);
  }
}

}
