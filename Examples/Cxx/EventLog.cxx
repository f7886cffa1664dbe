// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EventLog.h"

#include "Files.h"
#include "UserError.h"

#include <vtkCommand.h>

#include <sstream>

namespace airlight
{

namespace
{
const char* const FirstLine = "# StreamVersion 1.1"; // without it VTK reads other columns

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
  const std::string text = ReadTextFile(fileName);
  if (text.compare(0, std::string(FirstLine).size(), FirstLine) != 0)
  {
    throw UserError(fileName + ": is no log of events: its first line is not '" + FirstLine + "'");
  }
  std::istringstream lines(text);
  std::string line;
  std::string log = std::string(FirstLine) + "\n";
  for (int number = 1; std::getline(lines, line); ++number)
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
