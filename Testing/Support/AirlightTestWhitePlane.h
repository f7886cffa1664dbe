// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small window with a white plane that lights shine on.
 */

#ifndef AirlightTestWhitePlane_h
#define AirlightTestWhitePlane_h

#include "AirlightTestPixels.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace airlight_test
{
// A white diffuse plane z = 0, seen from z > 0.
class WhitePlane
{
public:
  WhitePlane()
  {
    this->Source->SetOrigin(-20.0, -20.0, 0.0);
    this->Source->SetPoint1(20.0, -20.0, 0.0);
    this->Source->SetPoint2(-20.0, 20.0, 0.0);
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->Actor->GetProperty()->SetDiffuse(1.0);
    this->Actor->GetProperty()->SetAmbient(0.0);
    this->Actor->GetProperty()->SetSpecular(0.0);
    this->Scene.Renderer->AddActor(this->Actor);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(1.0, -3.0, 5.0);
    camera->SetFocalPoint(0.2, 0.5, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.3);
  }

  void Render()
  {
    this->Scene.Renderer->ResetCameraClippingRange();
    this->Scene.Window->Render();
  }

  PixelScene Scene;
  vtkNew<vtkPlaneSource> Source;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};
}

#endif
