// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"

#include "commands/DisplayOptions.h"
#include "commands/OptionText.h"
#include "commands/SceneOptions.h"
#include "viewer/Viewer.h"

#include <memory>

namespace airlight
{

namespace
{
constexpr double LongestFrame = 1e6; // ms

struct ViewOptions
{
  SceneOptions Scene;
  DisplayOptions Display;
  ViewerSettings Viewer;
  bool Multisampling = false;
};

void View(const ViewOptions& options)
{
  RenderSettings settings = options.Scene.GetSettings();
  settings.OffScreen = false;
  settings.Multisampling = options.Multisampling;
  settings.Display = options.Display.GetSettings();
  const Scene scene = options.Scene.Load();
  WarnOfPoints(scene, settings, options.Viewer.Frames);
  Viewer viewer(scene, settings, options.Viewer);
  viewer.Run();
}
}

//------------------------------------------------------------------------------
void AddViewCommand(CLI::App& program)
{
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = program.add_subcommand("view", "Show a scene or a model in a window");
  options->Scene.AddTo(command);
  options->Display.AddTo(command);
  ViewerSettings& viewer = options->Viewer;
  command
    ->add_option("--screenshots", viewer.Screenshots,
      "Files that the key s writes (.png), with %d or %03d for a number; those that exist stay")
    ->capture_default_str();
  command->add_option("--record", viewer.Record, "Write what keys and mouse do into this file");
  command->add_option("--play", viewer.Play,
    "Do first what this file says: one of --record, or of VTK's vtkInteractorEventRecorder");
  command
    ->add_option_function<std::string>(
      "--frame-time",
      [&viewer](const std::string& text) {
        viewer.FrameTime = ParseNumber("--frame-time", text, 0.0, LongestFrame);
      },
      "Milliseconds that a frame may take while mouse or keys move something, before fewer pixels "
      "and no shadows are drawn; 0 for no limit")
    ->type_name("FLOAT in [0 - 1e+06]")
    ->default_str(std::to_string(static_cast<int>(viewer.FrameTime)));
  command
    ->add_option("--antialiasing", viewer.Frames,
      "Mean of so many frames at rest, drawn one after the other: smooth edges of surfaces and "
      "shadows, and lamps of finite size; --play and --record draw single frames")
    ->check(CLI::Range(1, 1024))
    ->capture_default_str();
  command->add_flag("--multisampling", options->Multisampling,
    "Four samples of pixels at edges in single frames, as while mouse or keys move something; such "
    "frames take about twice as long");
  command->footer(command->get_footer() + "\n\nIn the window:\n" + Viewer::GetKeys());
  command->callback([options] { View(*options); });
}

}
