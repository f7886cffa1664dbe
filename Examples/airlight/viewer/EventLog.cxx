// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/EventLog.h"

#include "formats/Files.h"
#include "formats/UserError.h"

#include <vtkCommand.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace airlight
{

namespace
{
// Before 1.1 there are other columns. VTK 9.1 writes 1.1, VTK 9.3 1.2, with columns at the end for
// files that are dropped on the window.
const char* const Versions[] = { "# StreamVersion 1.1", "# StreamVersion 1.2" };

void CheckEvent(const std::string& line, const std::string& place)
{
  std::istringstream words(line);
  std::string event;
  words >> event;
  if (vtkCommand::GetEventIdFromString(event.c_str()) == vtkCommand::NoEvent)
  {
    throw UserError(place + ": '" + event + "' is not the name of an event");
  }
  int number = 0;
  for (int i = 0; i < 5; ++i)
  {
    words >> number;
  }
  std::string key;
  words >> key;
  if (!words)
  {
    throw UserError(place +
      ": expected after the event x, y, modifiers, key code, repeat count and the key's name");
  }
}
}

//------------------------------------------------------------------------------
std::string ReadEventLog(const std::string& fileName)
{
  std::istringstream lines(ReadTextFile(fileName));
  std::string line;
  std::getline(lines, line);
  if (std::find(std::begin(Versions), std::end(Versions), line) == std::end(Versions))
  {
    throw UserError(
      fileName + ": is no log of events: its first line is not '" + Versions[0] + "' or 1.2");
  }
  std::string log = line + "\n";
  for (int number = 2; std::getline(lines, line); ++number)
  {
    if (line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#')
    {
      CheckEvent(line, fileName + ": line " + std::to_string(number));
      log += line + "\n";
    }
  }
  return log; // without empty lines, at which VTK repeats the event before
}

}
