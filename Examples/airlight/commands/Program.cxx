// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Program.h"

#include "formats/UserError.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace airlight
{

//------------------------------------------------------------------------------
int RunProgram(const char* name, const char* description,
  const std::function<void(CLI::App&)>& setUp, int argc, char** argv)
{
  try
  {
    CLI::App program(description, name);
    setUp(program);
    try
    {
      program.parse(argc, argv);
    }
    catch (const CLI::ParseError& error) // also stands for --help and --version
    {
      return program.exit(error) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
  }
  catch (const UserError& error)
  {
    std::cerr << name << ": " << error.what() << std::endl;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << name << ": out of memory" << std::endl;
  }
  catch (const std::exception& error)
  {
    std::cerr << name << ": internal error: " << error.what() << std::endl;
  }
  return EXIT_FAILURE;
}

}
