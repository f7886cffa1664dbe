// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"

#include "commands/OptionText.h"
#include "commands/SceneOptions.h"
#include "formats/Picture.h"
#include "formats/UserError.h"
#include "scene/ReferencePicture.h"

#include <limits>
#include <memory>

namespace airlight
{

namespace
{
struct RenderOptions
{
  SceneOptions Scene;
  PictureSettings Picture;
  std::string Output;
  std::string Exposure;
  bool Reference = false;
  int Antialiasing = 1;
};

void Render(const RenderOptions& options)
{
  PictureSettings picture = options.Picture;
  if (!options.Exposure.empty())
  {
    picture.Exposure =
      ParseNumber("--exposure", options.Exposure, 0.0, std::numeric_limits<double>::max());
  }
  if (options.Reference)
  {
    ComputeToFile(options.Scene.Load(), picture, options.Output);
    return;
  }
  RenderSettings settings = options.Scene.GetSettings();
  settings.RecordBuffers = NeedsBuffers(picture, options.Output);
  settings.SubpixelFrames = options.Antialiasing;
  if (settings.RecordBuffers && !settings.UseMedium)
  {
    throw UserError("--no-medium has no linear buffers: write a .png, without --exposure");
  }
  RenderedScene scene = BuildScene(options.Scene.Load(), settings);
  RenderToFile(scene, picture, options.Output);
}
}

//------------------------------------------------------------------------------
void AddRenderCommand(CLI::App& program)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Render a scene or a model into a file");
  options->Scene.AddTo(command);
  command
    ->add_option("-o,--output", options->Output,
      "Picture to write: .png holds 8 bits per channel, clamped to 0..1, without gamma; .pfm "
      "(bottom row first) and .tiff hold linear floats")
    ->required();
  CLI::Option* buffer =
    command
      ->add_option("--buffer", options->Picture.Buffer,
        "One of the pass's buffers in place of the picture; a .png clamps it to 0..1")
      ->check(CLI::IsMember(GetBufferNames()));
  command->add_option(
    "--exposure", options->Exposure, "Multiply the linear values by this before they are written");
  CLI::Option* antialiasing =
    command
      ->add_option("--antialiasing", options->Antialiasing,
        "Mean of so many frames, moved by parts of a pixel: smooth edges of surfaces and shadows; "
        "16 are good, 64 very good")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->get_option("--no-medium")->excludes(buffer)->excludes(antialiasing);
  CLI::Option* reference = command->add_flag("--reference", options->Reference,
    "Compute the picture on the CPU in double precision, without a display; slower, and without "
    "--ies and --glow");
  for (const char* name : { "--no-medium", "--technique", "--steps", "--glow", "--antialiasing" })
  {
    reference->excludes(command->get_option(name));
  }
  command->callback([options] { Render(*options); });
}

}
