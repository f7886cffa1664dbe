// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "SceneOptions.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <memory>

namespace airlight
{

namespace
{
void View(const SceneOptions& options)
{
  RenderSettings settings = options.GetSettings();
  settings.OffScreen = false;
  RenderedScene scene = BuildScene(options.Load(), settings);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(scene.Window);
  scene.Render();
  interactor->Start();
}
}

//------------------------------------------------------------------------------
void AddViewCommand(CLI::App& program)
{
  auto options = std::make_shared<SceneOptions>();
  CLI::App* command = program.add_subcommand("view",
    "Show a scene or a model in a window: drag to turn, with Shift to move, wheel to zoom, q to "
    "quit");
  options->AddTo(command);
  command->callback([options] { View(*options); });
}

}
