// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestWindowScene.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

//------------------------------------------------------------------------------
void Place(Scene& scene, vtkRenderWindow* window, double x0, double y0, double x1, double y1)
{
  scene.Window->RemoveRenderer(scene.Renderer);
  window->AddRenderer(scene.Renderer);
  scene.Renderer->SetViewport(x0, y0, x1, y1);
}
}
