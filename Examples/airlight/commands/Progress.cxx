// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Progress.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace airlight
{

namespace
{
std::string FormatTime(double seconds)
{
  const long whole = std::lround(seconds);
  std::ostringstream text;
  text << whole / 60 << ':' << std::setw(2) << std::setfill('0') << whole % 60;
  return text.str();
}
}

//------------------------------------------------------------------------------
Progress::Progress(int all)
  : All(all)
  , Visible(isatty(STDERR_FILENO) == 1)
  , Start(std::chrono::steady_clock::now())
{
}

//------------------------------------------------------------------------------
Progress::~Progress()
{
  if (this->Open)
  {
    std::cerr << std::endl;
  }
}

//------------------------------------------------------------------------------
void Progress::Show(int done)
{
  if (!this->Visible)
  {
    return;
  }
  constexpr long long Width = 40;
  const auto filled = static_cast<std::size_t>(Width * done / this->All);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Start;
  std::ostringstream text;
  text << "\r[" << std::string(filled, '#') << std::string(Width - filled, '.') << "] " << done
       << '/' << this->All;
  if (done == this->All)
  {
    text << " in " << FormatTime(passed.count()) << "          \n"; // over what was there
  }
  else if (done > 0)
  {
    text << ", " << FormatTime(passed.count() / done * (this->All - done)) << " left   ";
  }
  this->Open = done < this->All;
  std::cerr << text.str() << std::flush;
}

}
