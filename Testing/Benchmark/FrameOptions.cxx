// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameOptions.h"

#include "FrameRows.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace benchmarks
{
//------------------------------------------------------------------------------
void AddOptions(CLI::App& app, Options& options)
{
  app.add_option("scenes", options.Scenes, "Names, or their part before the slash; all if none");
  app.add_option("--frames", options.Frames, "Frames of each kind")->check(CLI::Range(1, 1000));
  app
    .add_option("--size", options.Size,
      "Width and height of the frames instead of each scene's own, for a quick look; not of sizes/")
    ->expected(2)
    ->check(CLI::Range(16, 8192));
  app.add_option("--markdown", options.Markdown, "File to write the tables to");
  app.add_option("--csv", options.Csv, "File to write the rows to");
  app.add_option("--json", options.Json, "File to write rows, single frames and figures to");
  app.add_flag("--errors", options.Errors,
    "Measure the error of the airlight, too, against vtkAirlightReference at 160 x 120 pixels, and "
    "find the march that reaches 2e-3");
  app.add_flag("--egl", options.Egl, "Draw through EGL, without an X server");
  app.add_flag("--trim", options.Trim,
    "Let malloc() give memory back to the system in between, as programs do by default");
  app.add_flag("--info", options.Info, "Say who draws and stop");
  app.add_flag("--list", options.List, "Name the scenes and stop");
}

//------------------------------------------------------------------------------
std::vector<SceneRecipe> ChooseRecipes(const Options& options)
{
  std::vector<SceneRecipe> chosen = MakeRecipes();
  const auto unwanted = [&](const SceneRecipe& recipe) {
    return !options.Scenes.empty() &&
      std::none_of(options.Scenes.begin(), options.Scenes.end(),
        [&](const std::string& wanted) { return IsOneOf(recipe.Name, wanted); });
  };
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(), unwanted), chosen.end());
  for (SceneRecipe& recipe : chosen)
  {
    if (!options.Size.empty() && !IsOneOf(recipe.Name, "sizes"))
    {
      recipe.Width = options.Size[0];
      recipe.Height = options.Size[1];
    }
  }
  return chosen;
}

//------------------------------------------------------------------------------
std::string FindUnknownScene(const Options& options)
{
  const std::vector<std::string>& names = options.Scenes;
  const std::vector<SceneRecipe> recipes = MakeRecipes();
  const auto unknown = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return std::none_of(recipes.begin(), recipes.end(),
      [&](const SceneRecipe& recipe) { return IsOneOf(recipe.Name, name); });
  });
  return unknown != names.end() ? *unknown : std::string();
}
}
