// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small window with a light, and a plane that ends rays and is lit. It does not shadow them: shadows
 * have their own tests.
 */

#ifndef AirlightTestPlaneScene_h
#define AirlightTestPlaneScene_h

#include "AirlightTestPixels.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

namespace airlight_test
{
class PlaneScene : public PixelScene
{
public:
  // The plane is tilted, through the middle of scenes around the origin.
  PlaneScene()
  {
    this->Plane->SetOrigin(-2.0, -3.0, -1.0);
    this->Plane->SetPoint1(1.5, -2.5, 0.5);
    this->Plane->SetPoint2(-1.0, 2.0, -0.5);
    this->Mapper->SetInputConnection(this->Plane->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->AddLight(this->Light);
    this->Pass->SetShadowTechniqueToNone();
  }

  vtkNew<vtkLight> Light;
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkActor> Actor;

private:
  vtkNew<vtkPolyDataMapper> Mapper;
};
}

#endif
