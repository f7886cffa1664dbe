// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/CheckedOBJ.h"

#include "formats/UserError.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace airlight
{

namespace
{
// Of "v x y z", behind the v.
bool HasThreeNumbers(const char* text)
{
  for (int i = 0; i < 3; ++i)
  {
    char* end = nullptr;
    const double number = std::strtod(text, &end);
    if (end == text || !std::isfinite(static_cast<float>(number))) // as VTK stores it
    {
      return false;
    }
    text = end;
  }
  return true;
}
}

//------------------------------------------------------------------------------
void CheckOBJ(const std::string& fileName)
{
  std::ifstream file(fileName);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number)
  {
    const std::size_t start = line.find_first_not_of(" \t");
    const bool isVertex = start != std::string::npos && line[start] == 'v' &&
      (start + 1 == line.size() || std::isspace(static_cast<unsigned char>(line[start + 1])));
    if (isVertex && !HasThreeNumbers(line.c_str() + start + 1))
    {
      throw UserError(fileName + ":" + std::to_string(number) +
        ": expected three finite numbers of a vertex, as in 'v 1 0 0.5'");
    }
  }
}

}
