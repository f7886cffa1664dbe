// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Bad photometric files: each is refused with an error that names the file, the line and the
// culprit.

#include "AirlightTestCheck.h"
#include "AirlightTestPhotometry.h"

#include <cstdlib>
#include <fstream>

using namespace airlight;
using namespace airlight_test;

namespace
{
bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// The first line of these files is line 1.
using Lines = std::vector<std::string>;

const Lines TypeC = { "IESNA:LM-63-2002", "[TEST] made up", "TILT=NONE", "1 1000 1 3 2",
  "1 2 0.1 0.1 0", "1 1 40", "0 45 90", "0 90", "100 90 80", "70 60 50" };

const Lines TypeB = { "IES:LM-63-2019", "[TEST] made up", "TILT=INCLUDE", "1 2", "0 90", "1 0.5",
  "1 1000 1 2 3 2 2 0.1 0.1 0", "1 1 40", "-30 30", "-45 0 45", "1 2", "3 4", "5 6" };

const Lines Old = { "a lamp", "made up", "TILT=lamp.tlt", "1 1000 1 2 1 1 1 0 0 0", "1 0.5 40",
  "0 180", "0", "12 13" };

std::string Whole(const Lines& lines, const std::string& end = "\n")
{
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + end;
  }
  return text;
}

struct BadFile
{
  const Lines* Base;
  size_t Replaced; // this line of the base ...
  std::string By;  // ... is replaced by this, which may be several
  size_t Line;     // where the error is
  std::string Culprit;
};

void CheckRefused(const std::string& file, const std::string& start, const std::string& culprit)
{
  std::string error;
  const bool refused = !Photometry::Read(file, error);
  Check(refused, "accepted although " + culprit);
  Check(
    error.rfind(start + ": ", 0) == 0 && Contains(error, culprit) && Contains(error, "expected"),
    "error '" + error + "' instead of " + start + ": ..." + culprit + "...");
}

void CheckBad(const std::string& file, const BadFile& bad)
{
  Lines lines = *bad.Base;
  lines[bad.Replaced - 1] = bad.By;
  std::ofstream(file, std::ios::binary) << Whole(lines);
  CheckRefused(file, file + ":" + std::to_string(bad.Line), bad.Culprit);
}

//------------------------------------------------------------------------------
void TestStructure(const std::string& file)
{
  const BadFile files[] = { { &TypeC, 3, "[OTHER] no tilt", 10, "no line TILT=" },
    { &TypeC, 3, "TILT=", 3, "TILT=''" }, { &TypeC, 3, "TILT=INCLUD", 3, "TILT='INCLUD'" },
    { &TypeC, 3, "TILT NONE", 10, "no line TILT=" },
    { &TypeC, 3, "TILT=INCLUDE", 10, "tilt angle 23 of 1000" },
    { &TypeB, 4, "4 2", 4, "lamp-to-luminaire geometry is 4" },
    { &TypeB, 4, "1 0", 4, "number of tilt angles is 0" },
    { &TypeB, 4, "1 1e9", 4, "number of tilt angles is 1000000000" },
    { &TypeB, 5, "0 x", 5, "'x' is no finite number; expected the tilt angle 2 of 2" },
    { &TypeB, 6, "1 nan", 6, "'nan' is no finite number; expected the tilt factor 2 of 2" },
    { &TypeC, 10, "70 60", 10, "candela value 6 of 6" },
    { &TypeC, 10, "", 10, "candela value 4 of 6" },
    { &TypeC, 10, "70 60 50 40", 10, "'40' after the last candela value" },
    { &TypeC, 10, "70 60 50\n\n[END]", 12, "'[END]' after the last candela value" },
    { &TypeC, 9, std::string("100 90\0 80", 10), 9, "byte of value 0" },
    { &TypeC, 2, "[TEST] \x01", 2, "byte of value 1 " },
    { &TypeC, 1,
      "\x7f"
      "ELF",
      1, "byte of value 127" },
    { &TypeC, 2, std::string(1000001, 'a'), 2, "1000001 characters" },
    { &TypeC, 9, "100 90 " + std::string(5000, '8') + "x", 9, "'8888" } };
  for (const BadFile& bad : files)
  {
    CheckBad(file, bad);
  }
}

