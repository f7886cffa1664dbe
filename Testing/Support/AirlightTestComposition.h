// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small scene for vtkAirlightPass together with VTK's other passes.
 */

#ifndef AirlightTestComposition_h
#define AirlightTestComposition_h

#include "AirlightTestScene.h"

#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
// A ball and a box on a floor, a lamp above them and light from the front. Nothing is overexposed,
// since VTK's passes cut at 1 what they keep in 8 bits and the pass does not.
class Composition : public Scene
{
public:
  explicit Composition(int width = 160, int height = 120)
    : Scene(width, height)
  {
    this->Renderer->SetBackground(0.05, 0.08, 0.12);
    this->Renderer->SetBackgroundAlpha(1.0);
    this->Renderer->SetPass(nullptr);
    this->ReleasesPass = true;
    vtkNew<vtkPlaneSource> floor;
    floor->SetOrigin(-8.0, -1.0, 6.0);
    floor->SetPoint1(8.0, -1.0, 6.0);
    floor->SetPoint2(-8.0, -1.0, -12.0);
    this->Floor = this->Add(floor);
    this->Ball = this->Add(MakeSphere(1.0), [](vtkActor* a) { a->SetPosition(-1.2, 0.0, 0.0); });
    this->Ball->GetProperty()->SetColor(0.9, 0.4, 0.2);
    vtkNew<vtkCubeSource> cube;
    this->Box = this->Add(cube, [](vtkActor* a) { a->SetPosition(1.4, -0.5, -2.0); });
    this->Box->GetProperty()->SetColor(0.3, 0.6, 0.9);
    this->Lamp = this->AddPointLight({ 1.0, 3.5, 1.0 }, { 40.0, 35.0, 26.0 });
    this->Sun = this->AddDirectionalLight({ 0.3, 0.5, 1.0 }, glm::dvec3(1.5));
    this->Pass->SetLightScatters(this->Sun, false);
    this->Look({ 0.0, 1.5, 10.0 }, { 0.0, 0.0, 0.0 });
    this->Renderer->GetActiveCamera()->SetViewAngle(30.0);
    this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 40.0);
  }

  void SetClear()
  {
    this->Medium->SetScattering(0.0, 0.0, 0.0);
    this->Medium->SetAbsorption(0.0, 0.0, 0.0);
    this->Pass->SurfaceShadowsOff();
  }

  void SetFoggy()
  {
    this->Medium->SetScattering(0.05, 0.07, 0.1);
    this->Medium->SetAbsorption(0.02, 0.02, 0.01);
    this->Pass->SurfaceShadowsOn();
  }

  vtkActor* AddTranslucentBall()
  {
    vtkActor* ball = this->Add(MakeSphere(0.7), [](vtkActor* a) { a->SetPosition(1.2, 0.3, 1.5); });
    ball->GetProperty()->SetColor(0.6, 0.6, 0.1);
    ball->GetProperty()->SetOpacity(0.4);
    return ball;
  }

  vtkActor* Floor;
  vtkActor* Ball;
  vtkActor* Box;
  vtkLight* Lamp;
  vtkLight* Sun;
};
}

#endif
