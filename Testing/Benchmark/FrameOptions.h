// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameOptions_h
#define FrameOptions_h

#include "FrameScene.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace benchmarks
{
struct Options
{
  std::vector<std::string> Scenes;
  int Frames = 9;
  std::vector<int> Size; // none, or width and height
  std::string Markdown;
  std::string Csv;
  std::string Json;
  bool List = false;
  bool Info = false;
  bool Errors = false;
  bool Egl = false;
  bool Trim = false;
};

void AddOptions(CLI::App& app, Options& options);

// The requested recipes, of the requested size.
std::vector<SceneRecipe> ChooseRecipes(const Options& options);

// The first name that is no scene's; empty if there is none.
std::string FindUnknownScene(const Options& options);
}

#endif
