// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program `AnimatedFog` moves a light, an object and the medium of a scene at once. It writes
 * numbered pictures or shows a window. See FogAnimation.
 *
 *   AnimatedFog figure1.json --frames 240 -o frame_%04d.png
 *   AnimatedFog figure1.json --frame 60 -o frame60.png
 *   AnimatedFog figure1.json --live
 */

#include "commands/OptionText.h"
#include "commands/Program.h"
#include "commands/Progress.h"
#include "formats/Picture.h"
#include "formats/UserError.h"
#include "scene/FogAnimation.h"
#include "scene/ModelScene.h"

#include <vtkCallbackCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

using namespace airlight;

namespace
{
struct AnimationOptions
{
  std::string SceneFile;
  std::string Output;
  std::string Size;
  int Frames = 0;
  int Frame = -1;
  int Period = 240;
  int Surface = -1;
  bool Live = false;
};

std::size_t ChooseSurface(const Scene& scene, int wanted)
{
  const auto count = scene.Surfaces.size();
  if (wanted >= 0 && static_cast<std::size_t>(wanted) < count)
  {
    return static_cast<std::size_t>(wanted);
  }
  if (wanted >= 0 || count == 0)
  {
    throw UserError(scene.FileName + ": has no surface " + std::to_string(std::max(0, wanted)) +
      "; it has " + std::to_string(count));
  }
  const auto cow =
    std::find_if(scene.Surfaces.begin(), scene.Surfaces.end(), [](const Surface& surface) {
      return std::filesystem::path(surface.Name).filename().string().find("cow") !=
        std::string::npos;
    });
  return cow == scene.Surfaces.end() ? 0 : static_cast<std::size_t>(cow - scene.Surfaces.begin());
}

void WriteFrames(const AnimationOptions& options, FogAnimation& animation, RenderedScene& rendered)
{
  const bool single = options.Frame >= 0;
  const int first = single ? options.Frame : 0;
  const int count = single ? 1 : options.Frames;
  Progress progress(count);
  for (int i = 0; i < count; ++i)
  {
    const bool numbered = !single || options.Output.find('%') != std::string::npos;
    const std::string file =
      numbered ? NumberFile("--output", options.Output, first + i) : options.Output;
    animation.SetFrame(first + i);
    RenderToFile(rendered, PictureSettings(), file);
    if (!single)
    {
      progress.Show(i + 1);
    }
  }
}

struct LiveState
{
  FogAnimation* Animation = nullptr;
  vtkRenderWindow* Window = nullptr;
  int Frame = 0;
};

void ShowNextFrame(vtkObject*, unsigned long, void* clientData, void*)
{
  auto* state = static_cast<LiveState*>(clientData);
  state->Animation->SetFrame(state->Frame++);
  state->Window->Render();
}

void ShowLive(FogAnimation& animation, RenderedScene& rendered)
{
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(rendered.Window);
  interactor->Initialize();
  LiveState state{ &animation, rendered.Window, 0 };
  vtkNew<vtkCallbackCommand> timer;
  timer->SetCallback(ShowNextFrame);
  timer->SetClientData(&state);
  interactor->AddObserver(vtkCommand::TimerEvent, timer);
  interactor->CreateRepeatingTimer(16);
  interactor->Start();
}

void Run(const AnimationOptions& options)
{
  if (!options.Live)
  {
    if (options.Output.empty() || (options.Frames < 1 && options.Frame < 0))
    {
      throw UserError("give --live, or --output with --frames N or --frame K");
    }
    if (options.Frame < 0)
    {
      NumberFile("--output", options.Output, 0);
    }
  }
  Scene scene = ReadSceneOrModel(options.SceneFile);
  if (!options.Size.empty())
  {
    std::tie(scene.Width, scene.Height) = ParseSize("--size", options.Size);
  }
  if (scene.Lights.empty())
  {
    throw UserError(scene.FileName + ": has no lamp to move");
  }
  const std::size_t surface = ChooseSurface(scene, options.Surface);
  RenderSettings settings;
  settings.OffScreen = !options.Live;
  settings.RecordBuffers = !options.Live && NeedsBuffers(PictureSettings(), options.Output);
  settings.SubpixelFrames = options.Live || settings.RecordBuffers ? 1 : PictureFrames;
  if (!options.Live)
  {
    settings.ShadowTechnique = vtkAirlightPass::SHADOW_PLANES; // the same in all frames of a film
  }
  RenderedScene rendered = BuildScene(scene, settings);
  FogAnimation animation(scene, rendered, surface, options.Period);
  if (options.Live)
  {
    ShowLive(animation, rendered);
  }
  else
  {
    WriteFrames(options, animation, rendered);
  }
}

void SetUp(CLI::App& program)
{
  auto shared = std::make_shared<AnimationOptions>(); // lives until the callback has run
  AnimationOptions& options = *shared;
  program.add_option("SCENE", options.SceneFile, "Scene (.json) or model")->required();
  program.add_option("-o,--output", options.Output,
    "Pictures to write, with %d or %04d for the number of the frame");
  CLI::Option* frames =
    program.add_option("--frames", options.Frames, "Write this many frames, from 0 on")
      ->check(CLI::Range(1, 1000000));
  CLI::Option* frame = program.add_option("--frame", options.Frame, "Write this one frame")
                         ->check(CLI::Range(0, 1000000));
  CLI::Option* live = program.add_flag("--live", options.Live, "Show it in a window");
  program.add_option("--period", options.Period, "Frames after which everything repeats")
    ->check(CLI::Range(2, 1000000))
    ->capture_default_str();
  program
    .add_option("--surface", options.Surface,
      "Number of the surface that turns, from 0 on; by default the one whose file is named cow, "
      "or else the first")
    ->check(CLI::Range(0, 1000000));
  program.add_option("--size", options.Size, "Size of the picture, WxH pixels");
  frames->excludes(frame)->excludes(live);
  frame->excludes(live);
  program.callback([shared] { Run(*shared); });
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  return RunProgram(
    "AnimatedFog", "A lamp, an object and a medium in motion at once", SetUp, argc, argv);
}
