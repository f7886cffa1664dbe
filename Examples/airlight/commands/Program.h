// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Program_h
#define Program_h

#include <CLI/CLI.hpp>

#include <functional>

namespace airlight
{

/**
 * A command-line program: `setUp` adds options and callbacks to it, then the command line is
 * parsed, which runs the callbacks. Returns the exit code: 0, or 1 after a message on the error
 * stream that begins with the program's name.
 */
int RunProgram(const char* name, const char* description,
  const std::function<void(CLI::App&)>& setUp, int argc, char** argv);

}

#endif
