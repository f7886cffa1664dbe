// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Program_h
#define Program_h

#include <CLI/CLI.hpp>

namespace airlight
{

/**
 * Parse the command line, which runs the program's callbacks, and return the exit code: 0, or 1
 * with a message on the error stream that begins with the program's name.
 */
int RunProgram(CLI::App& program, int argc, char** argv);

}

#endif
