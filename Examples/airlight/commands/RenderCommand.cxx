// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"

#include "commands/DisplayOptions.h"
#include "commands/OptionText.h"
#include "commands/PathOptions.h"
#include "commands/Progress.h"
#include "commands/SceneOptions.h"
#include "formats/ImageFile.h"
#include "formats/Picture.h"
#include "formats/UserError.h"
#include "scene/Orbit.h"
#include "scene/ReferencePicture.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace airlight
{

namespace
{
struct RenderOptions
{
  SceneOptions Scene;
  DisplayOptions Display;
  PictureSettings Picture;
  std::string Output;
  bool Reference = false;
  PathOptions Paths;
  int Antialiasing = 0;
  bool Multisampling = false;
  int Orbit = 0;
};

void RenderOrbit(const RenderOptions& options, const Scene& scene, RenderedScene& rendered,
  const PictureSettings& picture)
{
  for (int i = 0; i < options.Orbit; ++i) // before the first picture
  {
    CheckImageFile(NumberFile("--output", options.Output, i));
  }
  Orbit orbit(scene, rendered, options.Orbit);
  Progress progress(options.Orbit);
  progress.Show(0);
  for (int i = 0; i < options.Orbit; ++i)
  {
    orbit.SetFrame(i);
    RenderToFile(rendered, picture, NumberFile("--output", options.Output, i));
    orbit.KeepExposure();
    progress.Show(i + 1);
  }
}

std::vector<std::string> GetKnownBuffers()
{
  std::vector<std::string> names = GetBufferNames();
  names.emplace_back(StandardErrorBuffer);
  return names;
}

void Render(const RenderOptions& options)
{
  if (options.Picture.Buffer == StandardErrorBuffer && !options.Reference)
  {
    throw UserError("--buffer StandardError is of pictures by --reference --orders: add them");
  }
  PictureSettings picture = options.Picture;
  const bool buffers = NeedsBuffers(
    picture, options.Orbit > 0 ? NumberFile("--output", options.Output, 0) : options.Output);
  if (buffers || options.Reference)
  {
    picture.Exposure = options.Display.GetFactor();
  }
  if (options.Reference)
  {
    Progress progress(100);
    const PathChoices paths = options.Paths.GetSettings();
    const auto show = [&](double done) { progress.Show(static_cast<int>(100.0 * done)); };
    ComputeToFile(options.Scene.Load(), picture, paths, options.Output,
      paths.Orders == 1 ? std::function<void(double)>() : show);
    return;
  }
  RenderSettings settings = options.Scene.GetSettings();
  settings.RecordBuffers = buffers;
  if (!buffers)
  {
    settings.SubpixelFrames = PictureFrames;
    settings.Display = options.Display.GetSettings();
  }
  else if (!settings.UseMedium)
  {
    throw UserError("--no-medium has no linear buffers: write a .png");
  }
  settings.Multisampling = options.Multisampling;
  if (options.Multisampling)
  {
    settings.SubpixelFrames = 1;
  }
  if (options.Antialiasing > 0)
  {
    settings.SubpixelFrames = options.Antialiasing;
  }
  const Scene scene = options.Scene.Load();
  WarnOfPoints(scene, settings, settings.SubpixelFrames);
  RenderedScene rendered = BuildScene(scene, settings);
  if (options.Orbit > 0)
  {
    RenderOrbit(options, scene, rendered, picture);
    return;
  }
  RenderToFile(rendered, picture, options.Output);
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
      "Picture to write: .png holds 8 bits per channel, as screens show them; .pfm (bottom row "
      "first), .tiff and .exr hold linear floats, as buffers and --reference do, which a .png "
      "clamps to 0..1")
    ->required();
  CLI::Option* buffer =
    command
      ->add_option("--buffer", options->Picture.Buffer,
        "One of the pass's buffers in place of the picture, or with --orders StandardError; a .png "
        "clamps it to 0..1")
      ->check(CLI::IsMember(GetKnownBuffers()));
  options->Display.AddTo(command);
  command
    ->add_option("--antialiasing", options->Antialiasing,
      "Mean of so many frames, moved by parts of a pixel: smooth edges of surfaces and shadows; "
      "16 are good, 64 very good (default 16; linear floats and buffers 1)")
    ->check(CLI::Range(1, 1024));
  command
    ->add_flag("--multisampling", options->Multisampling,
      "Four samples of pixels at edges in place of --antialiasing: less smooth, the time of about "
      "two frames")
    ->excludes(command->get_option("--antialiasing"));
  command
    ->add_option("--orbit", options->Orbit,
      "Write so many pictures, for a turntable: the camera goes once around the point it looks at, "
      "and lamps stay. --output has %d or %03d for the number, from 0. The automatic exposure of "
      "the first picture is that of all")
    ->check(CLI::Range(1, 100000));
  command->get_option("--no-medium")->excludes(buffer);
  CLI::Option* reference = command->add_flag("--reference", options->Reference,
    "Compute the picture on the CPU in double precision, without a display; slower, mostly with "
    "lamps of an extent (256 points each) and --ies, and without --glow and --lamp-visible");
  options->Paths.AddTo(command, reference);
  for (const char* name : { "--no-medium", "--technique", "--steps", "--glow", "--antialiasing",
         "--multisampling", "--tone-mapping", "--color-space", "--no-dithering", "--orbit" })
  {
    reference->excludes(command->get_option(name));
  }
  command->callback([options] { Render(*options); });
}

}
