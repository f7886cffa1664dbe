// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "UserError.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace airlight
{

//------------------------------------------------------------------------------
int RunProgram(CLI::App& program, int argc, char** argv)
{
  const std::string name = program.get_name() + ": ";
  try
  {
    program.parse(argc, argv);
    return EXIT_SUCCESS;
  }
  catch (const CLI::ParseError& error) // also stands for --help and --version
  {
    return program.exit(error) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const UserError& error)
  {
    std::cerr << name << error.what() << std::endl;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << name << "out of memory" << std::endl;
  }
  catch (const std::exception& error)
  {
    std::cerr << name << "internal error: " << error.what() << std::endl;
  }
  return EXIT_FAILURE;
}

}
