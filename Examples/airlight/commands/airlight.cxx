// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The program `airlight`: renders scenes and models in fog, smoke, dust or water, shows them, and
 * compares pictures. `airlight --help` and `airlight COMMAND --help` are its manual.
 */

#include "commands/Commands.h"
#include "commands/Program.h"

namespace
{
void SetUp(CLI::App& program)
{
  program.set_version_flag("--version", AIRLIGHT_VERSION);
  program.require_subcommand(1);
  airlight::AddRenderCommand(program);
  airlight::AddViewCommand(program);
  airlight::AddCompareCommand(program);
  airlight::AddMontageCommand(program);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  return airlight::RunProgram(
    "airlight", "Light in participating media, and its volumetric shadows", SetUp, argc, argv);
}
