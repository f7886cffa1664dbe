// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Load and determinism: see AirlightLoad --help. Ends with 1 where a check fails.

#include "LoadTools.h"

#include <CLI/CLI.hpp>

#include <functional>

using namespace airlightload;

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("What vtkAirlightPass does under load, and whether it does the same every time");
  app.require_subcommand(1);
  std::function<void()> run;
  const auto add = [&](const char* name, const char* text, const std::function<void()>& action) {
    CLI::App* command = app.add_subcommand(name, text);
    command->callback([&run, action] { run = action; });
    command->add_option("--size", options.Size, "Width and height of the window")
      ->expected(2)
      ->check(CLI::Range(16, 8192));
    return command;
  };
  CLI::App* frames =
    add("frames", "Frames in which everything moves: memory stays", [&] { RunFrames(options); });
  frames->add_option("--frames", options.Frames, "How many")->check(CLI::Range(10, 10000000));
  frames->add_flag("--plain", options.Plain, "Without the pass, for comparison");
  add("lights", "Lights in one place are one light", [&] { RunLights(options); })
    ->add_option("--count", options.Lights, "How many")
    ->check(CLI::Range(1, 1000));
  add("actors", "Actors are one actor", [&] { RunActors(options); })
    ->add_option("--count", options.Actors, "How many")
    ->check(CLI::Range(1, 1000000));
  add("triangles", "A fine ball has a coarser one's shadow", [&] { RunTriangles(options); })
    ->add_option("--count", options.Triangles, "How many")
    ->check(CLI::Range(1e4, 1e8));
  CLI::App* tiles =
    add("tiles", "Tiles make the picture of a large window", [&] { RunTiles(options); });
  tiles->add_option("--scale", options.Scale, "Tiles in a row and in a column");
  tiles->add_option("--output", options.Scene, "PNG file to write");
  add("digests", "A number for the bytes of each scene", [&] {
    RunDigests(options);
  })->add_option("--scene", options.Scene, "This one only");
  add("processes", "The same bytes in other processes, on more threads", [&] {
    RunProcesses(options, argv[0]);
  })->add_option("--scene", options.Scene, "This one only");
  CLI11_PARSE(app, argc, argv);
  run();
  return airlight_test::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
