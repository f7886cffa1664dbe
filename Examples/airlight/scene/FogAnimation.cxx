// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/FogAnimation.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace airlight
{

namespace
{
constexpr double RelativeRadius = 0.08; // of the lamp's circle, by the distance of the view
constexpr double Breath = 0.5;          // largest change of the density
constexpr double Drift = 0.12;          // largest swing of one colour

Vector3 Sum(const Vector3& a, double s, const Vector3& b, double t, const Vector3& c)
{
  Vector3 sum;
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum[i] = a[i] + s * b[i] + t * c[i];
  }
  return sum;
}
}

//------------------------------------------------------------------------------
FogAnimation::FogAnimation(
  const Scene& scene, const RenderedScene& rendered, std::size_t surface, int period)
  : Start(scene)
  , Rendered(rendered)
  , Period(period)
  , Object(scene.Surfaces.at(surface).Actor)
  , Turn(vtkSmartPointer<vtkTransform>::New())
{
  this->Object->SetUserTransform(this->Turn);
  std::copy_n(this->Object->GetCenter(), 3, this->ObjectCenter.begin());
  std::copy_n(scene.Medium->GetScattering(), 3, this->Scattering.begin());
  std::copy_n(scene.Medium->GetAbsorption(), 3, this->Absorption.begin());

  this->Up = scene.Camera.ViewUp;
  vtkMath::Normalize(this->Up.data());
  Vector3 forward;
  vtkMath::Subtract(scene.Camera.FocalPoint.data(), scene.Camera.Position.data(), forward.data());
  const double radius = RelativeRadius * vtkMath::Norm(forward.data());
  vtkMath::Cross(forward.data(), this->Up.data(), this->CircleSide.data());
  vtkMath::Normalize(this->CircleSide.data());
  vtkMath::MultiplyScalar(this->CircleSide.data(), radius);
  vtkMath::Cross(this->Up.data(), this->CircleSide.data(), this->CircleBack.data());
}

//------------------------------------------------------------------------------
void FogAnimation::SetFrame(int frame)
{
  const double phase = 2.0 * vtkMath::Pi() * (frame % this->Period) / this->Period;
  this->MoveLight(phase);
  this->TurnObject(phase);
  this->ChangeMedium(phase);
  this->Rendered.Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void FogAnimation::MoveLight(double phase)
{
  const Vector3 position = Sum(this->Start.Lights[0].Position, std::sin(phase), this->CircleSide,
    1.0 - std::cos(phase), this->CircleBack);
  vtkLight* light = this->Rendered.Lights[0];
  light->SetPosition(position.data());
  const Vector3 target = Sum(position, 1.0, this->Start.Lights[0].Direction, 0.0, position);
  light->SetFocalPoint(target.data());
}

//------------------------------------------------------------------------------
void FogAnimation::TurnObject(double phase)
{
  const Vector3& center = this->ObjectCenter;
  this->Turn->Identity();
  this->Turn->Translate(center.data());
  this->Turn->RotateWXYZ(vtkMath::DegreesFromRadians(phase), this->Up.data());
  this->Turn->Translate(-center[0], -center[1], -center[2]);
}

//------------------------------------------------------------------------------
void FogAnimation::ChangeMedium(double phase)
{
  const double density = 1.0 + Breath * std::sin(phase);
  Vector3 scattering;
  Vector3 absorption;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double shift = 2.0 * vtkMath::Pi() * static_cast<double>(i) / 3.0;
    const double color = 1.0 + Drift * (std::sin(phase + shift) - std::sin(shift));
    scattering[i] = density * color * this->Scattering[i];
    absorption[i] = density * this->Absorption[i];
  }
  this->Start.Medium->SetScattering(scattering.data());
  this->Start.Medium->SetAbsorption(absorption.data());
}

}
