// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Times whole frames of the pass, all techniques of a scene, or of scenes that are compared, interleaved
// at random in one process, against the plain VTK frame of the same scene. Only ratios within one run
// mean anything: the milliseconds are this machine's, and of what else it did meanwhile.

#include "FrameChanges.h"
#include "FrameContent.h"
#include "FrameErrors.h"
#include "FrameOptions.h"
#include "FrameOutput.h"
#include "FrameRows.h"
#include "FrameScene.h"
#include "FrameWindow.h"
#include "KeepMemory.h"
#include "vtkVersion.h"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace
{
using benchmarks::FrameScene;
using benchmarks::Options;
using benchmarks::Row;
using benchmarks::Rows;
using benchmarks::SceneRecipe;
using benchmarks::Way;

//------------------------------------------------------------------------------
// Finds the steps of ways that are to reach an error, which takes Errors; those that cannot are
// dropped.
void FindSteps(benchmarks::FrameErrors* errors, std::vector<Way>& ways)
{
  for (Way& way : ways)
  {
    if (way.Target > 0.0 && errors)
    {
      way.Steps = errors->FindSteps(way.Target);
      if (way.Steps == 0)
      {
        std::cerr << "warning: " << way.Name << " takes more steps than there can be\n";
      }
    }
  }
  const auto lacksSteps = [](const Way& way) { return way.Target > 0.0 && way.Steps == 0; };
  ways.erase(std::remove_if(ways.begin(), ways.end(), lacksSteps), ways.end());
}

// Rows with what is known before the frames, errors included if there is a reference.
void MakeRows(
  const SceneRecipe& recipe, FrameScene& scene, benchmarks::FrameErrors* errors, Rows& rows)
{
  const auto triangles = static_cast<double>(scene.CountTriangles());
  const auto edges = static_cast<double>(scene.CountSilhouetteEdges());
  for (const Way& way : recipe.Ways)
  {
    Row& row = rows.Get(recipe.Name, way.Name);
    row.Counters = { { "width", recipe.Width }, { "height", recipe.Height },
      { "triangles", triangles }, { "edges", edges } };
    if (way.Steps > 0)
    {
      row.Counters["steps"] = way.Steps;
    }
    if (way.Target > 0.0)
    {
      row.Counters["target"] = way.Target;
    }
    if (errors && !way.Plain)
    {
      row.Counters["error"] = errors->Measure(way);
    }
  }
}

// A scene that waits for its frames to be timed.
struct ReadyScene
{
  SceneRecipe Recipe;
  std::unique_ptr<FrameScene> Scene;
  std::unique_ptr<FrameScene> Base; // in the same window, if any
};

// Frames that take long are fewer: one takes as much as two for each repetition.
constexpr double MostSeconds = 20.0;

int ChooseRepetitions(FrameScene& scene, const Way& way, int frames)
{
  const double each = 2.0 * scene.Time(way).Clock;
  return std::clamp(static_cast<int>(MostSeconds / std::max(each, 1e-6)), 1, frames);
}

//------------------------------------------------------------------------------
void AddFrames(const SceneRecipe& recipe, FrameScene& scene, const std::string& prefix, int frames)
{
  for (const Way& way : recipe.Ways)
  {
    benchmark::RegisterBenchmark((recipe.Name + "|" + prefix + way.Name).c_str(),
      [&scene, way](benchmark::State& state) {
        for (auto iteration : state)
        {
          static_cast<void>(iteration);
          const benchmarks::FrameTime time = scene.Time(way);
          state.SetIterationTime(time.Clock);
          state.counters["processor"] = time.Processor;
          if (!scene.IsDrawnAs(way))
          {
            state.SkipWithError("another technique was drawn"); // times of something else
            break;
          }
        }
      })
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(recipe.Base ? ChooseRepetitions(scene, way, frames) : frames);
  }
}

// The frames of all of them in turn.
void TimeFrames(const std::vector<ReadyScene>& scenes, int frames, Rows& rows)
{
  for (const ReadyScene& ready : scenes)
  {
    AddFrames(ready.Recipe, *ready.Scene, "", frames);
    if (ready.Base)
    {
      AddFrames(ready.Recipe, *ready.Base, ready.Recipe.BaseName, frames);
    }
  }
  benchmarks::RowReporter reporter(rows);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();
}

ReadyScene MakeScene(
  SceneRecipe recipe, const benchmarks::WindowMaker& windows, const Options& options, Rows& rows)
{
  std::cerr << recipe.Name << " ...\n";
  const vtkSmartPointer<vtkRenderWindow> window = windows.Make(recipe.Width, recipe.Height);
  auto scene = std::make_unique<FrameScene>(window);
  recipe.Fill(*scene);
  std::unique_ptr<benchmarks::FrameErrors> errors; // before the camera turns
  if (options.Errors)
  {
    using Exact = benchmarks::FrameErrors::Exact;
    errors = std::make_unique<benchmarks::FrameErrors>(
      *scene, recipe.BaseName == benchmarks::BallAndFloor ? Exact::Planes : Exact::Reference);
  }
  FindSteps(errors.get(), recipe.Ways);
  MakeRows(recipe, *scene, errors.get(), rows);
  std::unique_ptr<FrameScene> base;
  if (recipe.Base)
  {
    base = std::make_unique<FrameScene>(window);
    recipe.Base(*base);
  }
  return { std::move(recipe), std::move(scene), std::move(base) };
}

// Scenes that are timed together, lest the machine's speed changes between them.
std::vector<std::vector<SceneRecipe>> GroupRecipes(const Options& options)
{
  std::vector<std::vector<SceneRecipe>> groups;
  for (const SceneRecipe& recipe : benchmarks::ChooseRecipes(options))
  {
    const bool joins = recipe.Group != benchmarks::SceneGroup::None && !groups.empty() &&
      groups.back().front().Group == recipe.Group;
    if (!joins)
    {
      groups.emplace_back();
    }
    groups.back().push_back(recipe);
  }
  return groups;
}

void RunScenes(const std::vector<SceneRecipe>& recipes, const benchmarks::WindowMaker& windows,
  const Options& options, Rows& rows)
{
  if (recipes.front().Change)
  {
    std::cerr << recipes.front().Name << " ...\n";
    benchmarks::TimeChange(recipes.front(), windows, std::min(options.Frames, 3), rows);
    return;
  }
  std::vector<ReadyScene> scenes;
  scenes.reserve(recipes.size());
  for (const SceneRecipe& recipe : recipes)
  {
    scenes.push_back(MakeScene(recipe, windows, options, rows));
  }
  TimeFrames(scenes, options.Frames, rows);
}

//------------------------------------------------------------------------------
double GetLoad()
{
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? load : 0.0;
}

void Write(const std::string& path, const std::string& text)
{
  if (!path.empty())
  {
    std::ofstream file(path);
    file << text;
    if (!file.flush())
    {
      throw std::runtime_error("cannot write " + path);
    }
  }
}

// Before anything is measured, which may take an hour.
void CheckWritable(const std::string& path)
{
  if (!path.empty() && !std::ofstream(path, std::ios::app))
  {
    throw std::runtime_error("cannot write " + path);
  }
}

void PrintInfo(const benchmarks::OpenGLNames& names)
{
  std::cout << "vendor: " << names.Vendor << "\nrenderer: " << names.Renderer
            << "\nversion: " << names.Version << "\nsoftware: " << (names.IsSoftware ? "yes" : "no")
            << "\n";
}

int Run(const Options& options)
{
  const benchmarks::WindowMaker windows(options.Egl);
  benchmarks::Machine machine;
  machine.OpenGL = benchmarks::GetOpenGLNames(windows.Make(64, 64));
  machine.VTKVersion = vtkVersion::GetVTKVersion();
  machine.Processors = std::thread::hardware_concurrency();
  machine.LoadBefore = GetLoad();
  if (options.Info)
  {
    PrintInfo(machine.OpenGL);
    return EXIT_SUCCESS;
  }
  for (const std::string& path : { options.Markdown, options.Csv, options.Json })
  {
    CheckWritable(path);
  }
  Rows rows;
  const benchmarks::FrameOutput output(machine, rows);
  for (const std::vector<SceneRecipe>& recipes : GroupRecipes(options))
  {
    RunScenes(recipes, windows, options, rows);
    // cppcheck-suppress unreadVariable // the output refers to it
    machine.LoadAfter = GetLoad();
    Write(options.Markdown, output.GetMarkdown()); // after each, lest all be lost with one
    Write(options.Csv, output.GetCsv());
    Write(options.Json, output.GetJson());
  }
  std::cout << output.GetMarkdown();
  return EXIT_SUCCESS;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Times frames in a medium against plain VTK frames of the same scenes");
  benchmarks::AddOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  if (options.List)
  {
    for (const SceneRecipe& recipe : benchmarks::MakeRecipes())
    {
      std::cout << recipe.Name << "\n";
    }
    return EXIT_SUCCESS;
  }
  const std::string unknown = benchmarks::FindUnknownScene(options);
  if (!unknown.empty())
  {
    std::cerr << "error: no scene is called '" << unknown << "'; --list names them\n";
    return EXIT_FAILURE;
  }

  if (!options.Trim)
  {
    benchmarks::KeepMemory();
  }
  benchmarks::KeepNoShaders();
  // One after another in random order, a frame each.
  std::string name = argv[0];
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* flags[] = { &name[0], &interleave[0], nullptr };
  int count = 2;
  benchmark::Initialize(&count, flags);
  try
  {
    return Run(options);
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
