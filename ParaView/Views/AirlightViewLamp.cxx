// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightViewLamp.h"

#include "vtkAirlightLight.h"
#include "vtkBoundingBox.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

namespace airlight
{
namespace
{
// In diagonals of the data from its centre: left, up, away from the first camera.
constexpr double Place[3] = { -0.45, 0.82, -0.1 };

// Radiance of a white surface at the centre that faces the lamp.
constexpr double CentreRadiance = 1.1;
}

//------------------------------------------------------------------------------
ViewLamp::ViewLamp() = default;
ViewLamp::~ViewLamp() = default;

//------------------------------------------------------------------------------
void ViewLamp::Update(vtkRenderer* renderer, const vtkBoundingBox& bounds)
{
  const bool isThere = renderer->GetLights()->IsItemPresent(this->Light) != 0;
  if (!this->On || !bounds.IsValid())
  {
    if (isThere)
    {
      renderer->RemoveLight(this->Light);
    }
    return;
  }
  double center[3];
  bounds.GetCenter(center);
  const double diagonal = bounds.GetDiagonalLength() > 0.0 ? bounds.GetDiagonalLength() : 1.0;
  double position[3];
  double intensity[3];
  const double distance = diagonal * vtkMath::Norm(Place);
  for (int i = 0; i < 3; ++i)
  {
    position[i] = center[i] + diagonal * Place[i];
    intensity[i] =
      CentreRadiance * vtkMath::Pi() * distance * distance * this->Brightness * this->Color[i];
  }
  this->Light->SetLightTypeToSceneLight();
  this->Light->SetPosition(position);
  this->Light->SetFocalPoint(center);
  vtkAirlightLight::SetRadiantIntensity(this->Light, intensity);
  vtkAirlightLight::SetRadius(this->Light, this->Radius);
  vtkAirlightLight::SetVisible(this->Light, this->Visible && this->Radius > 0.0);
  if (!isThere)
  {
    renderer->AddLight(this->Light);
  }
}
}
