// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Orbit.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkTransform.h>

namespace airlight
{

//------------------------------------------------------------------------------
Orbit::Orbit(const Scene& scene, const RenderedScene& rendered, int period)
  : Start(scene)
  , Rendered(rendered)
  , Period(period)
{
}

//------------------------------------------------------------------------------
void Orbit::SetFrame(int frame)
{
  const CameraSettings& start = this->Start.Camera;
  const Vector3& center = start.FocalPoint;
  vtkNew<vtkTransform> turn;
  turn->Translate(center.data());
  turn->RotateWXYZ(360.0 * (frame % this->Period) / this->Period, start.GetUp().data());
  turn->Translate(-center[0], -center[1], -center[2]);
  Vector3 position;
  turn->TransformPoint(start.Position.data(), position.data());
  vtkCamera* camera = this->Rendered.Renderer->GetActiveCamera();
  camera->SetPosition(position.data());
  if (start.Vertical)
  {
    Vector3 up;
    turn->TransformVector(start.ViewUp.data(), up.data());
    camera->SetViewUp(up.data());
  }
  double bounds[6];
  if (this->Start.GetBounds(bounds))
  {
    this->Rendered.Renderer->ResetCameraClippingRange(bounds);
  }
}

//------------------------------------------------------------------------------
void Orbit::KeepExposure()
{
  auto* pass = vtkAirlightPass::SafeDownCast(this->Rendered.Renderer->GetPass());
  if (pass && pass->GetAutomaticExposure())
  {
    pass->SetExposure(pass->GetEffectiveExposure());
    pass->AutomaticExposureOff();
  }
}

}
