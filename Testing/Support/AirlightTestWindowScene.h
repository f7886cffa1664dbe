// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of windows share: a scene that can be drawn anywhere, windows, and comparisons of
 * parts of pictures.
 */

#ifndef AirlightTestWindowScene_h
#define AirlightTestWindowScene_h

#include "AirlightTestScene.h"

#include "vtkCubeSource.h"

namespace airlight_test
{
// Two bodies over a floor in the light of up to two lamps, in fog that leaves the background
// visible beside it.
class WindowScene : public Scene
{
public:
  explicit WindowScene(int width = 120, int height = 90, int lamps = 1)
    : Scene(width, height)
  {
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Floor = this->Add(floor);
    this->Ball = this->Add(MakeSphere(1.0), [](vtkActor* a) { a->SetPosition(-1.2, 0, 0); });
    vtkNew<vtkCubeSource> cube;
    this->Cube = this->Add(cube, [](vtkActor* a) { a->SetPosition(1.6, -0.4, 0.5); });
    this->AddPointLight({ 3, 4, 2 });
    if (lamps > 1)
    {
      this->AddPointLight({ -3, 3, 1 }, { 5, 10, 20 });
    }
    this->Medium->SetRegionToBox();
    this->Medium->SetBounds(-7, 7, -3, 5, -7, 7);
  }

  vtkActor* Floor;
  vtkActor* Ball;
  vtkActor* Cube;
};

inline vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

// Takes the scene's renderer into a part of another window.
inline void Place(Scene& scene, vtkRenderWindow* window, double x0, double y0, double x1, double y1)
{
  scene.Window->RemoveRenderer(scene.Renderer);
  window->AddRenderer(scene.Renderer);
  scene.Renderer->SetViewport(x0, y0, x1, y1);
}
}

#endif
