// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Times whole frames of the pass, all techniques of a scene interleaved at random in one process,
// against the plain VTK frame of the same scene. Only ratios within one run mean anything: the
// milliseconds are this machine's, and of what else it did meanwhile.

#include "FrameScene.h"
#include "RatioReporter.h"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>

namespace
{
using benchmarks::FrameScene;
using benchmarks::SceneRecipe;
using benchmarks::Way;

struct Options
{
  std::vector<std::string> Scenes;
  int Frames = 9;
  std::string Markdown;
  std::string Csv;
  bool List = false;
  bool Errors = false;
};

void Register(const SceneRecipe& recipe, const std::shared_ptr<FrameScene>& scene, int frames,
  const std::map<std::string, double>& errors)
{
  const auto triangles = static_cast<double>(scene->CountTriangles());
  for (const Way& way : recipe.Ways)
  {
    const auto error = errors.find(way.Name);
    const bool hasError = error != errors.end();
    const double errorValue = hasError ? error->second : 0.0;
    benchmark::RegisterBenchmark((recipe.Name + "|" + way.Name).c_str(),
      [=](benchmark::State& state) {
        for (auto iteration : state)
        {
          static_cast<void>(iteration);
          const benchmarks::FrameTime time = scene->Time(way);
          state.SetIterationTime(time.Clock);
          state.counters["processor"] = time.Processor;
        }
        state.counters["triangles"] = triangles;
        state.counters["width"] = recipe.Width;
        state.counters["height"] = recipe.Height;
        if (hasError)
        {
          state.counters["error"] = errorValue;
        }
      })
      ->UseManualTime()
      ->Iterations(1)
      ->Repetitions(frames);
  }
}

// Whether a scene was asked for: by its name, or by what is before the slash.
bool IsWanted(const Options& options, const std::string& name)
{
  return options.Scenes.empty() ||
    std::any_of(options.Scenes.begin(), options.Scenes.end(), [&](const std::string& wanted) {
      return name == wanted || name.compare(0, wanted.size() + 1, wanted + "/") == 0;
    });
}

bool Write(const std::string& path, const std::string& text)
{
  if (path.empty())
  {
    return true;
  }
  std::ofstream file(path);
  file << text;
  if (!file.flush())
  {
    std::cerr << "error: cannot write " << path << "\n";
    return false;
  }
  return true;
}

int Run(const Options& options)
{
  benchmarks::RatioReporter reporter;
  int count = 0;
  for (const SceneRecipe& recipe : benchmarks::MakeRecipes())
  {
    if (options.List)
    {
      std::cout << recipe.Name << "\n";
    }
    else if (IsWanted(options, recipe.Name))
    {
      ++count;
      std::cerr << recipe.Name << " ...\n";
      const auto scene = std::make_shared<FrameScene>(recipe.Width, recipe.Height);
      recipe.Fill(*scene);
      std::map<std::string, double> errors;
      if (options.Errors)
      {
        errors = scene->MeasureErrors(recipe.Ways); // before the camera turns
      }
      Register(recipe, scene, options.Frames, errors);
      benchmark::RunSpecifiedBenchmarks(&reporter);
      benchmark::ClearRegisteredBenchmarks();
    }
  }
  if (options.List)
  {
    return EXIT_SUCCESS;
  }
  if (count == 0)
  {
    std::cerr << "error: no such scene; see --list\n";
    return EXIT_FAILURE;
  }
  std::cout << reporter.GetMarkdown();
  return Write(options.Markdown, reporter.GetMarkdown()) && Write(options.Csv, reporter.GetCsv())
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("Times frames in a medium against plain VTK frames of the same scenes");
  app.add_option("scenes", options.Scenes, "Names, or their part before the slash; all if none");
  app.add_option("--frames", options.Frames, "Frames of each kind")->check(CLI::Range(1, 1000));
  app.add_option("--markdown", options.Markdown, "File to write the tables to");
  app.add_option("--csv", options.Csv, "File to write the figures to");
  app.add_flag("--errors", options.Errors,
    "Measure the error of the airlight, too, against vtkAirlightReference at 160 x 120 pixels");
  app.add_flag("--list", options.List, "Name the scenes and stop");
  CLI11_PARSE(app, argc, argv);

  // One after another in random order, a frame each.
  std::string name = argv[0];
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* flags[] = { &name[0], &interleave[0], nullptr };
  int count = 2;
  benchmark::Initialize(&count, flags);
  return Run(options);
}