//------------------------------------------------------------------------------
void TestNumbers(const std::string& file)
{
  const BadFile files[] = { { &TypeC, 4, "0 1000 1 3 2", 4, "number of lamps is 0" },
    { &TypeC, 4, "1 -2 1 3 2", 4, "lumens per lamp is -2" },
    { &TypeC, 4, "1 1000 0 3 2", 4, "candela multiplier is 0" },
    { &TypeC, 4, "1 1000 -1 3 2", 4, "candela multiplier is -1" },
    { &TypeC, 4, "1 1000 1 0 2", 4, "number of vertical angles is 0" },
    { &TypeC, 4, "1 1000 1 2.5 2", 4, "number of vertical angles is 2.5" },
    { &TypeC, 4, "1 1000 1 3 -2", 4, "number of horizontal angles is -2" },
    { &TypeC, 4, "1 1000 1 1e300 2", 4, "number of vertical angles is 1e+300" },
    { &TypeC, 4, "1 1000 1 5000 5000", 4, "5000 and 5000" },
    { &TypeC, 4, "1 1000 1 3 2 inf", 4,
      "'inf' is no finite number; expected the photometric type" },
    { &TypeC, 5, "4 2 0.1 0.1 0", 5, "photometric type is 4" },
    { &TypeC, 5, "1 3 0.1 0.1 0", 5, "type of units is 3" },
    { &TypeC, 5, "1 2 0.1 0,1m 0", 5, "'1m' is no finite number; expected the height" },
    { &TypeC, 6, "0 1 40", 6, "ballast factor is 0" },
    { &TypeC, 6, "1 1e999 40", 6,
      "'1e999' is no finite number; expected the number for future use" },
    { &TypeC, 6, "1 1 -40", 6, "input watts is -40" },
    { &Old, 5, "1 0 40", 5, "ballast-lamp photometric factor is 0" },
    { &TypeC, 9, "100 -90 80", 9, "candela value 2 of 6 is -90" },
    { &TypeC, 9, "100 90 1..5", 9,
      "'1..5' is no finite number; expected the candela value 3 of 6" },
    { &TypeC, 9, "100 0x10 80", 9,
      "'0x10' is no finite number; expected the candela value 2 of 6" },
    { &TypeC, 9, "0 0 0\n0 0 0\n", 10, "largest candela value is 0" },
    { &Old, 8, "0 0", 8, "largest candela value is 0" },
    { &Old, 4, "1 1000 1e10 2 1 1 1 0 0 0\n1 1 40\n0 180\n0\n1e305 1", 8,
      "candela value 1 of 2 is 1e+305" } };
  for (const BadFile& bad : files)
  {
    CheckBad(file, bad);
  }
}

//------------------------------------------------------------------------------
void TestAngles(const std::string& file)
{
  const BadFile files[] = { { &TypeC, 7, "0 90 45", 7, "vertical angle 3 of 3 is 45" },
    { &TypeC, 7, "0 45 45", 7, "vertical angle 3 of 3 is 45" },
    { &TypeC, 7, "0 1e-320 90", 7, "vertical angle 2 of 3 is" },
    { &TypeC, 7, "10 45 90", 7, "vertical angles go from 10 to 90" },
    { &TypeC, 7, "0 45 80", 7, "vertical angles go from 0 to 80" },
    { &TypeC, 7, "-90 45 90", 7, "vertical angles go from -90 to 90" },
    { &TypeC, 7, "0 45 270", 7, "vertical angles go from 0 to 270" },
    { &TypeC, 7, "0 45 east", 7, "'east' is no finite number; expected the vertical angle 3 of 3" },
    { &TypeC, 8, "0 45", 8, "horizontal angles go from 0 to 45" },
    { &TypeC, 8, "0 361", 8, "horizontal angles go from 0 to 361" },
    { &TypeC, 8, "0 135", 8, "horizontal angles go from 0 to 135" },
    { &TypeC, 8, "10 90", 8, "horizontal angles go from 10 to 90" },
    { &TypeC, 8, "90 180", 8, "horizontal angles go from 90 to 180" },
    { &TypeC, 8, "90 0", 8, "horizontal angle 2 of 2 is 0" },
    { &Old, 7, "5", 7, "horizontal angles go from 5 to 5" },
    { &Old, 4, "1 1000 1 1 1 1 1 0 0 0", 5, "number of vertical angles is 1" },
    { &TypeB, 9, "-91 30", 9, "vertical angle 1 of 2 is -91" },
    { &TypeB, 9, "30 -30", 9, "vertical angle 2 of 2 is -30" },
    { &TypeB, 10, "-45 0 91", 10, "horizontal angle 3 of 3 is 91" },
    { &TypeB, 7, "1 1000 1 2 1 3 2 0.1 0.1 0", 9,
      "number of horizontal angles of type A or B is 1" } };
  for (const BadFile& bad : files)
  {
    CheckBad(file, bad);
  }
}

//------------------------------------------------------------------------------
// What is no file, no text or no end.
void TestUnreadable(const std::string& file, const std::string& folder)
{
  CheckRefused(folder + "no-such-file.ies", folder + "no-such-file.ies", "cannot be read");
  CheckRefused(folder, folder, "cannot be read");
  const auto write = [&](
                       const std::string& text) { std::ofstream(file, std::ios::binary) << text; };
  write("");
  CheckRefused(file, file + ":1", "no line TILT=");
  write(std::string(MaximumPhotometricText + 1, '\n'));
  CheckRefused(file, file + ":1", "longer than 33554432 bytes");
  std::string rubbish = "\x89PNG\r\n";
  Random random(1);
  for (int i = 0; i < 100000; ++i)
  {
    rubbish += static_cast<char>(random.Index(256));
  }
  write(rubbish);
  CheckRefused(file, file + ":2", "expected text");
  // Errors do not carry a terminal's escapes or long tokens along.
  write("TILT=\xe9" + std::string(300, 'a'));
  CheckRefused(file, file + ":1", "TILT='?aaa");
  std::string error;
  Photometry::Read(file, error);
  Check(error.size() < file.size() + 200, "a long token makes a long error");
}
}

//------------------------------------------------------------------------------
int TestPhotometryErrors(int argc, char* argv[])
{
  const std::string file = GetTemporaryFile(argc, argv, "TestPhotometryErrors.ies");
  for (const Lines& good : { TypeC, TypeB, Old })
  {
    std::string error;
    Check(Photometry::Parse(Whole(good), "good", error) != nullptr, error);
  }
  TestStructure(file);
  TestNumbers(file);
  TestAngles(file);
  TestUnreadable(file, GetTemporaryFile(argc, argv, ""));
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
