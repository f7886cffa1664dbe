// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The commands of the program `airlight`, one source file each. Every function adds its command to
 * the program; the command runs as CLI11 meets it and throws UserError.
 */

#ifndef Commands_h
#define Commands_h

#include <CLI/CLI.hpp>

namespace airlight
{

void AddRenderCommand(CLI::App& program);
void AddViewCommand(CLI::App& program);
void AddCompareCommand(CLI::App& program);
void AddMontageCommand(CLI::App& program);

}

#endif
