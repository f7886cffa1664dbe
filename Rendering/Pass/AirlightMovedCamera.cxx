// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightMovedCamera.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

namespace airlight
{
//------------------------------------------------------------------------------
// A matrix of the camera's own ignores the window's centre.
MovedCamera::MovedCamera(vtkCamera* camera, const glm::dvec2& offset, const glm::dvec2& size)
  : Camera(camera)
{
  this->Camera->GetWindowCenter(this->Center);
  const glm::dvec2 moved = 2.0 * offset / size;
  this->Camera->SetWindowCenter(this->Center[0] + moved.x, this->Center[1] + moved.y);
  if (!camera->GetUseExplicitProjectionTransformMatrix())
  {
    return;
  }
  this->Projection = camera->GetExplicitProjectionTransformMatrix();
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(this->Projection);
  for (int row = 0; row < 2; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      const double w = this->Projection->GetElement(3, column);
      projection->SetElement(
        row, column, this->Projection->GetElement(row, column) - moved[row] * w);
    }
  }
  camera->SetExplicitProjectionTransformMatrix(projection);
}

//------------------------------------------------------------------------------
MovedCamera::~MovedCamera()
{
  this->Camera->SetWindowCenter(this->Center[0], this->Center[1]);
  if (this->Projection)
  {
    this->Camera->SetExplicitProjectionTransformMatrix(this->Projection);
  }
}
}
