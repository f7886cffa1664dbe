// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Scene.h"

#include <vtkBoundingBox.h>
#include <vtkMath.h>

namespace airlight
{

namespace
{
constexpr double SmallestTilt = 1e-3; // radians between the way up and the view
}

//------------------------------------------------------------------------------
Vector3 CameraSettings::GetUp() const
{
  if (!this->Vertical)
  {
    return this->ViewUp;
  }
  Vector3 forward;
  Vector3 right;
  vtkMath::Subtract(this->FocalPoint.data(), this->Position.data(), forward.data());
  vtkMath::Normalize(forward.data());
  vtkMath::Cross(forward.data(), this->Vertical->data(), right.data());
  return vtkMath::Norm(right.data()) > SmallestTilt ? *this->Vertical : this->ViewUp;
}

//------------------------------------------------------------------------------
bool Scene::GetBounds(double bounds[6]) const
{
  vtkBoundingBox box;
  for (const Surface& surface : this->Surfaces)
  {
    box.AddBounds(surface.Actor->GetBounds());
  }
  if (!box.IsValid())
  {
    return false;
  }
  box.GetBounds(bounds);
  return true;
}

}
